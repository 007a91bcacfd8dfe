"""Keppler 2006, figure 4.9: creep of a standard linear solid under a ball with a constant load."""

import numpy as np

import style
from style import BLACK, BLUE, GREEN, ORANGE, RED, plt
from table import Table


def main():
    options = style.arguments(__doc__, 2)
    history, surface = (Table(path) for path in options.input)
    t, delta, seed = history["t_s"], 1e3 * history["approach_m"], 1e3 * history["seed_approach_m"]
    # The printed rate form, from delta(0) = 0: it tends to the approach at once, not to the relaxed one.
    rate = history.number("alpha =", " 1/s")
    printed = delta[0] * (1 - np.exp(-rate * t))

    figure, (approaches, displacements, pressures) = plt.subplots(1, 3, figsize=(style.PAGE, 2.6))
    approaches.plot(t, delta, color=BLUE, label="exact (Lee, Radok)")
    approaches.plot(t, seed, color=RED, linestyle="--", linewidth=1,
                    label="Keppler's relation (4.28),\nlinear in $F^{2/3}$")
    approaches.plot(t, printed, color=ORANGE, linestyle="--", linewidth=1, label="his rate form (4.72),\n$\\delta(0) = 0$")
    approaches.set_xlabel("time [s]")
    approaches.set_ylabel(r"approach $\delta$ [mm]")
    approaches.set_xlim(0, t[-1])
    approaches.set_ylim(0, 27)
    approaches.legend(loc="upper left", fontsize=7)
    for time, colour in zip(np.unique(surface["t_s"]), (BLUE, GREEN, ORANGE, BLACK)):
        row = surface["t_s"] == time
        r = 1e3 * surface["x_m"][row]
        displacements.plot(r, 1e3 * surface["displacement_m"][row], color=colour, label=f"{time:g} s")
        pressures.plot(r, 1e-3 * surface["pressure_Pa"][row], color=colour)
    displacements.set_ylim(displacements.get_ylim()[1], 0)
    displacements.set_ylabel("displacement $u_z$ [mm]")
    displacements.legend()
    pressures.set_ylabel("pressure [kPa]")
    pressures.set_ylim(0)
    for axes in (displacements, pressures):
        axes.set_xlabel("$r$ [mm]")
        axes.set_xlim(0, r[-1])
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
