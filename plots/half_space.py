"""Error of the numerical half-space against the number of cells, and against time, on Hertz' contact."""

import numpy as np

import style
from style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, plt
from table import Table

# Column of the table: name, colour, marker.
ERRORS = {
    "counted_area_error": ("area, counted cells", GREY, "s"),
    "peak_error": ("peak pressure", ORANGE, "^"),
    "area_error": ("area, sub-cell edge", GREEN, "P"),
    "inverse_error": ("inverse problem, rms", PURPLE, "v"),
    "force_error": ("force", BLUE, "o"),
    "approach_error": ("approach", RED, "D"),
}


def guide(axes, cells, start, order, text):
    """A line of this order of convergence below the curves."""
    axes.loglog(cells, start * (cells / cells[0]) ** -order, color=BLACK, linewidth=0.6, linestyle=":")
    axes.annotate(text, (cells[-1], start * (cells[-1] / cells[0]) ** -order), xytext=(4, 0), textcoords="offset points",
                  va="center", fontsize=7)


def draw_convergence(axes, table):
    cells = table["cells"].astype(float)
    height = np.inf  # of the last label: labels keep apart
    for column, (name, colour, marker) in sorted(ERRORS.items(), key=lambda item: -table[item[0]][-1]):
        axes.loglog(cells, table[column], marker=marker, markersize=4.5, color=colour)
        height = min(1.5 * table[column][-1], height / 2.1)
        axes.text(1.15 * cells[-1], height, name, color=colour, va="center", fontsize=7)
    guide(axes, cells[[0, -1]], 3e-3, 1, "order 1")
    guide(axes, cells[[0, -1]], 1.5e-5, 2, "order 2")
    axes.set_xlabel("cells a side, $N$ [-]")
    axes.set_title("relative error [-]", loc="left")
    axes.set_xticks(cells, [f"{n:.0f}" for n in cells])
    axes.minorticks_off()
    axes.set_xlim(cells[0] / 1.15, cells[-1] * 7)
    axes.set_ylim(2e-8, 0.1)


def draw_work(axes, table):
    cells = table["cells"]
    for time, error, estimate, (name, colour, marker) in (
        ("by_approach_s", "force_error", "force_estimate", ERRORS["force_error"]),
        ("by_force_s", "approach_error", "approach_estimate", ERRORS["approach_error"]),
    ):
        pairs = table[time] / table["pair_s"]
        axes.loglog(1e3 * table[time], table[error], marker=marker, markersize=4.5, color=colour, label=f"{name}, true")
        axes.loglog(1e3 * table[time], table[estimate], marker=marker, markersize=4.5, color=colour, linewidth=0.8, linestyle="--",
                    markerfacecolor="white", label=f"{name}, estimated")
        if error == "force_error":
            for n, x, y, p in zip(cells, 1e3 * table[time], table[estimate], pairs):
                axes.annotate(f"$N = {n}$\n{p:.0f} $P$", (x, y), xytext=(5, 5), textcoords="offset points", fontsize=7)
    axes.set_xlabel("time of a solution, one thread [ms]")
    axes.set_xlim(1, 4e3)
    axes.text(0.97, 0.97, "$P$: one real FFT pair, $2N \\times 2N$", ha="right", va="top", transform=axes.transAxes, fontsize=7)
    axes.legend(loc="lower left")


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])

    figure, (convergence, work) = plt.subplots(1, 2, sharey=True, figsize=(style.PAGE, 3.6))
    draw_convergence(convergence, table)
    draw_work(work, table)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
