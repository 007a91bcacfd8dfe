"""Keppler 2006, figure 4.26: friction of a Hertz disc against the distance of the pole, exact and by the polynomials of 4.2.5."""

import numpy as np

import style
from style import BLACK, BLUE, GREY, RED, plt
from table import Table


def main():
    options = style.arguments(__doc__, 2)
    exact, polynomial = (Table(path) for path in options.input)
    radius = exact.radius
    scale = exact.friction_force
    x = exact.pole_distance / radius

    figure, (curves, differences) = plt.subplots(2, sharex=True, figsize=(style.COLUMN, 4.3), height_ratios=[1.5, 1])
    dots = {"color": BLACK, "linestyle": (0, (1, 2.5)), "linewidth": 1.2}
    force = exact.force / scale, polynomial.force / scale, polynomial["force_error_N"] / scale
    moment = (np.abs(exact["moment_Nm"]) / (scale * radius), np.abs(polynomial["moment_Nm"]) / (scale * radius),
              polynomial["moment_error_Nm"] / (scale * radius))
    for (true, fit, bound), colour, name, height in ((force, BLUE, r"$|F| / (\mu F_N)$", 0.85),
                                                     (moment, RED, r"$|M| / (\mu F_N a_K)$", 0.2)):
        curves.plot(x, true, color=colour)
        curves.plot(x, fit, **dots)
        curves.text(2.1, height, name, color=colour, va="center")
        differences.fill_between(x, -1e3 * bound, 1e3 * bound, color=colour, alpha=0.15, linewidth=0)
        differences.plot(x, 1e3 * (fit - true), color=colour)
    curves.plot([], [], color=GREY, label="exact")
    curves.plot([], [], label="polynomials", **dots)
    curves.legend(loc="center right", bbox_to_anchor=(1, 0.47))
    curves.set_ylabel("force, moment [-]")
    curves.set_ylim(0, 1.05)
    differences.text(0.05, -1.2, "shaded:\nproven\nbounds", va="bottom")
    differences.set_ylabel("polynomial $-$\nexact [$10^{-3}$]")
    differences.set_xlabel(r"distance of the pole $r_M / a_K$ [-]")
    differences.set_xlim(0, x[-1])
    figure.align_ylabels()
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
