"""Creep of a point that is held under a load which oscillates below the limit, against the step, for every law."""

import numpy as np

import style
from style import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY, plt
from table import Table

METHODS = (("return_mapping", "sdirk2", "return mapping, SDIRK2", BLUE, "s"),
           ("return_mapping", "implicit_euler", "return mapping, implicit Euler", GREEN, "^"),
           ("elastoplastic", "rk4", "elastoplastic, RK4", ORANGE, "D"), ("lugre", "rk4", "LuGre, RK4", RED, "v"),
           ("dahl", "rk4", "Dahl, RK4", PURPLE, "o"), ("tanh", "rk4", "tanh, RK4", SKY, "P"))
NONE, DIVERGED = 1e-20, 3e1  # where these are drawn, m/s


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    figure, axes = plt.subplots(figsize=(style.PAGE, 3.2))
    for law, integrator, name, colour, marker in METHODS:
        rows = (table["law"] == law) & (table["integrator"] == integrator)
        step, creep = table["step_s"][rows], table["creep_m_per_s"][rows]
        shown = np.where(np.isfinite(creep), np.maximum(creep, NONE), DIVERGED)
        whole = marker not in "^o"  # those lie on others
        axes.loglog(step, shown, color=colour, marker=marker, markersize=5, linewidth=1, label=name,
                    markerfacecolor=colour if whole else "none")
    for level, word in ((NONE, "none, to the bit"), (DIVERGED, "diverged")):
        axes.axhline(level, color=GREY, linewidth=0.8, linestyle=":", zorder=0)
        axes.text(8e-5, level / 4, word, color=GREY, va="top")
    axes.set_ylim(1e-22, 1e4)
    axes.set_xlim(7e-5, 0.15)
    axes.set_xlabel("step [s]")
    axes.set_ylabel("creep [m/s]")
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
