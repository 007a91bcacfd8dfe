"""Keppler 2006, figure 4.30: a body on a round contact is turned loose by a moment, slides, spins, and sticks again."""

import numpy as np
from matplotlib.patches import Circle

import style
from style import BLACK, BLUE, GREY, ORANGE, plt
from table import Table

ON, OFF = 5, 15  # the moment, s


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    t, x, y, turn = table["t_s"], table["x_m"], table["y_m"], table["turn_rad"]
    radius = table.radius
    figure, axes = plt.subplots(figsize=(style.PAGE, 1.75))
    axes.set_aspect("equal")
    for moment, colour, name in (((t < ON), GREY, "sticks"), ((t >= ON) & (t <= OFF), ORANGE, r"slides with $M_z$"),
                                 (t >= OFF, BLUE, r"slides without $M_z$")):
        axes.plot(x[moment], y[moment], color=colour, linewidth=2.2, label=name, zorder=3)
    # About as often as it moves on by a diameter.
    shown = [np.argmin(np.abs(t - at)) for at in (0, 17, 20.5, 24, 27.5, 32, 60)]
    for row in shown:
        colour = GREY if t[row] < ON else ORANGE if t[row] < OFF else BLUE
        axes.add_patch(Circle((x[row], y[row]), radius, fill=False, edgecolor=colour, linewidth=1))
        axes.plot([x[row], x[row] + radius * np.cos(turn[row])], [y[row], y[row] + radius * np.sin(turn[row])], color=BLACK,
                  linewidth=0.9, zorder=4)
        label = "0 to 5 s" if row == 0 else f"{t[row]:g} s" if t[row] < 44 else "from 43.9 s"
        axes.text(x[row], y[row] - radius - 0.04, label, ha="center", va="top")
    axes.set_xlim(-0.3, 3.6)
    axes.set_ylim(-0.42, 0.32)
    axes.set_xlabel("$x$ [m]")
    axes.set_ylabel("$y$ [m]")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 1.32), ncols=3)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
