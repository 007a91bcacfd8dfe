"""Error against time for the friction wrench: every kind of patch, every method that works on it."""

import csv
import math

import style
from matplotlib.lines import Line2D
from style import BLUE, GREY, ORANGE, PURPLE, RED, plt

PATCHES = {
    "hertz_disc": "Hertz disc",
    "flat_punch_disc": "flat punch",
    "uniform_disc": "uniform disc",
    "ring": "ring",
    "power_disc": "power law, $n = 0.3$",
    "xydas_kao_disc": r"Xydas–Kao, $\alpha = 1.8$",
    "stamp_disc": "stamp $\\propto r^4$",
    "hertz_ellipse_3": "Hertz ellipse 3 : 1",
    "hertz_ellipse_100": "Hertz ellipse 100 : 1",
    "rectangle": "rectangle 4 : 1",
    "l_shape": "L-shape",
    "pressure_grid": "pressure on a grid",
    "pressure_mesh": "pressure on triangles",
    "line_load": "line load",
    "two_patches": "two patches, placed",
}
# Method: name, colour, marker.
METHODS = {
    "exact": ("exact", BLUE, "o"),
    "seed_polynomial": ("polynomials of Keppler 2006", RED, "D"),
    "sampled": ("sampled on $n \\times n$ cells", PURPLE, "v"),
    "point_sum": ("naive sum, $n \\times n$ points", ORANGE, "s"),
    "gsl_quadrature": ("adaptive quadrature (GSL)", GREY, "^"),
}
# Poles: name, line, whether the marker is filled.
POLES = {
    "near": ("near the zone", "-", True),
    "rim": ("at its rim", "--", False),
    "far": ("far away", ":", True),
}
COLUMNS = 4
ROUNDING = 2.0**-53


def look(method, poles):
    _, colour, marker = METHODS[method]
    _, line, filled = POLES[poles]
    size = 3 if poles == "far" else 4
    return {"color": colour, "marker": marker, "markersize": size, "linestyle": line, "linewidth": 0.9,
            "markeredgewidth": 0.8, "markerfacecolor": colour if filled else "white"}


def draw(axes, rows, unit):
    axes.axhline(ROUNDING, color=GREY, linewidth=0.8, linestyle="--", zorder=1)
    for method in reversed(METHODS):
        for poles in POLES:
            curve = [row for row in rows if (row["method"], row["mix"]) == (method, poles)]
            axes.loglog([float(row["ns"]) / unit for row in curve], [float(row["error_wrench"]) for row in curve],
                        **look(method, poles))


def tuned(rows, method):
    return sorted({float(row["parameter"]) for row in rows if row["method"] == method})


def judged(rows, column, value):
    """The number of poles that errors were taken over."""
    return min(int(row["judged"]) for row in rows if row[column] == value)


def explain(axes, rows):
    axes.axis("off")
    methods = [Line2D([], [], linestyle="", color=colour, marker=marker, markersize=4, label=name)
               for name, colour, marker in METHODS.values()]
    poles = [Line2D([], [], label=name, **{**look("exact", key), "color": GREY, "markeredgecolor": GREY,
                                            "markerfacecolor": GREY if filled else "white"})
             for key, (name, _, filled) in POLES.items()]
    first = axes.legend(handles=methods, loc="upper left", bbox_to_anchor=(-0.2, 1.16), fontsize=7, handlelength=1,
                        borderpad=0, labelspacing=0.35)
    axes.add_artist(first)
    axes.legend(handles=poles, loc="lower left", bbox_to_anchor=(-0.2, -0.2), fontsize=7, handlelength=2, borderpad=0,
                labelspacing=0.35, title="the pole is", title_fontsize=7, alignment="left")
    sides = ", ".join(f"{n:g}" for n in tuned(rows, "point_sum"))
    tolerances = ", ".join(f"$10^{{{math.log10(t):.0f}}}$" for t in reversed(tuned(rows, "gsl_quadrature")))
    xydas_kao = judged([row for row in rows if row["method"] != "gsl_quadrature"], "patch", "xydas_kao_disc")
    axes.text(-0.16, 0.59, f"$n$ = {sides}\ntolerance {tolerances}\n"
              f"worst over {max(int(row['judged']) for row in rows)} poles, of the\n"
              f"quadrature {judged(rows, 'method', 'gsl_quadrature')}, Xydas–Kao {xydas_kao}",
              fontsize=7, va="top", transform=axes.transAxes)


def main():
    options = style.arguments(__doc__, 1)
    with options.input[0].open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    unit = min(float(row["ns"]) for row in rows
               if (row["method"], row["patch"], row["mix"]) == ("exact", "hertz_disc", "near"))
    lines = -(-(len(PATCHES) + 1) // COLUMNS)
    figure, panels = plt.subplots(lines, COLUMNS, sharex=True, sharey=True, figsize=(style.PAGE, 7))
    for axes, (patch, title) in zip(panels.flat, PATCHES.items()):
        draw(axes, [row for row in rows if row["patch"] == patch], unit)
        axes.set_title(title, loc="left", fontsize=8)
    panels[0][0].set_xlim(0.2, 2e7)
    panels[0][0].set_xticks([1, 1e2, 1e4, 1e6])
    panels[0][0].set_ylim(1e-17, 3)
    panels[0][0].text(0.97, ROUNDING * 2, r"rounding, $2^{-53}$", color=GREY, ha="right", va="bottom", fontsize=7,
                      transform=panels[0][0].get_yaxis_transform())
    for axes in panels.flat[len(PATCHES):]:
        explain(axes, rows)
    for axes in panels[-2][-(len(panels.flat) - len(PATCHES)):]:
        axes.tick_params(labelbottom=True)
    figure.supxlabel("time of a wrench over that of the Hertz disc, exact, near [-]", fontsize=9)
    figure.supylabel(r"worst error of the wrench $(F, M / l)$ over its size [-],  $l = M_0 / (\mu F_N)$", fontsize=9)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
