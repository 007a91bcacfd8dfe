"""Figure 4.35: mesh and von Mises stress of a fingertip, a rubber hemisphere pressed by 0.4 of its radius, from our own run."""

import style
from style import BLACK, plt
from matplotlib.collections import PolyCollection
from table import Table

PRESSED = 0.4  # of the radius


def main():
    options = style.arguments(__doc__, 1)
    table = Table(options.input[0])
    triangles = [[(table[f"x{k}_m"][i], table[f"y{k}_m"][i]) for k in (1, 2, 3)] for i in range(len(table["x1_m"]))]
    mirrored = [[(-x, y) for x, y in triangle] for triangle in triangles]
    stress = table["von_mises_Pa"]
    figure, axes = plt.subplots(figsize=(style.PAGE, 2.6))
    axes.set_aspect("equal")
    axes.grid(False)
    meshes = [PolyCollection(triangles, array=stress, cmap="viridis", edgecolors=BLACK, linewidths=0.2),
              PolyCollection(mirrored, array=stress, cmap="viridis", edgecolors="face", linewidths=0.2)]
    for mesh in meshes:
        mesh.set_clim(0, stress.max())
        axes.add_collection(mesh)
    axes.axhline(-1 + PRESSED, color=BLACK, linewidth=1.4)
    axes.set_xlim(-1.45, 1.45)
    axes.set_ylim(-1 + PRESSED - 0.06, 0.06)
    axes.set_xlabel("$x / R$")
    axes.set_ylabel("$z / R$")
    figure.colorbar(meshes[0], ax=axes, label=r"von Mises stress $\sigma / G$", shrink=0.9)
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
