#!/usr/bin/env python3
"""Puts what estimation_study measured into docs/estimation.md and draws docs/images/estimation.png.

    scripts/studies/estimation.sh                             measures, and calls this
    scripts/studies/plot_estimation.py RESULTS docs           again, from its results       (needs python3-matplotlib)
"""

import argparse
import csv
import math
import os
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

ROBOT = "cogiro"  # of the payload
BINS = [0.5 * k for k in range(51)]
TABLES = ("consistency", "faults", "offsets", "recovery", "load", "observability", "timing")
GIVEN = (("all", "tab:blue"), ("load unknown", "tab:orange"), ("lengths only", "tab:green"))


def read(directory, name):
    with open(os.path.join(directory, name), newline="") as file:
        return list(csv.DictReader(file))


def plot_consistency(axes, rows):
    for given, color in GIVEN:
        nees = [float(r["pose_nees"]) for r in rows if r["freedoms"] == "6" and r["given"] == given]
        axes.hist(nees, bins=BINS, density=True, histtype="step", color=color, label=f"{given}: mean {sum(nees) / len(nees):.2f}")
    axes.plot(BINS, [x * x * math.exp(-x / 2) / 16 for x in BINS], color="black", linewidth=0.8, label="chi-square: mean 6")
    axes.set(xlabel="error$^T$ covariance$^{-1}$ error", ylabel="density", title="Pose errors of rigid platforms")
    axes.legend(fontsize="small")


def plot_faults(axes, rows):
    rows = [r for r in rows if r["onset"] == "while tracking" and r["solved"] == "1" and float(r["visible"]) > 0]
    for flagged, color, label in (("1", "tab:blue", "found"), ("0", "tab:red", "not found")):
        cases = [r for r in rows if r["flagged"] == flagged]
        axes.scatter(
            [float(r["visible"]) for r in cases],
            [max(float(r["own_distance"]), 1e-3) for r in cases],
            s=3, alpha=0.5, color=color, label=label, rasterized=True,
        )
    axes.axvline(6, color="gray", linewidth=0.8, linestyle="--")
    axes.axhline(3, color="gray", linewidth=0.8, linestyle="--")
    axes.set(xscale="log", yscale="log", xlim=(0.05, 1e3), ylim=(8e-4, 1e2))
    axes.set(xlabel="what the other sensors see of the fault [sigma]", ylabel="shift of the estimate [sigma]")
    axes.set_title("One faulty sensor, all robots")
    axes.legend(fontsize="small", markerscale=4)


def plot_load(load, error, rows):
    for given, color in GIVEN[:2]:
        steps = [r for r in rows if r["robot"] == ROBOT and r["given"] == given]
        at = [int(r["step"]) for r in steps]
        label = "known_load " + ("true" if given == "all" else "false")
        load.plot(at, [float(r["load"]) for r in steps], ".", markersize=2, color=color, label=label)
        error.plot(at, [float(r["load"]) - float(r["payload"]) for r in steps], color=color, linewidth=0.8)
        for sign in (-2, 2):
            error.plot(at, [sign * float(r["load_sigma"]) for r in steps], color=color, linewidth=0.8, linestyle="--")
    load.plot(at, [float(r["payload"]) for r in steps], color="black", linewidth=0.8, label="truth")
    load.set(ylabel="load in z [N]", title="CoGiRo takes up 18 kg and puts them down", xticklabels=[])
    load.legend(fontsize="small")
    error.set(xlabel="message", ylabel="error, 2 sigma [N]")


def write_tables(directory, path):
    with open(path) as file:
        text = file.read()
    for name in TABLES:
        with open(os.path.join(directory, name + ".md")) as file:
            block = f"<!-- {name} -->\n" + file.read().strip() + "\n<!-- end -->"
        text, count = re.subn(rf"<!-- {name} -->.*?<!-- end -->", lambda _: block, text, flags=re.DOTALL)
        if count != 1:
            sys.exit(f"{path}: expected one place for the table {name}, found {count}")
    with open(path, "w") as file:
        file.write(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", help="of the results: CSV files and tables")
    parser.add_argument("docs", help="of estimation.md and images/")
    arguments = parser.parse_args()
    figure, axes = plt.subplot_mosaic(
        [["consistency", "faults", "load"], ["consistency", "faults", "error"]], figsize=(13, 4), constrained_layout=True
    )
    plot_consistency(axes["consistency"], read(arguments.directory, "consistency.csv"))
    plot_faults(axes["faults"], read(arguments.directory, "faults.csv"))
    plot_load(axes["load"], axes["error"], read(arguments.directory, "load_change.csv"))
    figure.savefig(os.path.join(arguments.docs, "images", "estimation.png"), dpi=80)
    write_tables(arguments.directory, os.path.join(arguments.docs, "estimation.md"))


if __name__ == "__main__":
    main()
