"""What the same answer costs: error against time of a sphere on a half-space, closed form, numerical half-space, finite elements."""

import csv
import json
import math

import style
from style import BLACK, BLUE, GREY, ORANGE, plt

RATIO = 0.5  # a / R
METHODS = {"closed form": ("closed form", BLACK, "*"), "half-space": ("numerical half-space, $N^2$ cells", BLUE, "s")}
ROUNDING = 2.0**-53


def annotate(axes, texts, x, y, colour):
    for text, *at in zip(texts, x, y):
        axes.annotate(text, at, xytext=(4, 4), textcoords="offset points", color=colour)


def main():
    options = style.arguments(__doc__, 2)
    models, finite_elements = options.input
    with models.open(encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if float(row["a_over_R"]) == RATIO]
    meshes = json.loads(finite_elements.read_text(encoding="utf-8"))["meshes"]
    figure, axes = plt.subplots(figsize=(style.PAGE * 0.7, 2.9))
    axes.axhline(ROUNDING, color=GREY, linewidth=0.8, linestyle="--")
    for method, (name, colour, marker) in METHODS.items():
        of_method = [row for row in rows if row["method"] == method]
        time = [float(row["ns"]) * 1e-9 for row in of_method]
        error = [max(float(row["error_force"]), ROUNDING) for row in of_method]  # less says nothing more
        axes.loglog(time, error, color=colour, marker=marker, markersize=8 if marker == "*" else 4, linewidth=1,
                    linestyle="" if marker == "*" else "-", label=name)
        if method == "half-space":
            annotate(axes, [row["parameter"] for row in of_method], time, error, colour)
    approach = math.atanh(RATIO)  # of the contact radius 1: a artanh(a / R)
    time = [mesh["seconds"] for mesh in meshes]
    error = [abs(mesh["values"][0][0] / approach - 1) for mesh in meshes]
    axes.loglog(time, error, color=ORANGE, marker="^", markersize=4, linewidth=1, label="finite elements (approach), $n$ per radius")
    annotate(axes, [f"{mesh['elements']:g}" for mesh in meshes], time, error, ORANGE)
    axes.set_xlabel("time of a contact [s]")
    axes.set_ylabel("relative error of the force [-]")
    axes.set_title(f"$a_K / R = {RATIO:g}$", loc="left")
    axes.set_xlim(1e-8, 1e3)
    axes.set_ylim(1e-17, 1)
    axes.legend(loc="center right")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
