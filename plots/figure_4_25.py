"""Keppler 2006, figure 4.25 (Example 4.8): friction of a block on a turntable, against the place of the block."""

import numpy as np
from matplotlib.patches import Arc, FancyArrowPatch, Rectangle
from matplotlib.ticker import MultipleLocator

import style
from style import BLACK, BLUE, GREEN, GREY, ORANGE, RED, plt
from table import Table


def curves(axes, x, table, size):
    """Force and moment in the order of x, which has one value a row."""
    order = np.argsort(x)
    scale = table.friction_force
    axes.axhline(0, color=GREY, linewidth=0.6)
    for values, name, colour, dashes in (
        (table["force_x_N"] / scale, r"$F_\xi$", BLUE, "-"),
        (table["force_y_N"] / scale, r"$F_\eta$", RED, "--"),
        (table.force / scale, r"$|F|$", BLACK, ":"),
        (np.abs(table["moment_Nm"]) / (scale * size), r"$|M| / L$, about $O$", GREEN, "-."),
    ):
        axes.plot(x[order], values[order], color=colour, linestyle=dashes, label=name, linewidth=1.8 if dashes == ":" else None)
    axes.set_ylim(-1.12, 1.12)
    axes.set_ylabel(r"friction / $\mu F_N$ [-]")


def mark_example(axes, table, size):
    """The numbers of Example 4.8: xi_M = 0, eta_M = L."""
    row = np.argmin(np.abs(table["pole_x_m"]))
    force = table.force[row] / table.friction_force
    moment = abs(table["moment_Nm"][row]) / (table.friction_force * size)
    for value, rise, side in ((force, -4, "top"), (moment, 4, "bottom")):
        axes.plot(0, value, "o", color=BLACK, markersize=3)
        axes.annotate(f"{value:.4f}", (0, value), xytext=(0, rise), textcoords="offset points", ha="center", va=side)


def sketch(axes):
    def arrow(start, end, **options):
        axes.add_patch(FancyArrowPatch(start, end, shrinkA=0, shrinkB=0, **options))

    axes.set_aspect("equal")
    axes.axis("off")
    axes.add_patch(Rectangle((-1, -0.5), 2, 1, facecolor="#F2F2F2", edgecolor=BLACK, linewidth=0.8))
    for end, name, place in (((0.62, 0), r"$\xi$", (0.68, -0.13)), ((0, 0.36), r"$\eta$", (-0.2, 0.22))):
        arrow((0, 0), end, arrowstyle="-|>", mutation_scale=7, linewidth=0.8, color=BLACK)
        axes.text(*place, name)
    axes.text(-0.06, -0.05, "$O$", ha="right", va="top")
    axes.add_patch(Arc((0, 0), 2, 2, color=GREY, linestyle="--", linewidth=0.9))
    axes.text(0, -1.06, r"a: $|OM| = L$", ha="center", va="top")
    axes.plot([-1.75, 1.75], [1, 1], color=ORANGE, linewidth=0.9, linestyle="--")
    axes.text(-1.75, 1.07, r"b: $\eta_M = L$", va="bottom")
    phi = 35
    x, y = np.sin(np.radians(phi)), np.cos(np.radians(phi))
    axes.plot([0, x], [0, y], color=BLACK, linewidth=0.6)
    axes.plot(x, y, "o", color=BLACK, markersize=4)
    axes.text(x + 0.09, y - 0.02, "$M$", va="center")
    axes.add_patch(Arc((0, 0), 1.3, 1.3, theta1=90 - phi, theta2=90, color=BLACK, linewidth=0.6))
    axes.text(0.15, 0.72, r"$\varphi$")
    for start, end, name in (((-1, -0.68), (1, -0.68), "$2L$"), ((1.2, -0.5), (1.2, 0.5), "$L$")):
        arrow(start, end, arrowstyle="<|-|>", mutation_scale=5, linewidth=0.6, color=GREY)
        axes.text(*np.mean((start, end), axis=0), name, ha="center", va="center",
                  bbox={"facecolor": "white", "edgecolor": "none", "pad": 1})
    axes.set_xlim(-1.8, 1.8)
    axes.set_ylim(-1.3, 1.3)


def main():
    options = style.arguments(__doc__, 2)
    arc, line = (Table(path) for path in options.input)
    size = arc.number("m along x and", " m along y")  # L

    rows = [["arc", "sketch"], ["arc", "sketch"], ["line", "sketch"], ["line", "legend"]]
    figure, axes = plt.subplot_mosaic(rows, figsize=(style.PAGE, 4.2), width_ratios=[1.3, 1])
    curves(axes["arc"], np.degrees(np.arctan2(arc["pole_x_m"], arc["pole_y_m"])), arc, size)
    axes["arc"].set_xlabel(r"$\varphi = \mathrm{atan2}(\xi_M, \eta_M)$ [deg]")
    axes["arc"].xaxis.set_major_locator(MultipleLocator(45))
    axes["arc"].set_xlim(-180, 180)
    curves(axes["line"], line["pole_x_m"] / size, line, size)
    mark_example(axes["line"], line, size)
    axes["line"].set_xlabel(r"$\xi_M / L$ [-]")
    axes["line"].margins(x=0)
    for name, letter, condition in (("arc", "a", r"$|OM| = L$"), ("line", "b", r"$\eta_M = L$")):
        axes[name].set_title(letter, loc="left", fontweight="bold")
        axes[name].set_title(condition, loc="center")
    sketch(axes["sketch"])
    axes["legend"].axis("off")
    axes["legend"].legend(*axes["line"].get_legend_handles_labels(), loc="upper center", title="friction on the block",
                          ncols=2, alignment="left", handlelength=3, labelspacing=0.8)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
