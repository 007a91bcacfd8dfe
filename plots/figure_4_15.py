"""Keppler 2006, figure 4.15: friction against velocity by four laws, on a point pushed to and fro."""

import style
from style import BLUE, GREY, plt
from table import Table

PANELS = ("Stribeck", "Stribeck, viscous", "Karnopp", "tanh")


def main():
    options = style.arguments(__doc__, len(PANELS))
    figure, axes = plt.subplots(2, 2, sharex=True, sharey=True, figsize=(style.COLUMN, 3.3))
    for path, panel, title in zip(options.input, axes.flat, PANELS):
        table = Table(path)
        normal_force = table.number("normal force", " N")
        panel.axhline(0, color=GREY, linewidth=0.6)
        panel.axvline(0, color=GREY, linewidth=0.6)
        panel.plot(table["v_m_per_s"], table["friction_N"] / normal_force, color=BLUE)
        panel.set_title(title)
        panel.set_xlim(-0.22, 0.22)
        panel.set_ylim(-1.05, 1.05)
    axes[1, 0].text(0.035, 0.82, "its band", va="center")
    figure.supxlabel(r"velocity $\Delta v$ [m/s]", fontsize=9)
    figure.supylabel(r"friction $R_F / F_N$ [-]", fontsize=9)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
