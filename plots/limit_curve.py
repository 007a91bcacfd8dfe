"""The limit curve of a Hertz disc, force against moment: exact, as Keppler 2006 prints it, and the ellipse in common use."""

import numpy as np

import style
from style import BLACK, BLUE, GREY, ORANGE, RED, plt
from table import Table


def printed_moment(force):
    """0 = 256/(9 pi^2) m^2 - (1 - f^2)(1 - f^2/4)^2, in 4.2.5."""
    return 3 * np.pi / 16 * np.sqrt(np.clip(1 - force**2, 0, None)) * (1 - force**2 / 4)


def ellipse_moment(force):
    return 3 * np.pi / 16 * np.sqrt(np.clip(1 - force**2, 0, None))


def corrected(force, moment):
    """(4 - 3 q^2 - 48 f^2/pi^2)^2 - q^6 with q^2 = 8 m/pi - 1/2: 0 where the pole lies within the disc."""
    q2 = 8 * moment / np.pi - 0.5
    return (4 - 3 * q2 - 48 * force**2 / np.pi**2) ** 2 - q2**3


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    scale = table.friction_force
    share = scale / table["gauge_N"]
    force = share * table.force / scale
    moment = share * table["moment_Nm"] / (scale * table.radius)
    rim_moment = 9 * np.pi / 128
    inside = moment >= rim_moment
    worst = np.abs(corrected(force[inside], moment[inside])).max()

    figure, (curves, differences) = plt.subplots(2, sharex=True, figsize=(style.COLUMN, 4.4), height_ratios=[1.5, 1])
    curves.plot(force, moment, color=BLUE, label="exact")
    curves.plot(force, printed_moment(force), color=BLACK, linestyle=(0, (1, 2.5)), linewidth=1.2, label="as printed (4.2.5)")
    curves.plot(force, ellipse_moment(force), color=ORANGE, linestyle="--", linewidth=1, label="ellipse")
    rim = np.argmin(np.abs(moment - rim_moment))
    for axes, height in ((curves, moment[rim]), (differences, 0)):
        axes.plot(force[rim], height, "o", color=BLACK, markersize=3)
    curves.annotate("pole on the rim", (force[rim], moment[rim]), xytext=(-6, -3), textcoords="offset points", ha="right",
                    va="top", fontsize=7)
    curves.legend(loc="lower left")
    curves.set_ylim(0, 0.65)
    curves.set_ylabel(r"moment $M / (\mu_H F_N a_K)$ [-]")
    differences.axhline(0, color=BLUE, linewidth=1)
    differences.plot(force, 1e3 * (printed_moment(force) - moment), color=RED, label="as printed $-$ exact")
    differences.text(0.02, 0.95, f"corrected closed form,\npole within the disc:\nresidual $\\leq$ {latex(worst)}",
                     transform=differences.transAxes, va="top", fontsize=7)
    differences.set_ylim(-2.6, 2.4)
    differences.set_ylabel("as printed $-$\nexact [$10^{-3}$]")
    differences.set_xlabel(r"force $F / (\mu_H F_N)$ [-]")
    differences.set_xlim(0, 1)
    figure.align_ylabels()
    style.save(figure, options.output)


def latex(number):
    exponent = int(np.floor(np.log10(number)))
    return f"${number / 10.0**exponent:.1f} \\times 10^{{{exponent}}}$"


if __name__ == "__main__":
    main()
