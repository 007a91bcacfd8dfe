"""Keppler 2006, figure 4.5: pressure under a sphere, exactly and by the first terms of its series."""

import style
from style import BLACK, BLUE, GREEN, ORANGE, RED, plt
from table import Table


def main():
    options = style.arguments(__doc__, 3)
    figure, panels = plt.subplots(1, 3, figsize=(style.PAGE, 2.5))
    for axes, path in zip(panels, options.input):
        table = Table(path)
        rho = table["x_m"] / table["x_m"][-1]
        exact = table["pressure_Pa"]
        peak = table["pressure_sphere_series_1_Pa"][0]
        for n, colour in zip((1, 2, 3, 4), (BLUE, RED, GREEN, ORANGE)):
            axes.plot(rho, table[f"pressure_sphere_series_{n}_Pa"] / peak, color=colour, linewidth=1.1,
                      label=f"$n = {n}$" + (" (Hertz)" if n == 1 else ""))
        axes.plot(rho, exact / peak, color=BLACK, linestyle=(0, (4, 1.5)), label="sphere")
        axes.set_title(f"$a_K / R = {table['x_m'][-1] / table.radius:.1f}$", loc="left")
        axes.set_xlabel("$r / a_K$ [-]")
        axes.set_xlim(0, 1)
        axes.set_ylim(0)
    panels[0].set_ylabel("pressure over Hertz's peak [-]")
    panels[0].legend()
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
