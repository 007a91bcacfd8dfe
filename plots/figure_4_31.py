"""Keppler 2006, figure 4.31: place, speed and friction of the body of figure 4.30 over time, by four laws."""

import style
from style import BLACK, BLUE, GREEN, GREY, ORANGE, plt
from table import Table

LAWS = (("elastoplastic", BLACK, "-"), ("return mapping", BLUE, "--"),
        ("half freedom", GREEN, ":"), ("rigid", ORANGE, "-."))
PANELS = (("x_m", "$x$ [m]"), ("turn_rad", r"$\varphi$ [rad]"), ("vx_m_per_s", r"$\dot x$ [m/s]"),
          ("w_rad_per_s", r"$\dot\varphi$ [rad/s]"), ("force_x_N", "$t_{R,x}$ [N]"), ("moment_Nm", "$t_{R,z}$ [N m]"))


def main():
    options = style.arguments(__doc__, len(LAWS))
    tables = [Table(path) for path in options.input]
    figure, axes = plt.subplots(3, 2, sharex=True, figsize=(style.PAGE, 4.8))
    for panel, (name, label) in zip(axes.flat, PANELS):
        panel.axvspan(5, 15, color=GREY, alpha=0.15, linewidth=0, label="$M_z$ acts")
        for table, (law, colour, dashes) in zip(tables, LAWS):
            panel.plot(table["t_s"], table[name], color=colour, linestyle=dashes, label=law, linewidth=1.2)
        panel.set_ylabel(label)
        panel.set_xlim(0, 60)
    axes[0, 0].legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=5, columnspacing=1.2).set_in_layout(False)
    figure.get_layout_engine().set(rect=(0, 0, 1, 0.95))
    for panel in axes[-1]:
        panel.set_xlabel("$t$ [s]")
    figure.align_ylabels()
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
