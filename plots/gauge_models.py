"""Patches and models in the tables of the gauge benchmark, and how figures show them."""

import csv

from style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY

PATCHES = {
    "hertz_disc": "Hertz disc",
    "uniform_disc": "uniform disc",
    "flat_punch_disc": "flat punch",
    "ring": "ring",
    "power_disc": "power law, $n = 0.3$",
    "xydas_kao_disc": r"Xydas–Kao, $\alpha = 1.8$",
    "hertz_ellipse_3": "Hertz ellipse 3 : 1",
    "rectangle": "rectangle 4 : 1",
    "l_shape": "L-shape",
    "two_patches": "two patches",
    "pressure_grid": "sampled pressure",
}

# Model: name, colour, marker, line.
MODELS = {
    "ellipsoid_axis": ("axis ellipsoid", ORANGE, "s", "-"),
    "ellipsoid_least_squares": ("least-squares ellipsoid", SKY, "<", "-"),
    "ellipsoid_even": ("best ellipsoid", BLUE, "^", "-"),
    "ellipsoid_safe": ("best ellipsoid, made safe", BLUE, "^", "--"),
    "ellipsoid_inner": ("largest ellipsoid inside", GREEN, "d", "-"),
    "ellipsoid_enclosing": ("smallest ellipsoid about", GREY, "h", "-."),
    "quartic_least_squares": ("least-squares quartic", SKY, ">", "-"),
    "quartic_even": ("best quartic", PURPLE, "v", "-"),
    "quartic_safe": ("best quartic, made safe", PURPLE, "v", "--"),
    "seed": ("polynomial of Keppler 2006", RED, "D", "-"),
    "fast": ("Hertz disc, to $10^{-9}$", GREEN, "P", "-"),
    "exact": ("Hertz disc, exact", BLACK, "*", ":"),
    "round": ("any round patch, exact", GREY, "X", ""),
    "newton": ("any patch: Newton, gap $10^{-1}$ to $10^{-12}$", BLUE, "o", "-"),
}


def read(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))
