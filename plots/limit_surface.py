"""Limit surfaces that `patchgrip limit --surface FILE.csv` wrote, drawn as bodies with light."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from style import BLUE, ORANGE
from table import Table

# Where the pole is: in the centroid, at the radius of gyration, at infinity.
SLIPS = LinearSegmentedColormap.from_list("slips", [ORANGE, "#E8E8E8", BLUE])


class Surface(Table):
    """Points on meridians and parallels; the first and the last row are pure rotations about the centroid."""

    def __init__(self, path):
        super().__init__(path)
        self.shape = int(self.number("parallels")) - 1, int(self.number("meridians", ","))

    def net(self, values):
        """Values of a column as [parallel, meridian], closed around and with both ends."""
        rows, columns = self.shape
        inner = values[1:-1].reshape(rows, columns)
        whole = np.vstack([np.full(columns, values[0]), inner, np.full(columns, values[-1])])
        return np.hstack([whole, whole[:, :1]])

    @property
    def capacity(self):
        """mu F_N, or the sum of mu_i F_i [N]: the greatest force."""
        return self.force.max()

    @property
    def gyration(self):
        return self.number("radius of gyration", " m")

    @property
    def pole_share(self):
        """d / (d + i): d the distance of the pole from the centroid, i the radius of gyration."""
        w = self["w_rad_per_s"]
        x, y = self["pole_x_m"][0], self["pole_y_m"][0]
        speed = np.hypot(self["vx_m_per_s"] - w * y, self["vy_m_per_s"] + w * x)
        return speed / (speed + self.gyration * np.abs(w))


def slip_scale(figure, axes, **place):
    """The colours: where the pole is."""
    axes.grid(False)
    bar = figure.colorbar(ScalarMappable(cmap=SLIPS), orientation="horizontal", **place)
    bar.set_ticks([0, 1 / 3, 1 / 2, 2 / 3, 1], labels=["0", "1/2", "1", "2", r"$\infty$"])
    bar.outline.set_linewidth(0.4)
    return bar


def cells(net):
    """Corners of the cells of a net [parallel, meridian, ...]."""
    return np.stack([net[:-1, :-1], net[1:, :-1], net[1:, 1:], net[:-1, 1:]], axis=2).reshape(-1, 4, *net.shape[2:])


def lit(colours, normals, viewer, up):
    light = viewer + 0.6 * up + 0.5 * np.cross(viewer, up)
    diffuse = np.clip(normals @ (light / np.linalg.norm(light)), 0, None)[:, None]
    return np.clip(colours[:, :3] * (0.58 + 0.42 * diffuse) + 0.12 * diffuse**20, 0, 1)


def draw(axes, surface, length, azimuth=-55, elevation=22, zoom=0.9):
    """The surface in units of mu F_N and, upwards, mu F_N times `length`, coloured by the distance of the pole."""
    a, e = np.radians(azimuth), np.radians(elevation)
    viewer = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    up = np.array([-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)])
    scale = surface.capacity
    points = np.stack([surface.net(surface[name] / size) for name, size in
                       (("force_x_N", scale), ("force_y_N", scale), ("moment_Nm", scale * length))], axis=-1)
    # The slip is the normal; it is convex, so what faces the viewer hides the rest.
    normals = np.stack([surface.net(surface[name]) * size for name, size in
                        (("vx_m_per_s", 1), ("vy_m_per_s", 1), ("w_rad_per_s", length))], axis=-1)
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    faces, across = cells(points), cells(normals).mean(axis=1)
    seen = across @ viewer > 0
    colours = lit(SLIPS(cells(surface.net(surface.pole_share)).mean(axis=1)), across, viewer, up)[seen]
    axes.computed_zorder = False
    axes.add_collection3d(Poly3DCollection(faces[seen], facecolors=colours, edgecolors=colours, linewidths=0.15, zorder=1))
    axes.add_collection3d(Line3DCollection(net_lines(points, normals @ viewer > 0), colors="black", linewidths=0.25, alpha=0.45,
                                           zorder=2))
    axes.set_proj_type("ortho")
    axes.view_init(elev=elevation, azim=azimuth)
    box(axes, np.abs(points.reshape(-1, 3)).max(axis=0), zoom)


def net_lines(points, seen):
    """Every so many meridians and parallels, where they are seen."""
    rows, columns = points.shape[0] - 1, points.shape[1] - 1
    lines = []
    for j in range(0, columns, max(1, columns // 24)):
        lines += [points[i : i + 2, j] for i in range(rows) if seen[i, j] and seen[i + 1, j]]
    for i in range(0, rows + 1, max(1, rows // 12)):
        lines += [points[i, j : j + 2] for j in range(columns) if seen[i, j] and seen[i, j + 1]]
    return lines


def box(axes, reach, zoom):
    for limits, size in ((axes.set_xlim, reach[0]), (axes.set_ylim, reach[1]), (axes.set_zlim, reach[2])):
        limits(-size, size)
    axes.set_box_aspect(reach, zoom=zoom)
    for axis in (axes.xaxis, axes.yaxis, axes.zaxis):
        axis.set_pane_color((0.97, 0.97, 0.97, 1))
        axis.set_major_locator(MaxNLocator(4, symmetric=True, prune="both"))
    for name in ("x", "y", "z"):
        axes.tick_params(axis=name, pad=0 if name == "z" else -2, labelsize=7)
