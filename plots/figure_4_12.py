"""Keppler 2006, figure 4.12: radius of the zone of stick while a ball is pressed on, corrected and as printed."""

import style
from style import BLUE, RED, plt
from table import Table


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    x = table["dundurs_beta"] / table["given_mu"]
    figure, axes = plt.subplots(figsize=(style.COLUMN, 2.6))
    axes.plot(x, table["stick_radius_ratio"], color=BLUE)
    axes.plot(x, table["stick_as_printed_stick_radius_ratio"], color=RED, linestyle="--")
    axes.text(2.2, 0.62, "corrected", color=BLUE)
    axes.text(2.9, 0.9, "as printed\n(inverted ratio)", color=RED, ha="center", va="center")
    axes.set_xlabel(r"Dundurs' constant over friction, $\beta_D / \mu_H$ [-]")
    axes.set_ylabel("zone of stick over contact, $a_S / a_K$ [-]")
    axes.set_xlim(0, 5)
    axes.set_ylim(0, 1.03)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
