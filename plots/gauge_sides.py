"""The side that every cheap gauge errs on, over the direction of the load: ellipsoids above, quartics and discs below."""

import gauge_models
import style
from gauge_models import MODELS, PATCHES
from style import GREY, plt

COLUMNS = 6
ELLIPSOIDS = [model for model in MODELS if model.startswith("ellipsoid")]
OTHERS = [model for model in MODELS if model not in ELLIPSOIDS + ["round", "newton"]]
# Titles of narrow panels, by patch and direction of the force [deg].
TITLES = {
    ("power_disc", "0"): "power law,\n$n = 0.3$",
    ("xydas_kao_disc", "0"): "Xydas–Kao,\n" + r"$\alpha = 1.8$",
    ("hertz_ellipse_3", "0"): "ellipse 3 : 1,\nforce along",
    ("rectangle", "0"): "rectangle 4 : 1,\nforce along",
    ("rectangle", "90"): "rectangle 4 : 1,\nforce across",
    ("pressure_grid", "0"): "sampled\npressure",
}
VIEWS = [(patch, "0") for patch in PATCHES]
VIEWS.insert(VIEWS.index(("rectangle", "0")) + 1, ("rectangle", "90"))
LIMITS = {"ellipsoids": (-22, 26), "others": (-5, 6)}  # [%]


def draw(axes, rows, models):
    axes.axhspan(-100, 0, color="#F2F2F2", linewidth=0)
    axes.axhline(0, color=GREY, linewidth=0.8)
    for model in models:
        name, colour, _, line = MODELS[model]
        curve = [row for row in rows if row["method"] == model]
        axes.plot([float(row["angle_deg"]) for row in curve], [100 * float(row["error"]) for row in curve], color=colour,
                  linestyle=line, linewidth=1, label=name)


def main():
    options = style.arguments(__doc__, 1)
    rows = gauge_models.read(options.input[0])
    figure, panels = plt.subplots(4, COLUMNS, sharex=True, sharey="row", figsize=(style.PAGE, 7.2))
    for k, (patch, direction) in enumerate(VIEWS):
        view = [row for row in rows if (row["patch"], row["force_direction_deg"]) == (patch, direction)]
        top = 2 * (k // COLUMNS)
        upper, lower = panels[top][k % COLUMNS], panels[top + 1][k % COLUMNS]
        draw(upper, view, ELLIPSOIDS)
        draw(lower, view, OTHERS)
        upper.set_title(TITLES.get((patch, direction), PATCHES[patch]), loc="left", fontsize=8)
        upper.set_ylim(*LIMITS["ellipsoids"])
        lower.set_ylim(*LIMITS["others"])
        lower.set_xlim(0, 90)
        lower.set_xticks([0, 45, 90], ["0", "45", "90"])
        for label, side in zip(lower.get_xticklabels(), ("left", "center", "right")):
            label.set_ha(side)
    first = panels[0][0]
    for side, y, at in (("too large: safe", 0.97, "top"), ("too small: unsafe", 0.03, "bottom")):
        first.text(0.04, y, side, ha="left", va=at, transform=first.transAxes, fontsize=7)
    figure.supylabel("error of the gauge [%]", fontsize=9)
    figure.text(0.53, 0.128, r"direction of the load, $\arctan\,M / (l F)$ with $l = M_0 / (\mu F_N)$: "
                "0° a force, 90° a moment [°]", ha="center", va="center", fontsize=9)
    figure.get_layout_engine().set(rect=(0, 0.14, 1, 0.86))
    upper, lower = panels[0][0].get_legend_handles_labels(), panels[1][0].get_legend_handles_labels()
    figure.legend(*upper, loc="upper left", ncols=2, bbox_to_anchor=(0, 0.115), title="in the upper panels", fontsize=7,
                  columnspacing=1)
    figure.legend(*lower, loc="upper right", ncols=2, bbox_to_anchor=(1, 0.115), title="in the lower panels", fontsize=7,
                  columnspacing=1)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
