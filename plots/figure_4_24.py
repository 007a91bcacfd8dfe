"""Keppler 2006, figures 4.23 and 4.24: limit surface and stick radius of a uniform rectangle of 2:1."""

import numpy as np

import style
from limit_surface import Surface, draw, slip_scale
from style import BLACK, plt
from table import Table


def stick_radius(axes, table):
    """rho_H over phi and theta, as the scene asks for them: theta runs fastest. Returns the coloured areas."""
    length = table.length
    theta = np.arctan2(table.force, table["moment_Nm"] / length)
    count = len(np.unique(np.round(theta, 9)))
    rho = table["stick_radius"].reshape(-1, count)
    azimuth = np.linspace(-180, 180, rho.shape[0])
    polar = np.linspace(0, 180, count)
    levels = np.linspace(0.6, 0.95, 8)
    filled = axes.contourf(azimuth, polar, rho.T, levels=np.linspace(rho.min(), 1, 65), cmap="viridis")
    for shade in filled.collections:
        shade.set_edgecolor("face")
    on_dark = ["white" if level < 0.82 else BLACK for level in levels]
    lines = axes.contour(azimuth, polar, rho.T, levels=levels, colors=on_dark, linewidths=0.5)
    axes.clabel(lines, fmt="%g", fontsize=7)
    axes.set_xlabel(r"azimuth $\phi$ [deg]")
    axes.set_ylabel(r"polar angle $\theta$ [deg]")
    axes.set_xticks(range(-180, 181, 90))
    axes.set_yticks(range(0, 181, 45))
    axes.invert_yaxis()
    axes.grid(False)
    return filled


def main():
    options = style.arguments(__doc__, 2)
    surface, table = Surface(options.input[0]), Table(options.input[1])

    figure = plt.figure(figsize=(style.PAGE, 3.5))
    left, right = figure.subfigures(1, 2, width_ratios=[1.25, 1])
    grid = left.add_gridspec(2, 3, height_ratios=[22, 1], width_ratios=[1, 6, 1])
    axes = left.add_subplot(grid[0, :], projection="3d")
    draw(axes, surface, table.length, zoom=1)
    axes.set_xlabel(r"$F_\xi / (\mu_H F_N)$", labelpad=-2)
    axes.set_ylabel(r"$F_\eta / (\mu_H F_N)$", labelpad=-2)
    axes.set_zlabel(r"$M / (\mu_H F_N a_K)$", labelpad=-4.5)
    axes.set_title("a  limit surface", loc="left", fontweight="bold")
    colours = left.add_subplot(grid[1, 1])
    slip_scale(left, colours, cax=colours)
    colours.set_title("distance of the pole / radius of gyration", fontsize=8)
    maps = right.add_subplot()
    bar = right.colorbar(stick_radius(maps, table), ax=maps, location="bottom", aspect=20,
                         ticks=[0.75, 0.8, 0.85, 0.9, 0.95, 1])
    bar.ax.set_title(r"$\varrho_H$ [-]", fontsize=8)
    bar.outline.set_linewidth(0.4)
    maps.set_title("b  stick radius", loc="left", fontweight="bold")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
