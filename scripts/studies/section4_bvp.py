#!/usr/bin/env python3
"""Times the paper's way to place the point mass, with scipy's solve_bvp (the method of bvp4c) for each cable.

    scripts/studies/section4_bvp.py DIRECTORY [--quick]     (DIRECTORY: where section4 wrote two_cables.csv)

Ways, extensible bending model, L1 = 4.5 m, 0.5 and 10 kN:
    positions   scipy.optimize.root on the mass' position; problem 2 gives each cable's forces, balance is the residual
    forces      scipy.optimize.root on (H, V_1); problem 1 gives each cable's end, the gap between them is the residual
    grid        (H, V_1) by ever finer grids of 5 x 5, as benchmark/support/two_cable_sweep.h
    together    one solve_bvp with both cables mapped to [0, 1], their coupling as boundary conditions
Writes bvp.csv. Needs numpy and scipy.
"""

import argparse
import csv
import pathlib
import time

import numpy as np
from scipy.integrate import solve_bvp
from scipy.optimize import root
from section4_collocation import ANCHORS, EA, EI, Q, SIDE, BendingPair, catenary, catenary_end

TOLERANCE = 1e-6  # of solve_bvp: nodes are then more accurate than 1e-10 m
LENGTHS = (4.5, 7.0)  # [m]
FORCE = 1000.0  # [N] unit of the unknown forces
NODES = 21


def slopes(s, y, h, v):
    """The paper's five equations of problem 1, y = (x, w, alpha, M, int x ds)."""
    c, sn, hang = np.cos(y[2]), np.sin(y[2]), Q * s - v
    e = 1 + (h * c + hang * sn) / EA
    return np.vstack([e * c, e * sn, e * y[3] / EI, e * (h * sn - hang * c), y[0]])


def start(h, v, length):
    """The catenary under the same forces, without moments."""
    s = np.linspace(0, length, NODES)
    x, w = catenary_end(h, v, s, EA)
    integral = np.r_[0, np.cumsum(np.diff(s) * (x[1:] + x[:-1]) / 2)]
    return s, np.vstack([x, w, np.arctan2(Q * s - v, h), 0 * s, integral])


def solved(result):
    if not result.success:
        raise RuntimeError(f"solve_bvp: {result.message}")
    return result


