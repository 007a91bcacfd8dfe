"""Keppler 2006, figure 4.10: eccentricity of a Hertz ellipse against the ratio of the radii of curvature."""

import numpy as np

import style
from style import BLUE, ORANGE, plt
from table import Table


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    order = np.argsort(table["given_radii_ratio"])
    ratio = table["given_radii_ratio"][order]
    fine = np.linspace(ratio[0], 1, 2001)
    eccentricity = np.sqrt(np.interp(fine, ratio, table["eccentricity"][order] ** 2))  # its square is smooth at the circle
    figure, axes = plt.subplots(figsize=(style.COLUMN, 2.6))
    axes.plot(fine, eccentricity, color=BLUE)
    axes.plot(ratio, (table["semi_axis_b_m"] / table["semi_axis_a_m"])[order], color=ORANGE)
    axes.text(0.35, 0.9, "$e$", color=BLUE)
    axes.text(0.22, 0.45, "$b / a$", color=ORANGE, ha="right")
    axes.set_xlabel("radii of curvature $R_2 / R_1$ [-],  $R_1 \\geq R_2$")
    axes.set_ylabel("eccentricity $e$, semi-axes $b / a$ [-]")
    axes.set_xlim(0, 1)
    axes.set_ylim(0, 1.02)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
