#!/usr/bin/env python3
"""Checks section4's results against an independent solver, and computes what docs/section4.md says beyond them.

    scripts/studies/section4_reference.py DIRECTORY [--quick]     (DIRECTORY: where section4 wrote two_cables.csv)

Prints the largest distance from the independent solution, equilibria other than the hanging one, what the load and
bars of another stiffness change. Writes equilibria.csv and loads.csv. Fails if a position differs by more than 1e-9 m.
"""

import argparse
import csv
import pathlib
import sys

import numpy as np
from section4_collocation import EA, EI, BendingPair, catenary, straight

TOLERANCE = 1e-9  # [m]


def independent(model, load, lengths):
    if model == "straight":
        return straight(lengths)
    if model == "catenary":
        return catenary(load, lengths)[0]
    pair = BendingPair(load, lengths, EA if model == "bending" else np.inf)
    return pair.position(pair.solve())


def check(directory, every):
    worst = {}
    with open(directory / "two_cables.csv") as file:
        for row in csv.DictReader(file):
            length = float(row["length_1_m"])
            if abs(length / every - round(length / every)) > 1e-9:
                continue
            expected = independent(row["model"], float(row["load_N"]), (length, 7.0))
            distance = np.hypot(float(row["x_m"]) - expected[0], float(row["y_m"]) - expected[1])
            key = (row["model"], row["method"])
            worst[key] = max(worst.get(key, 0), distance)
    print("largest distance from the independent solution")
    for (model, method), distance in worst.items():
        print(f"  {model:21s} {method:8s} {distance:.1e} m")
    return max(worst.values()) < TOLERANCE


def random_start(pair, dice):
    parts = []
    for length in pair.lengths:
        t = pair.t
        waves = sum(a * dice.normal() * np.cos(k * np.pi * t) for k, a in ((1, 1.2), (2, 0.7), (3, 0.4)))
        mean = dice.uniform(-1.5, 1.5)
        parts += [mean + waves, 0 * t, t * length * np.cos(mean), t * length * np.sin(mean)]
    h, v1 = dice.uniform(-3000, 3000), dice.uniform(-750, 1250)
    return np.concatenate(parts + [[h, v1, v1]])


def equilibria(load, lengths, starts):
    """Distinct solutions without loops that Newton's method reaches from random starts."""
    pair = BendingPair(load, lengths, np.inf, n=28)
    dice = np.random.default_rng(3)
    found = []
    for _ in range(starts):
        z = pair.solve(random_start(pair, dice), turn=0.5, iterations=60)
        if z is None or max(np.ptp(pair.shape(z, k)[0]) for k in (0, 1)) > 4.56:  # a teardrop turns by 261.4 degrees
            continue
        if all(np.abs(pair.forces(z) - pair.forces(other)).max() > 0.05 for other in found):
            found.append(z)
    rows = [(pair.falling_directions(z), *pair.position(z), *pair.forces(z)[:2]) for z in found]
    return sorted(rows)


def write_equilibria(directory, starts):
    print("\nequilibria of the inextensible bending model without loops")
    with open(directory / "equilibria.csv", "w") as file:
        file.write("load_N,length_1_m,falling_directions,x_m,y_m,H_N,V_1_N\n")
        for load in (500.0, 10000.0):
            for length in (4.0, 5.0):
                for row in equilibria(load, (length, 7.0), starts):
                    file.write(",".join(str(value) for value in (load, length, *row)) + "\n")
                    falling, x, y, h, _ = row
                    print(f"  {load:6.0f} N  {length:.0f} m  falling {falling:2d}  ({x:.4f}, {y:.4f}) m  H {h:.1f} N")


def write_loads(directory):
    lengths = (4.0, 7.0)
    line = straight(lengths)
    print("\ndistance from the straight model at L1 = 4 m [mm]; negative: below it")
    with open(directory / "loads.csv", "w") as file:
        file.write("load_N,catenary_mm,bending_inextensible_mm,bending_mm\n")
        for load in (500.0, 1000.0, 2000.0, 2500.0, 3000.0, 5000.0, 10000.0, 20000.0, 40000.0):
            row = []
            for model in ("catenary", "bending_inextensible", "bending"):
                away = independent(model, load, lengths) - line
                row.append(1e3 * np.copysign(np.hypot(*away), away[1]))
            file.write(f"{load:.0f}," + ",".join(f"{value:.6f}" for value in row) + "\n")
            print(f"  {load:6.0f} N  " + "  ".join(f"{value:9.4f}" for value in row))


def print_stiffer_bars():
    print("\ndistance from the straight model at 0.5 kN, L1 = 4 m, if EI were larger [mm]")
    for factor in (1, 4, 16, 64):
        away = []
        for ea in (np.inf, EA):
            pair = BendingPair(500.0, (4.0, 7.0), ea, factor * EI)
            away.append(1e3 * np.hypot(*(pair.position(pair.solve()) - straight((4.0, 7.0)))))
        print(f"  {factor:3d} EI   inextensible {away[0]:.4f}   extensible {away[1]:.4f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="fewer points and starts")
    arguments = parser.parse_args()
    agrees = check(arguments.directory, 0.5 if arguments.quick else 0.1)
    write_equilibria(arguments.directory, 20 if arguments.quick else 250)
    write_loads(arguments.directory)
    print_stiffer_bars()
    if not agrees:
        sys.exit(f"section4_reference: a position differs by more than {TOLERANCE} m")


if __name__ == "__main__":
    main()
