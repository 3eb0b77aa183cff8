#!/usr/bin/env python3
"""Draws the stability map and the cost over kappa L from the CSV files of stability_map.

    stability_map --csv map.csv --cost cost.csv
    scripts/studies/plot_stability.py map.csv cost.csv docs/images       (needs python3-matplotlib)

scripts/studies/stability.sh does both.
"""

import argparse
import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

OUTCOMES = (  # drawn in this order, the rare ones on top
    ("solved", "tab:green"),
    ("refused", "0.6"),
    ("inaccurate", "tab:orange"),
    ("unverified", "tab:purple"),
    ("wrong branch", "tab:red"),
)


def read(file):
    with open(file, newline="") as stream:
        return list(csv.DictReader(stream))


def vertical(row):
    """Strain of a taut cable, L/chord - 1 of a slack one."""
    return float(row["strain"]) if row["taut"] == "1" else float(row["L"]) / float(row["chord"]) - 1


def scatter(axes, rows, problem, taut, title):
    shown = [r for r in rows if (r["taut"] == "1") == taut and not r["corner"]]
    for outcome, color in OUTCOMES:
        here = [r for r in shown if r[problem + "_outcome"] == outcome]
        size = 1.5 if outcome in ("solved", "refused") else 5
        if problem != "single" and outcome == "refused":
            size, color = 6, "black"
        axes.scatter(
            [float(r["layers"]) for r in here],
            [vertical(r) for r in here],
            s=size,
            color=color,
            linewidths=0,
            label=f"{outcome} ({100 * len(here) / max(1, len(shown)):.2f} %)" if here else None,
            rasterized=True,
        )
    axes.set(xscale="log", yscale="log", ylabel="strain" if taut else "L/chord - 1")
    axes.set_title(title, pad=22)
    axes.legend(
        fontsize=7,
        loc="lower center",
        bbox_to_anchor=(0.5, 0.99),
        ncol=5,
        markerscale=2,
        frameon=False,
        handletextpad=0.1,
        columnspacing=0.8,
    )


def draw_outcomes(rows, file):
    figure, axes = plt.subplots(2, 2, figsize=(10, 7), sharex=True, constrained_layout=True)
    for row, taut in enumerate((True, False)):
        kind = "taut" if taut else "slack"
        scatter(axes[row][0], rows, "forces", taut, f"FIND_FORCES, {kind}")
        scatter(axes[row][1], rows, "single", taut, f"single shooting, {kind}")
    for a in axes[1]:
        a.set_xlabel("kappa L")
    figure.savefig(file, dpi=90)


def draw_errors(rows, file):
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.8), sharey=True, constrained_layout=True)
    names = (
        ("position", "1 FIND_POSITION: end over length"),
        ("forces", "2 FIND_FORCES: force over tension"),
        ("length", "3 FIND_LENGTH: tension over tension"),
    )
    for a, (problem, title) in zip(axes, names):
        for taut, color in ((True, "tab:blue"), (False, "tab:orange")):
            here = [
                r
                for r in rows
                if (r["taut"] == "1") == taut
                and not r["corner"]
                and r[problem + "_outcome"] in ("solved", "inaccurate")
            ]
            a.scatter(
                [float(r["layers"]) for r in here],
                [max(float(r[problem + "_error"]), 1e-17) for r in here],
                s=1.0,
                color=color,
                linewidths=0,
                label="taut" if taut else "slack",
            )
        a.axhline(1e-6, color="black", linewidth=0.8)
        a.set(xscale="log", yscale="log", xlabel="kappa L", title=title)
    axes[0].set_ylabel("difference from collocation")
    axes[0].legend(markerscale=5, fontsize=8)
    figure.savefig(file, dpi=90)


def draw_cost(costs, rows, file):
    figure, (grid, cloud) = plt.subplots(1, 2, figsize=(10, 3.8), constrained_layout=True)
    layers = [float(c["layers"]) for c in costs]
    for kind in ("taut", "slack"):
        grid.loglog(layers, [1e6 * float(c[kind]) for c in costs], marker=".", label=kind)
    grid.set(xlabel="kappa L", ylabel="time [us]", title="FIND_FORCES at 1e-8, median of 21 cables")
    grid.legend()
    for taut, color in ((True, "tab:blue"), (False, "tab:orange")):
        here = [r for r in rows if (r["taut"] == "1") == taut and r["forces_outcome"] == "solved" and not r["corner"]]
        cloud.scatter(
            [float(r["layers"]) for r in here],
            [1e3 * float(r["forces_time"]) for r in here],
            s=1.0,
            color=color,
            linewidths=0,
            label="taut" if taut else "slack",
        )
    cloud.set(xscale="log", yscale="log", xlabel="kappa L", ylabel="time [ms]", title="FIND_FORCES, every cable of the map")
    cloud.legend(markerscale=5, fontsize=8)
    figure.savefig(file, dpi=90)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("map", help="CSV of stability_map --csv")
    parser.add_argument("cost", help="CSV of stability_map --cost")
    parser.add_argument("directory", help="where the pictures go")
    arguments = parser.parse_args()
    rows = read(arguments.map)
    draw_outcomes(rows, os.path.join(arguments.directory, "stability_map.png"))
    draw_errors(rows, os.path.join(arguments.directory, "stability_errors.png"))
    draw_cost(read(arguments.cost), rows, os.path.join(arguments.directory, "stability_cost.png"))


if __name__ == "__main__":
    main()
