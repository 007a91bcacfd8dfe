"""Keppler 2006, figure 4.2: surface of a half-space under the Hertz pressure, and the stamp that makes it."""

import numpy as np

import style
from style import BLACK, BLUE, GREY, RED, plt
from table import Table


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    r, u, p = table["x_m"], table["displacement_m"], table["pressure_Pa"]
    delta = u[0]
    a = r[p > 0][-1] + (r[1] - r[0]) if p[-1] == 0 else r[-1]
    stamp = u - table["gap_m"]  # delta - f
    printed = delta - (delta - stamp) * 4 / np.pi  # Example 4.1 lacks the factor pi/4

    figure, axes = plt.subplots(figsize=(style.COLUMN, 2.7))
    axes.fill_between(r / a, 0.28 * p / p[0] - 0.42, -0.42, where=p > 0, color=GREY, alpha=0.3, linewidth=0)
    axes.plot(r / a, u / delta, color=BLUE)
    for curve, colour, line in ((stamp, BLACK, "-"), (printed, RED, "--")):
        drawn = curve > -0.3 * delta
        axes.plot(r[drawn] / a, curve[drawn] / delta, color=colour, linestyle=line, linewidth=1)
    axes.text(0.08, -0.36, "pressure $p(r)$", color=BLACK)
    axes.text(1.6, 0.36, "surface $u_z$", color=BLUE)
    axes.text(1.6, -0.2, r"stamp $\delta - f$", color=BLACK)
    axes.text(0.8, 0.3, "stamp as\nprinted", color=RED, ha="right", va="center")
    axes.set_xlim(0, 2.5)
    axes.set_ylim(-0.42, 1.05)
    axes.set_xlabel("distance from the axis $r / a_K$ [-]")
    axes.set_ylabel(r"depth over $\delta$ [-]")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
