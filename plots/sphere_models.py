"""Error against time for the models of a sphere on a half-space, at three ratios of contact radius and radius."""

import csv

import style
from style import BLACK, BLUE, GREY, RED, plt

METHODS = {"series": ("series, $n$ terms", RED, "D"), "closed form": ("closed form", BLACK, "*"),
           "half-space": ("numerical half-space, $N^2$ cells", BLUE, "s")}
ROUNDING = 2.0**-53


def main():
    options = style.arguments(__doc__, 1)
    with options.input[0].open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    ratios = sorted({float(row["a_over_R"]) for row in rows})
    figure, panels = plt.subplots(1, len(ratios), sharex=True, sharey=True, figsize=(style.PAGE, 2.8))
    for axes, ratio in zip(panels, ratios):
        axes.axhline(ROUNDING, color=GREY, linewidth=0.8, linestyle="--")
        for method, (name, colour, marker) in METHODS.items():
            of_method = [row for row in rows if row["method"] == method and float(row["a_over_R"]) == ratio]
            time = [float(row["ns"]) for row in of_method]
            error = [max(float(row["error_force"]), ROUNDING) for row in of_method]  # less says nothing more
            axes.loglog(time, error, color=colour, marker=marker, markersize=8 if marker == "*" else 4, linewidth=1,
                        linestyle="" if marker == "*" else "-", label=name)
            if method != "closed form":
                last = ((-6, 0), "right") if method == "series" else ((6, 0), "left")
                for i, (offset, side), height in ((0, ((4, 4), "left"), "baseline"), (-1, last, "center")):
                    axes.annotate(of_method[i]["parameter"], (time[i], error[i]), xytext=offset, textcoords="offset points",
                                  color=colour, ha=side, va=height)
        axes.set_title(f"$a_K / R = {ratio:g}$", loc="left")
        axes.set_xlabel("time of a contact [ns]")
    panels[0].set_ylabel("relative error of the force [-]")
    panels[-1].text(0.97, 2 * ROUNDING, r"rounding, $2^{-53}$, or less", color=GREY, ha="right", va="bottom",
                    transform=panels[-1].get_yaxis_transform())
    figure.get_layout_engine().set(rect=(0, 0.1, 1, 0.9))
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=3)
    panels[0].set_xlim(1e2, 5e9)
    panels[0].set_ylim(1e-18, 30)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
