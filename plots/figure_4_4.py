"""Keppler 2006, figure 4.4: the first four terms of a sphere as stamps, and the pressures under them."""

from math import gamma

import numpy as np

import style
from style import BLACK, BLUE, GREEN, GREY, RED, plt
from table import Table


def printed(n, rho):
    """(4.14b) as printed over what it should be: the sum lacks its first term, and the factor 1/sqrt(pi)."""
    terms = [gamma(n - k - 0.5) / gamma(n - k) * rho ** (2 * k) for k in range(n)]
    return np.sqrt(np.pi) * sum(terms[1:], np.zeros_like(rho)) / sum(terms)


def main():
    options = style.arguments(__doc__, 4)
    figure, (shapes, pressures) = plt.subplots(1, 2, figsize=(style.PAGE, 2.7))
    largest = None
    for n, (path, colour) in enumerate(zip(options.input, (BLUE, RED, GREEN, BLACK)), 1):
        table = Table(path)
        r, u, p = table["x_m"], table["displacement_m"], table["pressure_Pa"]
        rho = r / r[-1]
        height = u[0] - u
        if largest is None:
            largest = height[-1], p.max()
        shapes.semilogy(rho[1:], height[1:] / largest[0], color=colour, label=f"$r^{{{2 * n}}}$")
        pressures.semilogy(rho[:-1], p[:-1] / largest[1], color=colour, label=f"$r^{{{2 * n}}}$")
        pressures.semilogy(rho[1:-1], (p / largest[1] * printed(n, rho))[1:-1], color=colour, linestyle="--", linewidth=1)
    pressures.plot([], [], color=GREY, linestyle="--", linewidth=1, label="as printed (4.14b)")
    shapes.set_ylabel("height over that of $r^2$ at the rim [-]")
    pressures.set_ylabel("pressure over the peak of $r^2$ [-]")
    for axes in (shapes, pressures):
        axes.set_xlabel("$r / a_K$ [-],  $a_K = R / 2$")
        axes.set_xlim(0, 1)
    shapes.set_ylim(1e-6, 1)
    pressures.set_ylim(1e-5, 1.5)
    shapes.legend(loc="lower right")
    pressures.legend(loc="lower right", fontsize=7, ncols=2)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
