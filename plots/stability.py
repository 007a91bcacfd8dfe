"""Where fixed steps of a law of friction are right, wrong or diverge: step, stiffness and damping of bristles (Example 4.7)."""

import itertools

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

import style
from style import BLACK, BLUE, GREY, ORANGE, plt
from table import Table

METHODS = (("lugre", "rk4", "LuGre, RK4"), ("elastoplastic", "rk4", "elastoplastic, RK4"),
           ("return_mapping", "implicit_euler", "return mapping,\nimplicit Euler"),
           ("return_mapping", "sdirk2", "return mapping,\nSDIRK2"))
VERDICTS = ("right", "wrong", "diverged")
COLOURS = (BLUE, ORANGE, GREY)
SLIDING, SPEED, MASS = 10 / 3, 4, 1  # N, m/s, kg
RATIOS = (0.0707, 0.5, 2)


def edges(centres):
    """Of cells around values in equal ratios."""
    half = np.sqrt(centres[1] / centres[0])
    return np.append(centres / half, centres[-1] * half)


def longest_step(eigenvalues):
    """Up to which the method of Runge and Kutta damps every one of them."""
    steps = np.linspace(0.01, 4, 4000)
    z = steps[:, None] * np.atleast_1d(eigenvalues)
    damped = np.all(np.abs(1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4)))) <= 1, axis=1)
    return steps[np.argmin(damped) - 1]


def stick(ratio):
    """Eigenvalues of a block on a damped spring, in units of its frequency without damping."""
    return np.roots([1, 2 * ratio, 1])


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    figure, axes = plt.subplots(3, 4, sharex=True, sharey=True, figsize=(style.PAGE, 5))
    for (row, ratio), (column, (law, integrator, name)) in itertools.product(enumerate(RATIOS), enumerate(METHODS)):
        panel = axes[row, column]
        rows = (table["law"] == law) & (table["integrator"] == integrator) & (table["damping_ratio"] == ratio)
        panel.grid(False)
        step, stiffness = np.unique(table["step_s"][rows]), np.unique(table["stiffness_N_per_m"][rows])
        found = np.array([VERDICTS.index(v) for v in table["verdict"][rows]]).reshape(len(stiffness), len(step))
        panel.pcolormesh(edges(step), edges(stiffness), found, cmap=ListedColormap(COLOURS), vmin=-0.5, vmax=2.5, alpha=0.75)
        if integrator == "rk4":
            panel.plot(longest_step(-1) * SLIDING / (stiffness * SPEED), stiffness, color=BLACK)
            panel.plot(longest_step(stick(ratio)) * np.sqrt(MASS / stiffness), stiffness, color=BLACK, linestyle="--")
        panel.set(xscale="log", yscale="log")
        panel.set_xlim(edges(step)[[0, -1]])
        panel.set_ylim(edges(stiffness)[[0, -1]])
        if row == 0:
            panel.set_title(name)
        if row == 2:
            panel.set_xlabel("step [s]")
        if column == 0:
            panel.set_ylabel(rf"$\zeta$ = {ratio:g}" "\n" r"stiffness $c_0$ [N/m]")
    lines = [plt.Line2D([], [], color=BLACK), plt.Line2D([], [], color=BLACK, linestyle="--")]
    axes[1, 3].legend([Patch(color=c, alpha=0.75) for c in COLOURS] + lines, (*VERDICTS, "bound, slip", "bound, stick"),
                      loc="center left", bbox_to_anchor=(1, 0.5))
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
