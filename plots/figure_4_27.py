"""Keppler 2006, figure 4.27: section through the limit surface of a Hertz disc, and its stick radius, exact and by 4.56."""

import numpy as np

import style
from style import BLACK, BLUE, GREY, RED, plt
from table import Table


def printed_stick_radius(cosine):
    """The polynomial of 4.56."""
    c = np.abs(cosine)
    return 1 - 2.42 * c**2 + 4.64 * c**3 - 3.83 * c**4 + 1.20 * c**5


def section(axes, force, moment):
    """Both signs of force and moment: a surface of revolution about the axis of moments."""
    axes.fill(np.concatenate([force, force[::-1], -force, -force[::-1]]),
              np.concatenate([moment, -moment[::-1], -moment, moment[::-1]]), facecolor="#DCE9F2", edgecolor=BLUE, linewidth=1.4)
    rim = np.argmin(np.abs(moment - 9 * np.pi / 128))
    axes.plot(force[rim], moment[rim], "o", color=BLACK, markersize=3)
    axes.annotate("pole on\nthe rim", (force[rim], moment[rim]), xytext=(-6, -4), textcoords="offset points", ha="right", va="top",
                  fontsize=7)
    axes.annotate(r"$3\pi/16$", (0, moment.max()), xytext=(3, 3), textcoords="offset points", fontsize=7)
    axes.set_axisbelow(True)
    axes.set_aspect("equal")
    axes.set_xlim(-1.15, 1.15)
    axes.set_ylim(-0.75, 0.75)
    axes.set_xlabel(r"force $F / (\mu_H F_N)$ [-]")
    axes.set_ylabel(r"moment $M / (\mu_H F_N a_K)$ [-]")


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    scale = table.friction_force
    share = scale / table["gauge_N"]  # of each load, on the surface
    force = share * table.force / scale
    moment = share * table["moment_Nm"] / (scale * table.radius)
    cosine = moment / np.hypot(force, moment)
    exact, printed = table["stick_radius"], printed_stick_radius(cosine)

    figure, (top, middle, bottom) = plt.subplots(3, figsize=(style.COLUMN, 5.6), height_ratios=[1.15, 1.1, 0.8])
    section(top, force, moment)
    middle.plot(cosine, exact, color=BLUE, label="exact")
    middle.plot(cosine, printed, color=BLACK, linestyle=(0, (1, 2.5)), linewidth=1.2, label="polynomial (4.56)")
    middle.set_ylabel(r"stick radius $\varrho_H$ [-]")
    middle.set_ylim(0.55, 1.02)
    middle.legend(loc="lower left")
    middle.tick_params(labelbottom=False)
    bottom.axhline(0, color=GREY, linewidth=0.6)
    bottom.plot(cosine, 1e3 * (printed - exact), color=RED)
    bottom.fill_between(cosine, 0, 1e3 * np.maximum(printed - exact, 0), color=RED, alpha=0.2, linewidth=0)
    bottom.text(0.02, 0.05, "shaded: claims more\nthan friction holds", transform=bottom.transAxes, va="bottom", fontsize=7)
    bottom.set_ylabel("polynomial $-$\nexact [$10^{-3}$]")
    bottom.set_xlabel(r"cosine of the polar angle, $\cos\theta$ [-]")
    for axes in (middle, bottom):
        axes.set_xlim(0, 1)
    figure.align_ylabels()
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
