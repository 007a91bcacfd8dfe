"""Error of the least grip against time: cones cut into edges, SDPA where it was there, and the exact cones."""

import numpy as np

import style
from style import BLACK, BLUE, GREEN, GREY, ORANGE, RED, plt
from table import Table

CUT = (("inner", "cut within: safe", GREEN, "o"), ("outer", "cut around: promises too much", ORANGE, "s"))
EXACT = (("SDPA", "SDPA", GREY, "D"), ("interior point", "interior point", RED, "v"), ("least grip", "with polish and bracket", BLUE, "*"))
TITLES = {"point": "point contacts", "elliptic": "elliptic soft fingers"}


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    figure, panels = plt.subplots(1, 2, sharey=True, figsize=(style.PAGE, 3.2))
    for panel, (model, title) in zip(panels, TITLES.items()):
        own = table["model"] == model
        for side, name, colour, marker in CUT:
            rows = own & np.char.startswith(table["method"], side)
            panel.loglog(table["us"][rows], table["error"][rows], color=colour, marker=marker, markersize=4, linewidth=1, label=name)
            for us, error, method in zip(table["us"][rows], table["error"][rows], table["method"][rows]):
                if side == "inner":
                    panel.annotate(method.split()[1], (us, error), textcoords="offset points", xytext=(-3, -10), ha="center", fontsize=7)
        for method, name, colour, marker in EXACT:
            rows = own & (table["method"] == method)
            panel.loglog(table["us"][rows], table["error"][rows], color=colour, marker=marker, markersize=8 if marker == "*" else 5,
                         linestyle="none", label=name)
        panel.set_title(f"{table['contacts'][own][0]} {title}", color=BLACK)
        panel.set_xlabel(r"CPU time [$\mu$s]")
    panels[0].set_ylabel("relative error of the least grip")
    panels[1].legend(loc="center left", bbox_to_anchor=(1, 0.5), title="numbers: edges")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
