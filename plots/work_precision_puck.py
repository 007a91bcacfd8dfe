"""Error of the time and the place at which a puck stops, against CPU time and evaluations of friction, for every law and integrator."""

import numpy as np

import style
from style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY, plt
from table import Table

METHODS = (("rigid", "stretched", "rigid, stretched time", BLACK, "o"), ("return_mapping", "sdirk2", "return mapping, SDIRK2", BLUE, "s"),
           ("return_mapping", "implicit_euler", "return mapping, implicit Euler", GREEN, "^"),
           ("stack", "sdirk2", "on a heavy body, SDIRK2", SKY, "P"),
           ("elastoplastic", "dopri5", "elastoplastic, adaptive RK5(4)", ORANGE, "D"),
           ("elastoplastic", "rk4", "elastoplastic, fixed RK4", RED, "v"),
           ("elastoplastic", "cvode_bdf", "elastoplastic, CVODE BDF", GREY, "<"),
           ("elastoplastic", "cvode_adams", "elastoplastic, CVODE Adams", GREY, ">"),
           ("half_freedom", "dopri5", "half a degree of freedom, RK5(4)", PURPLE, "X"),
           ("half_freedom", "cvode_bdf", "half a degree of freedom, CVODE BDF", PURPLE, "<"),
           ("half_freedom", "cvode_adams", "half a degree of freedom, CVODE Adams", PURPLE, ">"),
           ("half_freedom", "ida", "half a degree of freedom, IDA", PURPLE, "v"))
PANELS = (("us", r"CPU time [$\mu$s]", "stop_error_s", "error of the stop [s]"),
          ("us", r"CPU time [$\mu$s]", "distance_error_m", "error of the distance [m]"),
          ("evaluations", "evaluations of friction [-]", "stop_error_s", "error of the stop [s]"))
FLOOR = 1e-15  # what rounding leaves, s and m


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    figure = plt.figure(figsize=(style.PAGE, 4.6))
    grid = figure.add_gridspec(2, 3, height_ratios=(3, 1))
    disc = table["disc"] == "hertz_disc"
    for column, (across, label, up, title) in enumerate(PANELS):
        panel = figure.add_subplot(grid[0, column])
        for law, integrator, name, colour, marker in METHODS:
            rows = disc & (table["law"] == law) & (table["integrator"] == integrator)
            if not rows.any():  # those of SUNDIALS, without libsundials-dev
                continue
            panel.loglog(table[across][rows], np.maximum(table[up][rows], FLOOR), color=colour, marker=marker, markersize=4,
                         linewidth=1, label=name)
        panel.set_xlabel(label)
        panel.set_ylabel(title)
        panel.set_ylim(FLOOR, 1)
    names = figure.add_subplot(grid[1, :])
    names.axis("off")
    names.legend(*panel.get_legend_handles_labels(), loc="center", ncol=2)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
