"""Keppler 2006, figure 4.23: limit surface of a uniform rectangle, with the slip that each wrench belongs to."""

import style
from limit_surface import Surface, draw, slip_scale
from style import plt


def main():
    options = style.arguments(__doc__, 1)
    surface = Surface(options.input[0])
    figure = plt.figure(figsize=(style.COLUMN, 3.6))
    grid = figure.add_gridspec(2, 3, height_ratios=[20, 1], width_ratios=[1, 6, 1])
    axes = figure.add_subplot(grid[0, :], projection="3d")
    draw(axes, surface, surface.gyration)
    axes.set_xlabel(r"$F_\xi / (\mu_H F_N)$", labelpad=-2)
    axes.set_ylabel(r"$F_\eta / (\mu_H F_N)$", labelpad=-2)
    axes.set_zlabel(r"$M / (\mu_H F_N i)$", labelpad=-4.5)
    colours = figure.add_subplot(grid[1, 1])
    slip_scale(figure, colours, cax=colours)
    colours.set_title("distance of the pole / radius of gyration $i$", fontsize=8)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
