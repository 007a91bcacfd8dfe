"""The side that cheap gauges err on, over the direction of the load: a Hertz disc and a rectangle 4 : 1."""

import csv

import style
from style import BLUE, GREY, ORANGE, PURPLE, RED, plt

# Method in the table of the benchmark: name, colour, line.
METHODS = {
    "ellipsoid_axis": ("axis ellipsoid", ORANGE, "-"),
    "ellipsoid_even": ("best ellipsoid", BLUE, "-"),
    "ellipsoid_safe": ("best ellipsoid, made safe", BLUE, "--"),
    "quartic_even": ("convex quartic", PURPLE, "-"),
    "quartic_safe": ("convex quartic, made safe", PURPLE, "--"),
    "seed": ("polynomial of Keppler 2006 (disc)", RED, "-"),
}
PANELS = {
    ("hertz_disc", "0"): "Hertz disc",
    ("rectangle", "0"): "rectangle, force along it",
    ("rectangle", "90"): "rectangle, force across it",
}


def main():
    options = style.arguments(__doc__, 1)
    with options.input[0].open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    figure, panels = plt.subplots(1, len(PANELS), sharex=True, sharey=True, figsize=(style.PAGE, 3.3))
    for axes, ((patch, direction), title) in zip(panels, PANELS.items()):
        axes.axhspan(-100, 0, color="#F2F2F2", linewidth=0)
        axes.axhline(0, color=GREY, linewidth=0.8)
        for method, (name, colour, line) in METHODS.items():
            curve = [row for row in rows if (row["patch"], row["force_direction_deg"], row["method"]) == (patch, direction, method)]
            axes.plot([float(row["angle_deg"]) for row in curve], [100 * float(row["error"]) for row in curve], color=colour,
                      linestyle=line, linewidth=1.2, label=name)
        axes.set_title(title, loc="left")
        axes.set_xticks([0, 30, 60, 90], ["0\nforce", "30", "60", "90\nmoment"])
        for label, side in zip(axes.get_xticklabels(), ("left", "center", "center", "right")):
            label.set_ha(side)
    figure.supxlabel(r"direction of the load, $\arctan\,M / (l F)$ with $l = M_0 / (\mu F_N)$ [°]", fontsize=9, y=0.17)
    panels[0].set_ylabel("error of the gauge [%]")
    panels[0].text(0.04, 0.97, "too large: safe", ha="left", va="top", transform=panels[0].transAxes)
    panels[0].text(0.04, 0.03, "too small: unsafe", ha="left", va="bottom", transform=panels[0].transAxes)
    panels[0].set_xlim(0, 90)
    panels[0].set_ylim(-15, 18)
    figure.get_layout_engine().set(rect=(0, 0.22, 1, 0.78))
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=3)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
