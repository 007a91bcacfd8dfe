"""Error of the time at which a puck stops, against CPU time and evaluations of friction, for every law and integrator."""

import numpy as np

import style
from style import BLACK, BLUE, GREEN, ORANGE, RED, plt
from table import Table

METHODS = (("rigid", "stretched", "rigid, stretched time", BLACK, "o"), ("return_mapping", "sdirk2", "return mapping, SDIRK2", BLUE, "s"),
           ("return_mapping", "implicit_euler", "return mapping, implicit Euler", GREEN, "^"),
           ("elastoplastic", "dopri5", "elastoplastic, adaptive RK5(4)", ORANGE, "D"),
           ("elastoplastic", "rk4", "elastoplastic, fixed RK4", RED, "v"))
FLOOR = 1e-15  # what rounding leaves, s


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    figure, axes = plt.subplots(1, 2, sharey=True, figsize=(style.PAGE, 3.2))
    disc = table["disc"] == "hertz_disc"
    for panel, (column, label) in zip(axes, (("us", r"CPU time of the run [$\mu$s]"), ("evaluations", "evaluations of friction [-]"))):
        for law, integrator, name, colour, marker in METHODS:
            rows = disc & (table["law"] == law) & (table["integrator"] == integrator)
            panel.loglog(table[column][rows], np.maximum(table["stop_error_s"][rows], FLOOR), color=colour, marker=marker,
                         markersize=4, linewidth=1, label=name)
        panel.set_xlabel(label)
    axes[0].set_ylabel("error of the stop [s]")
    axes[1].legend(loc="lower left", bbox_to_anchor=(1, 0.3))
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
