"""Error against time for the friction wrench of a Hertz disc, all methods."""

import csv

import style
from style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, plt

# Method in the table of the benchmark: name, colour, marker.
METHODS = {
    "naive_sum": ("naive sum, $n \\times n$ points", ORANGE, "s"),
    "gsl_quadrature": ("adaptive\nquadrature (GSL)", GREY, "^"),
    "seed_polynomial": ("polynomials\nof Keppler 2006", RED, "D"),
    "textbook": ("closed form with asin", PURPLE, "v"),
    "table": ("table, any round pressure", GREEN, "P"),
    "exact": ("exact, one pole a call", BLUE, "o"),
    "batch": ("exact, 1024 poles a call", BLACK, "*"),
}
IN_LEGEND = ("textbook", "table", "exact", "batch")
ROUNDING = 2.0**-53


def read(path):
    """{method: rows over the near poles, in the order of the parameter}"""
    with path.open(encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(line for line in file if not line.startswith("#")) if row["mix"] == "near"]
    return {method: [row for row in rows if row["method"] == method] for method in METHODS}


def position(row, quantity):
    return float(row["ns"]), float(row["error_" + quantity])


def draw(axes, measured, quantity):
    axes.axhline(ROUNDING, color=GREY, linewidth=0.8, linestyle="--")
    axes.text(1.4e8, ROUNDING / 2, r"rounding, $2^{-53}$", ha="right", va="top", color=GREY)
    for method, (name, colour, marker) in METHODS.items():
        time, error = zip(*(position(row, quantity) for row in measured[method]))
        axes.loglog(time, error, marker=marker, markersize=8 if marker == "*" else 4.5, linewidth=1, color=colour, label=name)
    axes.set_xlabel("time of an evaluation [ns]")
    axes.set_title(f"worst relative error of the {quantity} [-]", loc="left")


def annotate(axes, row, quantity, text, offset, **options):
    axes.annotate(text, position(row, quantity), xytext=offset, textcoords="offset points", **options)


def name_series(axes, measured, quantity):
    def label(method, row, offset, **options):
        annotate(axes, row, quantity, METHODS[method][0], offset, color=METHODS[method][1], fontweight="bold", **options)

    naive, quadrature = measured["naive_sum"], measured["gsl_quadrature"]
    label("seed_polynomial", measured["seed_polynomial"][0], (-14, -8), va="top")
    label("naive_sum", naive[0], (14, 3))
    label("gsl_quadrature", quadrature[0], (-6, -10), ha="right", va="top")
    for row in naive:
        if row["parameter"] in ("5", "21", "201"):
            annotate(axes, row, quantity, f"{row['parameter']}²", (-2, -5), ha="right", va="top")
    annotate(axes, quadrature[0], quantity, "tolerance $10^{-3}$", (4, 4))
    annotate(axes, quadrature[-1], quantity, "$10^{-10}$", (5, 1))


def main():
    options = style.arguments(__doc__, 1)
    measured = read(options.input[0])

    figure, (force, moment) = plt.subplots(1, 2, sharex=True, sharey=True, figsize=(style.PAGE, 3.5))
    draw(force, measured, "force")
    draw(moment, measured, "moment")
    force.set_xlim(1, 2e8)
    force.set_ylim(1e-18, 10)
    name_series(force, measured, "force")
    handles = {name: handle for handle, name in zip(*force.get_legend_handles_labels())}
    force.legend([handles[METHODS[method][0]] for method in IN_LEGEND], [METHODS[method][0] for method in IN_LEGEND],
                 loc="lower left", bbox_to_anchor=(0.19, 0.15), handlelength=1)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
