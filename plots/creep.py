"""Error against time for a viscoelastic press under a half sine of force, all methods."""

import csv

import style
from style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, plt

# Method in the table of the benchmark: name, colour, marker.
METHODS = {
    "seed_4_28": ("relation 4.28 of Keppler 2006", RED, "D"),
    "growing_convolution": ("Lee-Radok, all of the past again at each step", ORANGE, "s"),
    "growing_contact": ("Lee-Radok, internal variables", GREEN, "P"),
    "springs": ("springs", PURPLE, "v"),
    "springs_richardson": ("springs, Richardson", BLUE, "^"),
    "lee_radok": ("Lee-Radok, closed form", GREY, "o"),
    "ting": ("Ting", BLACK, "*"),
}
ROUNDING = 2.0**-53


def read(path):
    """{(method, t): rows in the order of the steps}"""
    measured = {}
    with path.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            measured.setdefault((row["method"], row["t"]), []).append((float(row["us"]), float(row["error"])))
    return measured


def draw(axes, measured, t, title):
    axes.axhline(ROUNDING, color=GREY, linewidth=0.8, linestyle="--")
    for method, (name, colour, marker) in METHODS.items():
        time, error = zip(*measured[method, t])
        error = [max(e, ROUNDING) for e in error]  # less says nothing more
        axes.loglog(time, error, marker=marker, markersize=8 if marker == "*" else 4.5, linewidth=1, color=colour, label=name)
    axes.set_xlabel("time [µs]")
    axes.set_title(title, loc="left")


def main():
    options = style.arguments(__doc__, 1)
    measured = read(options.input[0])
    figure, (grows, shrinks) = plt.subplots(1, 2, sharex=True, sharey=True, figsize=(style.PAGE, 3.6))
    draw(grows, measured, "0.4", "contact grows: relative error of the approach [-]")
    draw(shrinks, measured, "0.9", "contact shrinks")
    grows.text(0.97, ROUNDING / 2, r"rounding, $2^{-53}$, or less", ha="right", va="top", color=GREY,
               transform=grows.get_yaxis_transform())
    grows.set_ylim(1e-18, 3)
    handles, labels = grows.get_legend_handles_labels()
    figure.get_layout_engine().set(rect=(0, 0.17, 1, 0.83))
    figure.legend(handles, labels, loc="lower center", ncols=3, handlelength=1.4)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
