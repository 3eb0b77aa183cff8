#!/usr/bin/python3
"""Draws a guide pulley: where a rope leaves it, and what its bending stiffness does there (docs/theory.md, section 8).

    scripts/studies/plot_pulley.py docs/images/pulley.png       (needs python3-matplotlib; no ROS)
"""

import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

RADIUS = 1.0
FORCE = -0.35  # direction of the force on a weightless rope [rad]
STIFFNESSES = ((0.0, "tab:orange", "EI = 0"), (0.35, "tab:blue", "lambda = 0.35 r"), (0.9, "tab:green", "lambda = 0.9 r"))
REACH = 4.0  # of the free rope that is drawn [r]
STEPS = 2000


def departure(alpha):
    return RADIUS - RADIUS * math.sin(alpha), RADIUS * math.cos(alpha)


def free_rope(thickness):
    """Points of the rope from where it leaves, by (45): the slope falls from that on the pulley to that of the force."""
    turn = 2.0 * math.asin(0.5 * thickness / RADIUS)
    x, y = departure(FORCE + turn)
    points = [(x, y)]
    step = REACH * RADIUS / STEPS
    for i in range(STEPS):
        s = (i + 0.5) * step
        layer = 4.0 * math.atan(math.tan(0.25 * turn) * math.exp(-s / thickness)) if thickness > 0.0 else 0.0
        x += step * math.cos(FORCE + layer)
        y += step * math.sin(FORCE + layer)
        points.append((x, y))
    return turn, points


def arc(begin, end, radius=RADIUS):
    angles = [begin + (end - begin) * i / 100 for i in range(101)]
    return [RADIUS + radius * math.cos(a) for a in angles], [radius * math.sin(a) for a in angles]


def draw_geometry(axes):
    axes.plot(*arc(0.0, 2.0 * math.pi), color="lightgrey")
    alpha = FORCE
    leaves = math.pi / 2 + alpha
    px, py = departure(alpha)
    axes.plot([0.0, 0.0], [-2.0, 0.0], color="grey", lw=2.5)
    axes.plot(*arc(math.pi, leaves), color="tab:orange", lw=2.5)
    axes.plot([px, px + REACH * math.cos(alpha)], [py, py + REACH * math.sin(alpha)], color="tab:orange", lw=2.5)
    axes.plot([px, px + 1.6], [py, py], color="black", lw=0.7)
    axes.annotate(r"$\alpha_0$ (< 0)", (px + 1.65, py - 0.05))
    axes.plot([RADIUS, px], [0.0, py], color="black", lw=0.7)
    axes.plot([RADIUS, 0.0], [0.0, 0.0], color="black", lw=0.7)
    axes.plot(*arc(math.pi, leaves, 0.3), color="black", lw=0.7)
    axes.annotate(r"$\varphi$", (RADIUS - 0.15, 0.36))
    axes.annotate("r", (0.5 * (RADIUS + px) + 0.06, 0.45 * py))
    axes.plot([0.0, px], [0.0, py], "ko", ms=4)
    axes.annotate("A0", (-0.6, -0.1))
    axes.annotate("P", (px + 0.02, py + 0.14))
    axes.annotate("dead part,\nfrom the drum", (-1.9, -1.6))
    axes.annotate("free part, to B", (px + 1.9, py - 1.35))
    axes.set_title("rope from below: sigma = 1")


def draw_bending(axes):
    axes.plot(*arc(0.0, 2.0 * math.pi), color="lightgrey")
    for thickness, color, name in STIFFNESSES:
        turn, points = free_rope(thickness)
        axes.plot(*arc(math.pi, math.pi / 2 + FORCE + turn), color=color, lw=2)
        axes.plot([p[0] for p in points], [p[1] for p in points], color=color, lw=2, label=name)
        axes.plot(*points[0], "o", color=color, ms=5)
        offset = RADIUS + thickness**2 / (2.0 * RADIUS)
        foot = (RADIUS - offset * math.sin(FORCE), offset * math.cos(FORCE))
        along = [(foot[0] + t * math.cos(FORCE), foot[1] + t * math.sin(FORCE)) for t in (-0.5, REACH)]
        axes.plot([p[0] for p in along], [p[1] for p in along], color=color, lw=0.7, ls="--")
    axes.legend(loc="lower right")
    axes.set_title("dashed: lines at r + EI/(2 r T) from the axis")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2))
    draw_geometry(left)
    draw_bending(right)
    for axes in (left, right):
        axes.set_aspect("equal")
        axes.axis("off")
    left.set_xlim(-2.2, 4.9)
    left.set_ylim(-2.1, 1.5)
    right.set_xlim(-0.3, 4.2)
    right.set_ylim(-1.2, 1.7)
    figure.tight_layout()
    figure.savefig(sys.argv[1], dpi=110)


if __name__ == "__main__":
    main()
