"""Time and error of sampled pressures against the number of cells: exact sums and trees."""

import csv

import style
from style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, plt

# Method in the table of the benchmark: name, colour, marker.
METHODS = {
    "naive sum": ("naive sum", GREY, "s"),
    "exact grid": ("grid, exact", BLACK, "o"),
    "exact mesh": ("triangles, exact", PURPLE, "^"),
    "grid within 1e-12": ("grid, tree, $10^{-12}$", BLUE, "D"),
    "grid within 1e-09": ("grid, tree, $10^{-9}$", GREEN, "v"),
    "grid within 1e-06": ("grid, tree, $10^{-6}$", ORANGE, "P"),
    "mesh within 1e-09": ("triangles, tree, $10^{-9}$", RED, "X"),
}


def names_of_sums():
    return [name for method, (name, _, _) in METHODS.items() if " within " not in method]


def read(path):
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    measured = {}
    for row in rows:
        method = "exact grid" if row["method"] == "exact grid (dispatched)" else row["method"]
        measured.setdefault(method, []).append((int(row["pieces"]), float(row["ns"]), float(row["error"])))
    return {method: sorted(measured[method]) for method in METHODS}


def draw(axes, measured, column, methods):
    for method in methods:
        name, colour, marker = METHODS[method]
        pieces, values = zip(*((row[0], row[column]) for row in measured[method]))
        axes.loglog(pieces, values, marker=marker, markersize=4.5, linewidth=1, color=colour, label=name)
    axes.set_xlim(2e2, 3e6)
    axes.set_xlabel("cells or triangles [-]")


def main():
    options = style.arguments(__doc__, 1)
    measured = read(options.input[0])
    trees = [method for method in METHODS if " within " in method]

    figure, (time, error) = plt.subplots(1, 2, figsize=(style.PAGE, 3.2))
    draw(time, measured, 1, METHODS)
    time.set_title("time of a wrench [ns]", loc="left")
    # What doubles with the cells, from the exact sums of the least grid.
    cells, least, _ = measured["exact grid"][0]
    time.loglog([cells, 2e6], [2 * least, 2 * least * 2e6 / cells], color=GREY, linewidth=0.8, linestyle="--")
    time.text(1e6, 2 * least * 1e6 / cells, "$\\propto$ cells ", color=GREY, ha="right", va="bottom")
    sums = [(line, line.get_label()) for line in time.get_lines() if line.get_label() in names_of_sums()]
    time.legend(*zip(*sums), loc="upper left", handlelength=1)

    draw(error, measured, 2, trees)
    error.set_title(r"greatest error of $f$ and $m/a$ [-]", loc="left")
    for method in trees:
        tolerance = float(method.split()[-1])
        error.axhline(tolerance, color=METHODS[method][1], linewidth=0.8, linestyle=":")
    error.set_ylim(1e-17, 1e-5)
    error.text(2.6e6, 1.3e-6, "dotted: tolerances", ha="right", va="bottom", color=GREY)
    error.legend(loc="center", bbox_to_anchor=(0.5, 0.79), ncol=2, handlelength=1)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
