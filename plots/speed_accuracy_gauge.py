"""Error against time for the gauge of a load, all methods, on three patches."""

import csv

import style
from style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY, plt

# Method in the table of the benchmark: name, colour, marker.
METHODS = {
    "ellipsoid_axis": ("axis ellipsoid", ORANGE, "s"),
    "ellipsoid_even": ("best ellipsoid", SKY, "^"),
    "seed": ("polynomial of Keppler 2006", RED, "D"),
    "quartic_even": ("convex quartic", PURPLE, "v"),
    "fast": ("Hertz, to $10^{-9}$", GREEN, "P"),
    "exact": ("Hertz, exact", BLACK, "*"),
    "round": ("any round patch, exact", GREY, "X"),
    "newton": ("any patch: Newton, gap $10^{-1}$ to $10^{-12}$", BLUE, "o"),
}
SIZES = {"exact": 8, "seed": 8, "quartic_even": 4}
PATCHES = {"hertz_disc": "Hertz disc", "rectangle": "rectangle 4 : 1", "l_shape": "L-shape"}
ROUNDING = 2.0**-53


def main():
    options = style.arguments(__doc__, 1)
    with options.input[0].open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    figure, panels = plt.subplots(1, len(PATCHES), sharex=True, sharey=True, figsize=(style.PAGE, 3.5))
    for axes, (patch, title) in zip(panels, PATCHES.items()):
        axes.axhline(ROUNDING, color=GREY, linewidth=0.8, linestyle="--")
        for method, (name, colour, marker) in METHODS.items():
            of_method = [row for row in rows if row["patch"] == patch and row["method"] == method]
            axes.loglog([float(row["ns"]) for row in of_method], [float(row["error"]) for row in of_method], color=colour,
                        marker=marker, markersize=SIZES.get(method, 5), linewidth=1, linestyle="-" if method == "newton" else "",
                        label=name)
        axes.set_title(title, loc="left")
        axes.set_xlabel("time of a gauge [ns]")
    panels[0].set_ylabel("worst relative error [-]")
    panels[-1].text(0.03, 2 * ROUNDING, r"rounding, $2^{-53}$", color=GREY, ha="left", va="bottom",
                    transform=panels[-1].get_yaxis_transform())
    panels[0].set_xlim(2, 6e4)
    panels[0].set_ylim(1e-17, 1)
    figure.get_layout_engine().set(rect=(0, 0.2, 1, 0.8))
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=3, handlelength=1.5)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
