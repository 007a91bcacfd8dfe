"""Force and moment against the distance of the pole, for six pressures on the same disc."""

import numpy as np

import style
from style import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED, plt
from table import Table

# By the name of the scene, from the load at the rim to the load in the middle.
PRESSURES = {
    "discs_ring": ("thin ring", BLACK, "-"),
    "discs_flat_punch": ("flat punch", ORANGE, "--"),
    "discs_uniform": ("uniform", GREEN, "-"),
    "discs_xydas_kao": (r"Xydas–Kao, $\alpha = 1.8$", PURPLE, "-."),
    "discs_hertz": ("Hertz", BLUE, "-"),
    "discs_power": (r"$(1 - r^2/a^2)^{3/2}$", RED, "--"),
}


def main():
    options = style.arguments(__doc__, "+")
    tables = {path.stem: Table(path) for path in options.input}

    figure, (force, moment) = plt.subplots(1, 2, figsize=(style.PAGE, 2.9))
    for scene, (name, colour, dashes) in PRESSURES.items():
        table = tables[scene]
        x = table.pole_distance / table.radius
        scale = table.friction_force
        force.plot(x, table.force / scale, color=colour, linestyle=dashes, label=name)
        moment.plot(x, np.abs(table["moment_Nm"]) / (scale * table.radius), color=colour, linestyle=dashes, label=name)
    for axes, quantity in ((force, r"force $|F| / (\mu F_N)$ [-]"), (moment, r"moment $|M| / (\mu F_N a)$ [-]")):
        axes.set_xlabel(r"distance of the pole $r_M / a$ [-]")
        axes.set_ylabel(quantity)
        axes.set_xlim(0, 3)
        axes.set_ylim(0, 1.05)
        axes.axvline(1, color=style.GREY, linewidth=0.6)
    moment.legend(loc="upper right", title="pressure", alignment="left")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
