"""Keppler 2006, figure 4.6: pressure under a flat punch, and the surface beside it."""

import numpy as np

import style
from style import BLUE, RED, plt
from table import Table


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    r, u, p = table["x_m"] / table.radius, table["displacement_m"], table["pressure_Pa"]
    shown = np.isfinite(p) & (r < 1)
    figure, (pressure, surface) = plt.subplots(2, sharex=True, figsize=(style.COLUMN, 3.6))
    pressure.plot(r[shown], p[shown] / p[0], color=RED)
    pressure.axvline(1, color=RED, linestyle=":", linewidth=1)
    pressure.text(1.06, 3.2, "infinite at the edge", color=RED, va="center")
    pressure.set_ylabel("$p / p(0)$ [-]")
    pressure.set_ylim(0, 5)
    surface.plot(r, u / u[0], color=BLUE)
    # The text prints delta with pi/2 in place of 1/2.
    surface.set_ylabel(r"$u_z / \delta$ [-]")
    surface.set_ylim(0, 1.1)
    surface.set_xlabel("distance from the axis $r / R$ [-]")
    surface.set_xlim(0, 3)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
