"""Keppler 2006, figure 4.18: the switch alpha of (4.35) over sliding velocity and bristle force."""

import numpy as np

import style
from style import BLACK, plt


def ramp(x):
    return np.clip((x - 1) / 0.01, 0, 1)


def main():
    options = style.arguments(__doc__, "*")
    x = np.linspace(0.97, 1.03, 241)
    velocity, force = np.meshgrid(x, x)
    alpha_v, alpha_f = ramp(velocity), ramp(force)
    alpha = alpha_v + alpha_f - alpha_v * alpha_f

    figure, (curve, plane) = plt.subplots(1, 2, figsize=(style.PAGE, 2.5), width_ratios=[1, 1.25])
    curve.plot(x, ramp(x), color=BLACK)
    curve.set_xlabel(r"$|\xi| / \xi_{max}$ [-]")
    curve.set_ylabel(r"$s_\alpha$ [-]")
    curve.set_xlim(x[0], x[-1])
    image = plane.contourf(x, x, alpha, levels=np.linspace(0, 1, 21), cmap="cividis")
    plane.contour(x, x, alpha, levels=[0.25, 0.5, 0.75], colors="white", linewidths=0.8)
    plane.text(0.985, 0.985, r"stick, $\alpha = 0$", color="white", ha="center", va="center")
    plane.text(1.02, 1.02, r"slip, $\alpha = 1$", ha="center", va="center")
    plane.set_xlabel(r"$|\Delta u| / \Delta u_{max}$ [-]")
    plane.set_ylabel(r"$|F_\kappa| / \mu_H F_N$ [-]")
    plane.grid(False)
    plane.set_aspect("equal")
    bar = figure.colorbar(image, ax=plane, ticks=[0, 0.25, 0.5, 0.75, 1])
    bar.set_label(r"$\alpha$ [-]")
    style.save(figure, options.output)


if __name__ == "__main__":
    main()
