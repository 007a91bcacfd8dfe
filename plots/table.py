"""Tables that `patchgrip tabulate` or `limit` wrote: columns by name, and numbers from the comments in their heads."""

import re

import numpy as np


class Table:
    def __init__(self, path):
        lines = path.read_text(encoding="utf-8").splitlines()
        self.path = path
        self.head = "\n".join(line for line in lines if line.startswith("#"))
        self.columns = np.genfromtxt((line for line in lines if not line.startswith("#")), delimiter=",", names=True, dtype=None,
                                     encoding="utf-8")

    def __getitem__(self, name):
        return self.columns[name]

    def number(self, before, after=""):
        """The number between these two words in the head of the table."""
        found = re.search(re.escape(before) + r" ([-+.\deE]+)" + re.escape(after), self.head)
        if not found:
            raise SystemExit(f"{self.path}: the head says no '{before}'")
        return float(found.group(1))

    @property
    def friction_force(self):
        """mu F_N [N] of Coulomb friction: the scale of every force."""
        return self.number("mu =") * self.number("normal force", " N")

    @property
    def radius(self):
        return self.number("radius", " m")

    @property
    def length(self):
        """a_K [m] of a table of loads, from the moments and the stick radii that it lists (4.52a)."""
        row = np.argmax(np.abs(self["moment_Nm"]))
        square = (self["stick_radius"][row] * self["gauge_N"][row]) ** 2 - self.force[row] ** 2
        return abs(self["moment_Nm"][row]) / np.sqrt(square)

    @property
    def pole_distance(self):
        return np.hypot(self["pole_x_m"], self["pole_y_m"])

    @property
    def force(self):
        return np.hypot(self["force_x_N"], self["force_y_N"])
