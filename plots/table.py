"""Tables that `patchgrip tabulate` wrote: columns by name, and numbers from the comments in their heads."""

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
    def pole_distance(self):
        return np.hypot(self["pole_x_m"], self["pole_y_m"])

    @property
    def force(self):
        return np.hypot(self["force_x_N"], self["force_y_N"])
