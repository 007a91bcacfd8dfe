"""Error against time for the gauge of a load: every model, eleven patches; below, the errors of the fastest."""

import gauge_models
import style
from gauge_models import MODELS, PATCHES
from style import GREY, plt

COLUMNS = 4
SIZES = {"exact": 8, "newton": 3}
HOLLOW = ("ellipsoid_safe", "quartic_safe")
FITTED = [model for model in MODELS if model.startswith(("ellipsoid", "quartic"))] + ["seed"]
ROUNDING = 2.0**-53


def look(model):
    _, colour, marker, _ = MODELS[model]
    return {"color": colour, "marker": marker, "markersize": SIZES.get(model, 4), "linewidth": 1, "markeredgewidth": 0.8,
            "linestyle": "-" if model == "newton" else "", "markerfacecolor": "white" if model in HOLLOW else colour}


def draw_times(axes, rows):
    axes.axhline(ROUNDING, color=GREY, linewidth=0.8, linestyle="--")
    for model, (name, *_) in MODELS.items():
        of_model = [row for row in rows if row["method"] == model]
        axes.loglog([float(row["ns"]) for row in of_model], [float(row["error"]) for row in of_model], label=name,
                    **look(model))


def draw_errors(axes, rows):
    """A line a patch: what stands in one spot of the panels above."""
    patches = list(PATCHES)
    for model in FITTED:
        of_model = [row for row in rows if row["method"] == model]
        axes.semilogx([float(row["error"]) for row in of_model], [patches.index(row["patch"]) for row in of_model],
                      **look(model))
    axes.set_yticks(range(len(patches)), PATCHES.values())
    axes.set_ylim(len(patches) - 0.5, -0.5)
    times = [float(row["ns"]) for row in rows if row["method"] in FITTED]
    axes.set_xlabel(f"worst relative error of the gauges that take {min(times):.0f} to {max(times):.0f} ns [-]")


def main():
    options = style.arguments(__doc__, 1)
    rows = gauge_models.read(options.input[0])
    lines = -(-len(PATCHES) // COLUMNS)
    figure = plt.figure(figsize=(style.PAGE, 9.2))
    grid = figure.add_gridspec(lines + 1, COLUMNS, height_ratios=[1] * lines + [1.5])
    panels = []
    for k, (patch, title) in enumerate(PATCHES.items()):
        first = panels[0] if panels else None
        axes = figure.add_subplot(grid[k // COLUMNS, k % COLUMNS], sharex=first, sharey=first)
        draw_times(axes, [row for row in rows if row["patch"] == patch])
        axes.set_title(title, loc="left")
        axes.tick_params(labelleft=k % COLUMNS == 0, labelbottom=k + COLUMNS >= len(PATCHES))
        panels.append(axes)
    panels[-2].set_xlabel("time of a gauge [ns]")
    panels[0].set_xlim(2, 1e6)
    panels[0].set_ylim(1e-17, 3)
    panels[COLUMNS].set_ylabel("worst relative error of the gauge [-]")
    panels[-2].text(0.04, 2 * ROUNDING, "rounding", color=GREY, ha="left", va="bottom", fontsize=7,
                    transform=panels[-2].get_yaxis_transform())
    draw_errors(figure.add_subplot(grid[lines, :]), rows)
    figure.get_layout_engine().set(rect=(0, 0.12, 1, 0.88))
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=3, handlelength=1.5)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
