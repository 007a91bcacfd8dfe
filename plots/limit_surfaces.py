"""Limit surfaces of an ellipse, an L-shape and two patches, and how far an L-shape tells left from right."""

import numpy as np

import style
from limit_surface import Surface, draw, slip_scale
from style import BLUE, GREEN, GREY, RED, plt
from table import Table


def left_and_right(axes, table):
    """g(F, +M) against g(F, -M) around the compass; the loads come in pairs, +M first."""
    gauge = table["gauge_N"].reshape(-1, 2)
    moment = table["moment_Nm"].reshape(-1, 2)[:, 0]
    angle = np.degrees(np.arctan2(table["force_y_N"], table["force_x_N"])).reshape(-1, 2)[:, 0]
    axes.axhline(0, color=GREY, linewidth=0.6)
    for size, colour in zip(np.unique(moment), (BLUE, GREEN, RED)):
        rows = moment == size
        order = np.argsort(angle[rows])
        difference = 100 * (gauge[rows, 0] / gauge[rows, 1] - 1)
        axes.plot(angle[rows][order], difference[order], color=colour, label=f"{1e3 * size:g} mN m")
    axes.set_xlim(-180, 180)
    axes.set_xticks(range(-180, 181, 90))
    axes.set_xlabel("direction of the force [deg]")
    axes.set_ylabel(r"$g(F, +M) \,/\, g(F, -M) - 1$ [%]")
    axes.set_ylim(-8, 10.5)
    axes.legend(title="$M$, under $|F| = 0.36$ N:", ncols=3, loc="upper left", columnspacing=1.2, handlelength=1.4,
                alignment="left", borderpad=0.2)


def main():
    options = style.arguments(__doc__, 4)
    ellipse, l_shape, two = (Surface(path) for path in options.input[:3])
    compass = Table(options.input[3])

    plt.rcParams["figure.constrained_layout.use"] = False  # places are given
    figure = plt.figure(figsize=(style.PAGE, 4.9))
    for k, (surface, name) in enumerate(((ellipse, "a  Hertz ellipse 3:1"), (l_shape, "b  L-shape"), (two, "c  two patches"))):
        axes = figure.add_axes((0.33 * k - 0.035, 0.44, 0.36, 0.56), projection="3d")
        axes.patch.set_alpha(0)
        draw(axes, surface, surface.gyration, azimuth=-40, elevation=20, zoom=0.86)
        figure.text(0.33 * k + 0.01, 0.96, name, fontweight="bold", fontsize=9)
        axes.set_xlabel(r"$F_x / R$", labelpad=-4)
        axes.set_ylabel(r"$F_y / R$", labelpad=-4)
        axes.set_zlabel(r"$M / (R i)$", labelpad=-4.5)
    curve = figure.add_axes((0.075, 0.085, 0.52, 0.3))
    left_and_right(curve, compass)
    curve.set_title("d  L-shape", loc="left", fontweight="bold")
    figure.text(0.66, 0.385, "$R$: $\\mu F_N$, or the sum of $\\mu_i F_i$\n$i$: radius of gyration of the pressure\n"
                "$M$: about the origin; that of a and b\nis the centroid\ncolour: the slip that comes next", va="top")
    colours = figure.add_axes((0.67, 0.125, 0.29, 0.028))
    slip_scale(figure, colours, cax=colours)
    colours.set_title("distance of the pole from the centroid / $i$", fontsize=8)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
