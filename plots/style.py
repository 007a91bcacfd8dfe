"""The look of every figure: print sizes, colours that colour-blind readers tell apart, files that are the same on every run."""

import argparse
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

MM = 1 / 25.4
COLUMN = 85 * MM  # width of a column in print, in
PAGE = 170 * MM  # width of a page, in

# Okabe and Ito, Color Universal Design (2008); its yellow is too pale for lines on white.
BLACK, ORANGE, SKY, GREEN, BLUE, RED, PURPLE = "#000000", "#E69F00", "#56B4E9", "#009E73", "#0072B2", "#D55E00", "#CC79A7"
GREY = "#767676"

plt.rcParams.update({
    "axes.formatter.use_mathtext": True,
    "axes.grid": True,
    "axes.labelsize": 9,
    "axes.linewidth": 0.6,
    "axes.titlesize": 9,
    "figure.constrained_layout.use": True,
    "font.family": "DejaVu Sans",
    "font.size": 8,
    "grid.color": "#E0E0E0",
    "grid.linewidth": 0.5,
    "legend.fontsize": 8,
    "legend.framealpha": 1,
    "legend.frameon": False,
    "legend.handlelength": 2.4,
    "lines.linewidth": 1.4,
    "mathtext.fontset": "dejavusans",
    "svg.hashsalt": "patchgrip",
    "xtick.labelsize": 8,
    "xtick.major.width": 0.6,
    "ytick.labelsize": 8,
    "ytick.major.width": 0.6,
})


def arguments(description, inputs):
    """The command line of a figure script: --input with `inputs` CSV files ("+": any number) and --output STEM."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--input", nargs=inputs, required=True, type=pathlib.Path, metavar="CSV")
    parser.add_argument("--output", required=True, type=pathlib.Path, metavar="STEM", help="writes STEM.svg and STEM.png")
    return parser.parse_args()


def save(figure, stem):
    figure.savefig(stem.with_suffix(".svg"), metadata={"Date": None})
    figure.savefig(stem.with_suffix(".png"), dpi=200, metadata={"Software": None})
