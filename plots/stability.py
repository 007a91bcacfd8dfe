"""Where fixed steps of a law of friction are right, wrong or diverge: step against stiffness of the bristle (Example 4.7)."""

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


def edges(centres):
    """Of cells around values in equal ratios."""
    half = np.sqrt(centres[1] / centres[0])
    return np.append(centres / half, centres[-1] * half)


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    figure, axes = plt.subplots(1, 4, sharey=True, figsize=(style.PAGE, 2.6))
    for panel, (law, integrator, name) in zip(axes, METHODS):
        rows = (table["law"] == law) & (table["integrator"] == integrator)
        panel.grid(False)
        step, stiffness = np.unique(table["step_s"][rows]), np.unique(table["stiffness_N_per_m"][rows])
        found = np.array([VERDICTS.index(v) for v in table["verdict"][rows]]).reshape(len(stiffness), len(step))
        panel.pcolormesh(edges(step), edges(stiffness), found, cmap=ListedColormap(COLOURS), vmin=-0.5, vmax=2.5, alpha=0.75)
        if integrator == "rk4":
            panel.plot(2.785 * SLIDING / (stiffness * SPEED), stiffness, color=BLACK)
            panel.plot(2.83 * np.sqrt(MASS / stiffness), stiffness, color=BLACK, linestyle="--")
        panel.set(xscale="log", yscale="log", xlabel="step [s]")
        panel.set_xlim(edges(step)[[0, -1]])
        panel.set_ylim(edges(stiffness)[[0, -1]])
        panel.set_title(name)
    axes[0].set_ylabel(r"stiffness $c_0$ [N/m]")
    lines = [plt.Line2D([], [], color=BLACK), plt.Line2D([], [], color=BLACK, linestyle="--")]
    axes[3].legend([Patch(color=c, alpha=0.75) for c in COLOURS] + lines, (*VERDICTS, "bound, slip", "bound, stick"),
                   loc="center left", bbox_to_anchor=(1, 0.5))
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
