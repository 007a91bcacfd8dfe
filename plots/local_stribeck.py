"""Where Stribeck's law in the mean is good enough: its distance from the law at each point, over pole and speed."""

import csv

import numpy as np
import style
from matplotlib.colors import LogNorm
from style import BLACK, plt

PATCHES = {
    "hertz_disc": ("Hertz disc", "distance of the pole / radius [-]"),
    "hertz_ellipse_3_1": ("Hertz ellipse 3 : 1", "pole on the axis / semi-axis [-]"),
    "rectangle_4_1": ("rectangle 4 : 1", "pole on the axis / half length [-]"),
    "rectangle_20_1": ("rectangle 20 : 1", "pole on the axis / half length [-]"),
}
LEVELS = [1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1, 3e-1]


def read(path):
    """{patch: (poles, speeds, size of both differences together)}"""
    rows = {}
    with path.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            apart = np.hypot(float(row["force"]), float(row["moment"]))
            rows.setdefault(row["patch"], {})[float(row["pole"]), float(row["v_m_over_v_S"])] = apart
    result = {}
    for patch, points in rows.items():
        poles, speeds = (np.array(sorted(set(axis))) for axis in zip(*points))
        result[patch] = poles, speeds, np.array([[points[p, s] for p in poles] for s in speeds])
    return result


def main():
    options = style.arguments(__doc__, 1)
    compared = read(options.input[0])
    figure, all_axes = plt.subplots(2, 2, sharex=True, sharey=True, figsize=(style.PAGE, 5.8))
    for axes, (patch, (name, pole)) in zip(all_axes.flat, PATCHES.items()):
        poles, speeds, apart = compared[patch]
        apart = np.maximum(apart, LEVELS[0] / 10)
        filled = axes.contourf(poles, speeds, apart, LEVELS, norm=LogNorm(LEVELS[0], LEVELS[-1]), cmap="Blues", extend="min")
        axes.contour(poles, speeds, apart, LEVELS, colors=BLACK, linewidths=0.5)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel(pole)
        axes.set_title(name, loc="left")
        axes.grid(False)
    for axes in all_axes[:, 0]:
        axes.set_ylabel(r"mean speed $v_m / v_S$ [-]")
    bar = figure.colorbar(filled, ax=all_axes, ticks=LEVELS, format=lambda level, _: f"{level:g}")
    bar.set_label(r"|local $-$ mean| per $(\mu_s - \mu_k) F_N$ [-]")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
