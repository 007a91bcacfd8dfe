"""The least grip that holds a weight, against its offset: the exact patch, and the soft fingers that stand for it."""

import numpy as np

import style
from style import BLUE, GREEN, GREY, ORANGE, plt
from table import Table


def main():
    options = style.arguments(__doc__, 3)
    exact, elliptic, linear = (Table(path) for path in options.input)
    offset = 1e3 * exact["offset_m"]
    figure, (grips, sides) = plt.subplots(2, sharex=True, figsize=(style.COLUMN, 4.6), height_ratios=[1.4, 1])
    for table, label, colour, line in ((linear, "linear soft finger", GREEN, "--"), (exact, "exact limit surface", BLUE, "-"),
                                       (elliptic, "elliptic soft finger", ORANGE, "--")):
        grips.plot(offset, table["least_grip_N"], color=colour, linestyle=line, label=label)
    grips.set_ylabel("least grip [N]")
    grips.set_ylim(bottom=0)
    grips.legend(loc="upper left")
    for table, colour in ((linear, GREEN), (elliptic, ORANGE)):
        sides.plot(offset, 100 * (table["least_grip_N"] / exact["least_grip_N"] - 1), color=colour, linestyle="--")
    sides.axhline(0, color=BLUE)
    lowest = 100 * np.min(elliptic["least_grip_N"] / exact["least_grip_N"] - 1)
    sides.annotate(f"unsafe: {-lowest:.1f} % too little", (offset[-1], 2 * lowest), ha="right", va="top", color=ORANGE)
    sides.annotate("safe, but a waste of grip", (offset[-1], 40), ha="right", va="bottom", color=GREEN)
    sides.set_ylim(-22, 55)
    sides.set_xlabel("offset of the weight [mm]")
    sides.set_ylabel("too much grip [%]")
    figure.suptitle("Two Hertz fingertips, $a$ = 5 mm, µ = 0.5, weight 5 N", fontsize=9, color=GREY)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
