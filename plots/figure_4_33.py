"""Keppler 2006, figure 4.33: a box held by form, without friction, and by force, with it; with the squeeze of each."""

import json

import numpy as np

import style
from style import BLACK, BLUE, GREY, RED, plt

SIDES = np.array([0.06, 0.04, 0.02])  # of the box in the scenes [m]


def view(p):
    """Oblique: x to the right, z up, y away to the upper right."""
    p = np.asarray(p)
    return np.stack([p[..., 0] + 0.42 * p[..., 1], p[..., 2] + 0.30 * p[..., 1]], axis=-1)


def draw_box(axes):
    half = SIDES / 2
    corners = np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]) * half
    for a in corners:
        for b in corners:
            if np.count_nonzero(a != b) == 1 and tuple(a) < tuple(b):
                hidden = (a[1] > 0 or b[1] > 0) and min(a[2], b[2]) < 0 and min(a[0], b[0]) < 0
                axes.plot(*view(np.array([a, b])).T, color=GREY, linewidth=0.8, linestyle=":" if hidden else "-")


def draw_contacts(axes, answer, mu):
    longest = max(c["normal_force"]["value"] for c in answer["answers"][0]["contacts"])
    for place, force in zip(answer["contacts"], answer["answers"][0]["contacts"]):
        r, n = np.array(place["position"]), np.array(place["normal"])
        size = 0.018 * force["normal_force"]["value"] / longest
        start, end = view(r + (size + 0.004) * n), view(r + 0.001 * n)
        axes.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": RED, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0})
        axes.plot(*view(r), "o", color="white", markeredgecolor=BLACK, markersize=3.5)
        if mu > 0:
            u = np.array(place["tangent"])
            v = np.cross(n, u)
            turn = np.linspace(0, 2 * np.pi, 60)[:, None]
            rim = r + 0.014 * (-n + mu * (np.cos(turn) * u + np.sin(turn) * v))
            axes.fill(*view(rim).T, color=BLUE, alpha=0.15)
            axes.plot(*view(rim).T, color=BLUE, linewidth=0.7)
            for side in (np.argmax(view(rim)[:, 1]), np.argmin(view(rim)[:, 1])):
                axes.plot(*view(np.array([r, rim[side]])).T, color=BLUE, linewidth=0.7)


def main():
    options = style.arguments(__doc__, 2)
    figure, panels = plt.subplots(1, 2, figsize=(style.PAGE, 1.8))
    for axes, path, mu, title in zip(panels, options.input, (0, 0.5),
                                     ("Without friction: seven contacts", "With friction: two soft fingers, µ = 0.5")):
        answer = json.loads(path.read_text(encoding="utf-8"))
        assert answer["answers"][0]["verdict"] == "holds", path
        draw_box(axes)
        draw_contacts(axes, answer, mu)
        axes.set_title(title)
        axes.set_aspect("equal")
        axes.set_xlim(-0.068, 0.068)
        axes.set_ylim(-0.029, 0.026)
        axes.axis("off")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
