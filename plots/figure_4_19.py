"""Keppler 2006, figure 4.19 (Example 4.7): a block slides to rest, then rings on its bristle."""

import numpy as np

import style
from style import BLACK, BLUE, GREEN, GREY, RED, plt
from table import Table


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    t = table["t_s"]
    panels = (("x_m", "$x$ [m]", BLACK), ("v_m_per_s", "$v$ [m/s]", BLUE), ("deflection_m", r"deflection $-\kappa$ [m]", GREEN),
              ("friction_N", "$R_F$ [N]", RED))
    figure, axes = plt.subplots(len(panels), sharex=True, figsize=(style.COLUMN, 5))
    stop = t[np.argmax(table["v_m_per_s"] <= 0)]
    for panel, (name, label, colour) in zip(axes, panels):
        panel.axhline(0, color=GREY, linewidth=0.6)
        panel.axvline(stop, color=GREY, linewidth=0.8, linestyle=":")
        panel.plot(t, table[name], color=colour)
        panel.set_ylabel(label)
    for middle, word in ((stop / 2, "slides"), ((stop + t[-1]) / 2, "sticks, and rings")):
        axes[0].text(middle, 1.03, word, ha="center", va="bottom", transform=axes[0].get_xaxis_transform())
    limits = table.number("Stribeck in the mean, mu(v) =") * table.number("normal force", " N")
    axes[3].axhline(-limits, color=GREY, linewidth=0.8, linestyle="--")
    axes[3].text(t[-1], -limits, r"$-\mu_{Gl} F_N$", ha="right", va="bottom", color=GREY)
    axes[3].set_xlabel("$t$ [s]")
    axes[3].set_xlim(0, t[-1])
    figure.align_ylabels()
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
