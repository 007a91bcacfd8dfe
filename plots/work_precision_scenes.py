"""Errors of an event's time and of the last place against CPU time: smooth laws of five scenes by our integrator and by those of SUNDIALS."""

import numpy as np

import style
from style import BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, plt
from table import Table

INTEGRATORS = (("dopri5", "ours", BLACK, "o"), ("cvode_bdf", "CVODE BDF", BLUE, "s"),
               ("cvode_adams", "CVODE Adams", ORANGE, "D"), ("arkode_erk", "ARKODE, Dormand and Prince", GREEN, "^"),
               ("arkode_dirk", "ARKODE, Kvaerno", SKY, "v"), ("ida", "IDA, of the implicit law", PURPLE, "X"))
SCENES = (("example_4_7", "elastoplastic point"), ("figure_4_30", "elastoplastic disc"),
          ("block_half_freedom", "half a degree of freedom"), ("oscillation_lugre", "LuGre, oscillating load"),
          ("figure_4_15_tanh", "tanh"))
FLOOR = 1e-15  # what rounding leaves, s and m


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    figure, axes = plt.subplots(2, 3, sharey=True, figsize=(style.PAGE, 4.4))
    for panel, (scene, title) in zip(axes.flat, SCENES):
        for integrator, name, colour, marker in INTEGRATORS:
            rows = (table["scene"] == scene) & (table["integrator"] == integrator)
            panel.loglog(table["us"][rows], np.maximum(table["event_error_s"][rows], FLOOR), color=colour, marker=marker, markersize=4,
                         linewidth=1, label=name)
            panel.loglog(table["us"][rows], np.maximum(table["place_error_m"][rows], FLOOR), color=colour, linestyle=":", linewidth=1)
        decades = np.log10(table["us"][table["scene"] == scene])
        panel.set_xlim(10 ** np.floor(decades.min()), 10 ** np.ceil(decades.max()))
        panel.set_title(title)
        panel.set_xlabel(r"CPU time [$\mu$s]")
    figure.supylabel("error of the event [s], dotted: of the last place [m]", fontsize=9)
    rest = axes.flat[-1]
    rest.axis("off")
    rest.legend(*axes.flat[0].get_legend_handles_labels(), loc="center")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
