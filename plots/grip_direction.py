"""The least grip of two soft fingertips against the direction of the load."""

import numpy as np

import style
from style import BLUE, GREY, plt
from table import Table


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    angle, grip = table["turn_rad"], table["least_grip_N"]
    upper = table["upper_N"] - table["lower_N"]
    figure, (polar, width) = plt.subplots(2, figsize=(style.COLUMN, 4.6), height_ratios=[2, 1])
    polar.plot(np.degrees(angle), grip, color=BLUE)
    for index in (np.argmax(grip), np.argmin(grip)):
        polar.annotate(f"{grip[index]:.2f} N", (np.degrees(angle[index]), grip[index]), textcoords="offset points",
                       xytext=(0, 5 if grip[index] == grip.max() else -12), ha="center")
    polar.set_ylabel("least grip [N]")
    polar.set_ylim(0, 1.15 * grip.max())
    polar.set_title("A load of 4.9 N, 4 mm off the line", color=GREY)
    width.semilogy(np.degrees(angle), np.maximum(upper / grip, 1e-17), color=BLUE, linewidth=0.8)
    width.set_ylabel("width of the bracket\nover the grip")
    for axes in (polar, width):
        axes.set_xlim(0, 180)
        axes.set_xticks(range(0, 181, 30))
    width.set_xlabel("turn of the load [degrees]")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
