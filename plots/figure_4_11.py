"""Keppler 2006, figure 4.11: what a circle of one radius gets wrong where the contact is an ellipse, at equal approach."""

import style
from style import BLACK, BLUE, GREEN, RED, plt
from table import Table

FACTORS = (("force", "$f_{F_N}$", BLACK), ("pressure", "$f_p$", RED), ("a", "$f_a$", BLUE), ("b", "$f_b$", GREEN))


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    ratio = table["given_radii_ratio"]
    figure, panels = plt.subplots(1, 2, sharex=True, figsize=(style.PAGE, 2.8))
    for axes, law, title in zip(panels, ("circle_of_small_radius", "circle_of_large_radius"),
                                ("circle of the smaller radius $R_2$", "circle of the larger radius $R_1$")):
        for name, label, colour in FACTORS:
            axes.loglog(ratio, table[f"{law}_{name}_factor"], color=colour, label=label)
        axes.set_title(title, loc="left")
        axes.set_xlabel("$R_2 / R_1$ [-]")
    panels[0].set_ylabel("ellipse over circle [-]")
    panels[0].legend(ncols=2)
    panels[0].set_xlim(ratio.min(), 1)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