class Sweep:
    """Counts the boundary value problems that were solved."""

    def __init__(self, load):
        self.load, self.solves = load, 0

    def end(self, h, v, length):
        """Problem 1."""
        self.solves += 1
        equations = lambda s, y: slopes(s, y, h, v)
        conditions = lambda a, b: np.array([a[0], a[1], a[4], a[3], b[3]])
        return solved(solve_bvp(equations, conditions, *start(h, v, length), tol=TOLERANCE)).y[:2, -1]

    def forces(self, end, guess, length):
        """Problem 2."""
        self.solves += 1
        conditions = lambda a, b, _: np.array([a[0], a[1], a[4], a[3], b[3], b[0] - end[0], b[1] - end[1]])
        s, y = start(*guess, length)
        equations = lambda s, y, p: slopes(s, y, *(FORCE * p))
        return FORCE * solved(solve_bvp(equations, conditions, s, y, p=guess / FORCE, tol=TOLERANCE)).p

    def gap(self, h, v1):
        v2 = self.load + Q * sum(LENGTHS) - v1
        ends = [ANCHORS[k] + self.end(h, v, LENGTHS[k]) * [SIDE[k], 1] for k, v in enumerate((v1, v2))]
        return ends[0] - ends[1], (ends[0] + ends[1]) / 2

    def by_positions(self):
        position, (h, v1, v2) = catenary(self.load, LENGTHS)
        guesses = [np.array([h, v1]), np.array([h, v2])]

        def imbalance(b):
            forces = [self.forces((b - ANCHORS[k]) * [SIDE[k], 1], guesses[k], LENGTHS[k]) for k in (0, 1)]
            vertical = forces[0][1] + forces[1][1] - Q * sum(LENGTHS) - self.load
            return np.array([forces[0][0] - forces[1][0], vertical]) / self.load

        return root(imbalance, position, tol=1e-12, options={"eps": 1e-12}).x

    def by_forces(self):
        _, (h, v1, _) = catenary(self.load, LENGTHS)
        forces = self.load * root(lambda f: self.gap(*(self.load * f))[0], np.array([h, v1]) / self.load, tol=1e-12).x
        return self.gap(*forces)[1]

    def by_grid(self):
        _, (h, v1, _) = catenary(self.load, LENGTHS)
        best, width = (np.inf, np.array([h, v1]), None), 0.2 * np.array([h, v1])
        while best[0] > 1e-10:
            middle, rim = best[1], False
            for share in np.array(np.meshgrid(*[np.linspace(-1, 1, 5)] * 2)).reshape(2, -1).T:
                gap, position = self.gap(*(middle + share * width))
                if np.hypot(*gap) < best[0]:
                    best, rim = (np.hypot(*gap), middle + share * width, position), np.abs(share).max() == 1
            if not rim:
                width = width / 2
        return best[2]

    def together(self):
        self.solves += 1
        _, forces = catenary(self.load, LENGTHS)
        t = np.linspace(0, 1, NODES)
        y = np.vstack([start(forces[0], forces[1 + k], LENGTHS[k])[1][:4] for k in (0, 1)])

        def equations(t, y, p):
            h, v = FORCE * p[0], FORCE * p[1:]
            five = [np.vstack([y[4 * k : 4 * k + 4], 0 * t]) for k in (0, 1)]
            return np.vstack([LENGTHS[k] * slopes(LENGTHS[k] * t, five[k], h, v[k])[:4] for k in (0, 1)])

        def conditions(a, b, p):
            fixed = [a[0], a[1], a[3], b[3], a[4], a[5], a[7], b[7]]
            chord = ANCHORS[1] - ANCHORS[0]
            balance = p[1] + p[2] - (self.load + Q * sum(LENGTHS)) / FORCE
            return np.array(fixed + [b[0] + b[4] - chord[0], b[1] - b[5] - chord[1], balance])

        return solved(solve_bvp(equations, conditions, t, y, p=forces / FORCE, tol=TOLERANCE)).y[:2, -1]


def coupled_time(directory, load):
    """Time of section4's coupled solve at the same point, default tolerance [s]."""
    with open(directory / "two_cables.csv") as file:
        for row in csv.DictReader(file):
            same = float(row["load_N"]) == load and abs(float(row["length_1_m"]) - LENGTHS[0]) < 1e-9
            if same and row["model"] == "bending" and row["method"] == "default":
                return 1e-6 * float(row["time_us"])
    raise RuntimeError(f"two_cables.csv has no point at {load} N and {LENGTHS[0]} m")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="without the grid")
    arguments = parser.parse_args()
    ways = {"positions": Sweep.by_positions, "forces": Sweep.by_forces, "together": Sweep.together}
    if not arguments.quick:
        ways["grid"] = Sweep.by_grid
    with open(arguments.directory / "bvp.csv", "w") as file:
        file.write("load_N,way,cable_solves,time_s,ratio,error_m\n")
        for load in (500.0, 10000.0):
            pair = BendingPair(load, LENGTHS)
            expected = pair.position(pair.solve())
            ours = coupled_time(arguments.directory, load)
            for name, way in ways.items():
                times = []
                for _ in range(1 if name == "grid" or arguments.quick else 3):
                    sweep = Sweep(load)
                    begin = time.perf_counter()
                    position = way(sweep)
                    times.append(time.perf_counter() - begin)
                elapsed = float(np.median(times))
                error = np.hypot(*(position - expected))
                file.write(f"{load:.0f},{name},{sweep.solves},{elapsed:.6g},{elapsed / ours:.4g},{error:.2g}\n")
                print(
                    f"{load:6.0f} N  {name:10s} {sweep.solves:5d} boundary value problems {elapsed:9.3f} s, "
                    f"{elapsed / ours:9.0f} times section4's {1e3 * ours:.2f} ms; error {error:.1e} m"
                )


if __name__ == "__main__":
    main()
