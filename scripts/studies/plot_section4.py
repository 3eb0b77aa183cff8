#!/usr/bin/env python3
"""Draws the paper's figure 3 anew, and the same for six and eight cables; prints the table of docs/section4.md.

    scripts/studies/plot_section4.py DIRECTORY docs/images     (DIRECTORY: where section4 wrote its CSV files)
"""

import argparse
import csv
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

LOADS = (500.0, 10000.0)
STYLES = {
    "straight": ("tab:gray", "-", "straight ('linear')"),
    "catenary": ("tab:orange", "-", "catenary ('classic')"),
    "bending_inextensible": ("tab:green", "-", "bending, inextensible ('new')"),
    "bending": ("tab:blue", "--", "bending, extensible ('new')"),
}
# Insets by load: a model's point at L1 = 4.5 m, how far above it the inset is centred [m], its half width [m], where.
LOW, HIGH = (0.07, 0.07, 0.36, 0.38), (0.63, 0.43, 0.33, 0.35)
ZOOMS = {
    500.0: [("straight", 0.006, 16e-3, LOW), ("bending", 0.0, 0.4e-3, HIGH)],
    10000.0: [("straight", -0.0015, 3e-3, LOW), ("bending", 0.0, 12e-6, HIGH)],
}


def read(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def trajectories(rows):
    """Arrays (L1, x, y) by load and model."""
    result = {}
    rows = [r for r in rows if r["method"] == "coupled"]
    for load in LOADS:
        for model in STYLES:
            chosen = [r for r in rows if r["model"] == model and float(r["load_N"]) == load]
            result[load, model] = np.array([[float(r[k]) for k in ("length_1_m", "x_m", "y_m")] for r in chosen]).T
    return result


def zoom(axes, lines, load, centre, half, place):
    """An inset of half width `half` [m] around `centre`, ticks in mm from there."""
    inset = axes.inset_axes(place)
    for model, (color, dash, _) in STYLES.items():
        _, x, y = lines[load, model]
        inset.plot(1e3 * (x - centre[0]), 1e3 * (y - centre[1]), color=color, linestyle=dash, marker=".", markersize=4)
    inset.set(xlim=(-1e3 * half, 1e3 * half), ylim=(-1e3 * half, 1e3 * half))
    inset.set_title(f"mm around ({centre[0]:.4f}, {centre[1]:.4f})", fontsize=8)
    inset.tick_params(labelsize=7)
    inset.grid(linewidth=0.3)
    axes.plot(*centre, marker="s", markersize=7, markerfacecolor="none", color="black")
    return inset


def draw_trajectories(lines, path):
    figure, panels = plt.subplots(1, 2, figsize=(12, 5.6), constrained_layout=True)
    for axes, load, letter in zip(panels, LOADS, "ab"):
        for model, (color, dash, label) in STYLES.items():
            _, x, y = lines[load, model]
            axes.plot(x, y, color=color, linestyle=dash, label=label)
        axes.set(xlabel="x [m]", ylabel="y [m]", title=f"({letter}) P = {load / 1000:g} kN, L1 from 4 to 5 m")
        axes.grid(linewidth=0.3)
        for model, above, half, place in ZOOMS[load]:
            _, x, y = lines[load, model]
            middle = len(x) // 2
            zoom(axes, lines, load, (x[middle], y[middle] + above), half, place)
    panels[0].legend(loc="upper right", fontsize=8)
    figure.savefig(path, dpi=100)


def draw_distances(lines, path):
    """How far above the straight model's trajectory each model's point for the same length lies."""
    figure, panels = plt.subplots(1, 2, figsize=(12, 3.6), constrained_layout=True)
    for axes, load in zip(panels, LOADS):
        length, x0, y0 = lines[load, "straight"]
        for model, (color, dash, label) in STYLES.items():
            _, x, y = lines[load, model]
            away = 1e3 * np.copysign(np.hypot(x - x0, y - y0), y - y0)
            axes.plot(length, away, color=color, linestyle=dash, label=label)
        title = f"P = {load / 1000:g} kN; negative: below"
        axes.set(xlabel="L1 [m]", ylabel="distance from straight [mm]", title=title)
        axes.grid(linewidth=0.3)
    panels[1].legend(fontsize=8, loc="center")
    figure.savefig(path, dpi=100)


def distance(a, b):
    """Between two solved points [mm]; NaN, which is not drawn, where one was not solved."""
    if a is None or b is None:
        return np.nan
    return 1e3 * np.linalg.norm([float(a[k]) - float(b[k]) for k in ("x_m", "y_m", "z_m")])


def draw_platforms(rows, path):
    figure, panels = plt.subplots(2, 4, figsize=(14, 6), sharex=True, constrained_layout=True)
    cases = [(n, sweep) for n in ("6", "8") for sweep in ("alone", "together")]
    for column, (cables, sweep) in enumerate(cases):
        chosen = [r for r in rows if r["cables"] == cables and r["sweep"] == sweep]
        for row, load in enumerate(sorted({float(r["load_N"]) for r in chosen})):
            axes = panels[row, column]
            here = {(r["model"], r["length_1_m"]): r for r in chosen if float(r["load_N"]) == load and r["code"] == "1"}
            lengths = sorted({r["length_1_m"] for r in chosen}, key=float)
            for model, (color, _, label) in list(STYLES.items())[:3]:
                away = [distance(here.get((model, l)), here.get(("bending", l))) for l in lengths]
                axes.semilogy([float(l) for l in lengths], away, ".-", color=color, label=label)
            axes.set_title(f"{cables} cables, {sweep}, {load / 1000:g} kN", fontsize=10)
            axes.grid(linewidth=0.3)
    for axes in panels[1]:
        axes.set_xlabel("L1 [m]")
    for axes in panels[:, 0]:
        axes.set_ylabel("distance from\nbending, extensible [mm]")
    panels[0, 0].legend(fontsize=7, loc="center", bbox_to_anchor=(0.5, 0.42))
    figure.savefig(path, dpi=90)


def print_table(lines):
    for load in LOADS:
        print(f"\n| L1 [m], {load / 1000:g} kN | straight | catenary | bending, inextensible | bending |")
        print("|---|---|---|---|---|")
        for i, length in enumerate(lines[load, "straight"][0]):
            if abs(10 * length - round(10 * length)) > 1e-9:
                continue
            cells = [f"{lines[load, model][1][i]:.9f}, {lines[load, model][2][i]:.9f}" for model in STYLES]
            print(f"| {length:.1f} | " + " | ".join(cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("images", type=pathlib.Path)
    arguments = parser.parse_args()
    lines = trajectories(read(arguments.directory / "two_cables.csv"))
    draw_trajectories(lines, arguments.images / "section4_trajectories.png")
    draw_distances(lines, arguments.images / "section4_distances.png")
    draw_platforms(read(arguments.directory / "platforms.csv"), arguments.images / "section4_platforms.png")
    print_table(lines)


if __name__ == "__main__":
    main()
