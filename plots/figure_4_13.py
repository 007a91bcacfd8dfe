"""Keppler 2006, figure 4.13: force against contact radius with adhesion (Example 4.6)."""

import json

import style
from style import BLACK, BLUE, GREY, ORANGE, RED, plt
from table import Table


def main():
    options = style.arguments(__doc__, 2)
    table = Table(options.input[0])
    states = json.loads(options.input[1].read_text(encoding="utf-8"))["results"]
    a, force = 1e3 * table["contact_radius_m"], 1e3 * table["normal_force_N"]
    figure, axes = plt.subplots(figsize=(style.COLUMN, 2.9))
    axes.axhline(0, color=GREY, linewidth=0.8)

    def state(name):
        return 1e3 * states[name + "_radius"]["value"], 1e3 * states[name + "_force"]["value"]

    pull_off, held, jump, rest = (state(name) for name in ("pull_off", "pull_off_held", "jump_in", "no_load"))
    for zone, line in ((a >= pull_off[0], "-"), ((a < pull_off[0]) & (a >= held[0]), "--"), (a < held[0], ":")):
        axes.plot(a[zone], force[zone], color=BLUE, linestyle=line)
    axes.plot(1e3 * table["dmt_contact_radius_m"], 1e3 * table["dmt_normal_force_N"], color=ORANGE, linewidth=1)
    axes.plot(1e3 * table["hertz_contact_radius_m"], 1e3 * table["hertz_normal_force_N"], color=BLACK, linewidth=1)
    for (x, y), text, offset, side in ((rest, "no load (A)", (8, -9), "left"), (pull_off, "pull-off\nunder load (B)", (4, -22), "left"),
                                       (held, "pull-off\nheld", (-4, -22), "right")):
        axes.plot(x, y, "o", color=RED, markersize=4)
        axes.annotate(text, (x, y), xytext=offset, textcoords="offset points", color=RED, ha=side)
    axes.set_xlim(0, 1.8)
    axes.set_ylim(-8, 14)
    axes.text(1.03, 11, "Hertz", color=BLACK, ha="right")
    axes.text(1.74, 7.5, "JKR", color=BLUE, ha="right")
    axes.text(1.09, 3.4, "DMT", color=ORANGE)
    axes.set_xlabel("contact radius $a_K$ [mm]")
    axes.set_ylabel("normal force $F_N$ [mN]")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
