"""Iterations, width of the bracket and share of undecided grips where they are badly conditioned, in m and in mm."""

import numpy as np

import style
from style import BLACK, BLUE, GREY, ORANGE, plt
from table import Table

COLUMNS = ((("not_closed",), "next to a cone that is\nnot closed", r"$\delta$"),
           (("friction",), "little and much friction", r"$\mu$"),
           (("inside", "outside"), "load next to the limit", r"$\delta$"))
COLOURS = {"not_closed": BLUE, "friction": BLUE, "inside": BLUE, "outside": ORANGE}
ROWS = (("iterations_half", "iterations"), ("width_half", "relative width"), ("undecided_share", "undecided [%]"))
EXTREMES = {"iterations_half": "iterations_most", "width_half": "width_9_of_10"}


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    figure, axes = plt.subplots(3, 3, sharex="col", sharey="row", figsize=(style.PAGE, 4.8))
    for column, (families, title, at) in zip(axes.T, COLUMNS):
        for family in families:
            metres, millimetres = ((table["family"] == family) & (table["unit"] == unit) for unit in ("m", "mm"))
            for panel, (quantity, _) in zip(column, ROWS):
                if family == "outside" and quantity == "width_half":
                    continue
                scale, colour = 100 if quantity == "undecided_share" else 1, COLOURS[family]
                panel.plot(table["at"][metres], scale * table[quantity][metres], color=colour)
                panel.plot(table["at"][millimetres], scale * table[quantity][millimetres], color=colour, linestyle="",
                           marker="o", markersize=3.5, fillstyle="none", markeredgewidth=0.8)
                if quantity in EXTREMES:
                    panel.plot(table["at"][metres], table[EXTREMES[quantity]][metres], color=colour, linestyle=":")
        column[0].set_title(title)
        column[1].axhline(1e-12, color=GREY, linewidth=0.8)
        column[2].set(xscale="log", xlabel=at)
    delta = np.geomspace(1e-7, 1e-1)
    axes[1, 0].plot(delta, 8.8 * 2.0**-53 / delta**2, color=BLACK, linewidth=0.8)  # 8 units of rounding times |W|
    axes[1, 0].set(yscale="log", ylim=(1e-15, 3))
    for panel, (_, label) in zip(axes[:, 0], ROWS):
        panel.set_ylabel(label)

    def line(**look):
        return plt.Line2D([], [], **look)

    entries = ((line(color=BLUE), "held, in m"), (line(color=ORANGE), "not held, in m"),
               (line(color=GREY, linestyle="", marker="o", markersize=3.5, fillstyle="none"), "the same in mm"),
               (line(color=GREY, linestyle=":"), "most iterations;\nwidth of 9 of 10"),
               (line(color=GREY, linewidth=0.8), r"width $10^{-12}$"),
               (line(color=BLACK, linewidth=0.8), r"$8\,u\,|W|$"))
    axes[1, 2].legend(*zip(*entries), loc="center left", bbox_to_anchor=(1, 0.5))
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
