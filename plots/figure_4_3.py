"""Keppler 2006, figure 4.3: pressures (1 - r^2/a^2)^(n - 1/2), and the stamps that make them."""

import style
from style import BLACK, BLUE, GREEN, GREY, RED, plt
from table import Table


def main():
    options = style.arguments(__doc__, 4)
    figure, (pressures, shapes) = plt.subplots(1, 2, figsize=(style.PAGE, 2.7))
    for n, (path, colour) in enumerate(zip(options.input, (BLUE, RED, GREEN, BLACK)), 1):
        table = Table(path)
        r, u, p = table["x_m"] / table.radius, table["displacement_m"], table["pressure_Pa"]
        pressures.plot(r, p / p[0], color=colour, label=f"$n = {n}$")
        # One curvature 1/R at the tip for all: delta = a^2 / (n R).
        shapes.plot(r, (u[0] - u) / (n * u[0]), color=colour)
        # (4.13a) as printed lacks a factor n in its peak.
        if n > 1:
            pressures.plot(r, p / (n * p[0]), color=colour, linestyle="--", linewidth=1)
    pressures.plot([], [], color=GREY, linestyle="--", linewidth=1, label="pressure as printed")
    pressures.set_ylabel("pressure $p / p_0$ [-]")
    shapes.set_ylabel("height of the stamp $f R / a_K^2$ [-]")
    for axes in (pressures, shapes):
        axes.set_xlabel("$r / a_K$ [-]")
        axes.set_xlim(0, 1)
        axes.set_ylim(0)
    shapes.legend(*pressures.get_legend_handles_labels(), loc="upper left")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
