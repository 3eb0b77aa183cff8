#!/usr/bin/python3
"""scipy.integrate.solve_bvp against this package (docs/performance.md, item 6).

One cable between two ends at equal error, and the forward kinetostatics of a robot with a boundary value problem per
cable inside scipy.optimize.root, as the paper's authors swept their unknowns. solve_bvp starts from the
catenary, in units that suit it. "As it comes" it has a uniform mesh and Jacobians by differences, bvp4c's defaults;
"at its best" it is also given a mesh that is fine in the bending layers, analytic Jacobians and, in the robot, the last
solution of each cable.
    compare_scipy.py --programs DIR [--quick] [--csv FILE]      DIR: where the program solve_times is
"""
import argparse
import csv
import io
import json
import math
import os
import subprocess
import sys
import time

# On one core, and by the time of this process: one run of a robot is too long to wait for a quiet moment.
os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")

import numpy as np
from scipy.integrate import solve_bvp
from scipy.optimize import root

ROBOTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "config", "robots")

# Smaller errors are rounding.
ROUNDING = 1e-11

# What both are asked for: of the forces, relative, and of the end slopes [rad].
EQUAL_ERROR = 1e-8

# EA [N], EI [N m^2], q [N/m], L, x, w [m]
CABLES = {
    "CoGiRo's rope, 9 m": (287178.5, 0.44, 0.62784, 8.9300, 8.0, -4.0),
    "music wire, 0.6 m": (353429.2, 0.0497, 0.13609, 0.640308, 0.5, -0.4),
    "the paper's bar, taut": (53407075.1, 1335.177, 24.8094, 5.58916, 5.0, -2.5),
    "the paper's bar, bowed": (53407075.1, 1335.177, 24.8094, 5.650, 5.0, -2.5),
}


class Cable:
    """The bending cable of given length as a boundary value problem on t = s/L, y = (alpha, M, x, w), p = (H, V).

    Scales: moments by EI/L, x and w by L, forces by `force`.
    """

    def __init__(self, properties, length, force):
        self.ea, self.ei, self.q = properties
        self.length = length
        self.force = force

    def parts(self, t, y, p):
        h, v = p * self.force
        c, s = np.cos(y[0]), np.sin(y[0])
        down = v - self.q * self.length * t
        tension = h * c - down * s
        shear = h * s + down * c
        return c, s, tension, shear, 1.0 + tension / self.ea

    def slope(self, t, y, p):
        c, s, _, shear, e = self.parts(t, y, p)
        return np.vstack((e * y[1], e * shear * self.length**2 / self.ei, e * c, e * s))

    def slope_jacobian(self, t, y, p):
        c, s, tension, shear, e = self.parts(t, y, p)
        stiff = self.length**2 / self.ei
        by_state = np.zeros((4, 4, t.size))
        by_force = np.zeros((4, 2, t.size))
        de = -shear / self.ea
        by_state[0, 0] = de * y[1]
        by_state[0, 1] = e
        by_state[1, 0] = stiff * (de * shear + e * tension)
        by_state[2, 0] = de * c - e * s
        by_state[3, 0] = de * s + e * c
        for k, (dt, ds) in enumerate(((c, s), (-s, c))):
            de = self.force * dt / self.ea
            by_force[0, k] = de * y[1]
            by_force[1, k] = stiff * (de * shear + e * self.force * ds)
            by_force[2, k] = de * c
            by_force[3, k] = de * s
        return by_state, by_force

    def solve(self, x, w, guess, tolerance, jacobian):
        """solve_bvp's answer from guess = (mesh, y, p)."""
        def ends(a, b, _):
            return np.array([a[1], a[2], a[3], b[1], b[2] - x / self.length, b[3] - w / self.length])

        def ends_jacobian(_a, _b, _p):
            by_a, by_b = np.zeros((6, 4)), np.zeros((6, 4))
            by_a[0, 1] = by_a[1, 2] = by_a[2, 3] = 1.0
            by_b[3, 1] = by_b[4, 2] = by_b[5, 3] = 1.0
            return by_a, by_b, np.zeros((6, 2))

        mesh, y, p = guess
        return solve_bvp(self.slope, ends, mesh, y, p, tol=tolerance, max_nodes=50000,
                         fun_jac=self.slope_jacobian if jacobian else None,
                         bc_jac=ends_jacobian if jacobian else None)

    def catenary(self, h, v, points, layered):
        """The catenary under these forces; a layered mesh is fine where the bending layers are."""
        layer = math.sqrt(self.ei / max(math.hypot(h, v), math.hypot(h, v - self.q * self.length))) / self.length
        near = layer * np.linspace(0.0, 12.0, points) if layered else np.array([0.0])
        mesh = np.unique(np.concatenate((near[near < 0.5], 1.0 - near[near < 0.5], np.linspace(0.0, 1.0, points))))
        down = v - self.q * self.length * mesh
        tension = np.hypot(h, down)
        alpha = np.arctan2(-down, h)
        e = 1.0 + tension / self.ea
        moment = self.length * self.q * h / tension**2 / e
        moment[0] = moment[-1] = 0.0
        steps = np.diff(mesh)
        x, w = e * np.cos(alpha), e * np.sin(alpha)
        summed = [np.concatenate(([0.0], np.cumsum(0.5 * steps * (f[1:] + f[:-1])))) for f in (x, w)]
        return mesh, np.vstack((alpha, moment, summed[0], summed[1])), np.array([h, v]) / self.force


def fastest_of(runs, call):
    """Shortest time of so many calls, and what the last returned."""
    best = math.inf
    for _ in range(runs):
        begin = time.process_time()
        answer = call()
        best = min(best, time.process_time() - begin)
    return best, answer


def compare_cables(programs, quick, report):
    text = "".join(" ".join(map(str, cable)) + "\n" for cable in CABLES.values())
    output = subprocess.run([os.path.join(programs, "solve_times"), "cables"], input=text, check=True,
                            capture_output=True, text=True).stdout
    ours = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(io.StringIO(output))]
    for i, (name, (ea, ei, q, length, x, w)) in enumerate(CABLES.items()):
        mine = [row for row in ours if row["case"] == i]
        exact = mine[-1]
        force = math.hypot(exact["h"], exact["v"])

        def error(h, v, angle_a, angle_b):
            return max(math.hypot(h - exact["h"], v - exact["v"]) / force, abs(angle_a - exact["angle_a"]),
                       abs(angle_b - exact["angle_b"]), ROUNDING)

        def our_error(row):
            return error(row["h"], row["v"], row["angle_a"], row["angle_b"])

        cable = Cable((ea, ei, q), length, force)
        print(f"\n{name}: largest error of the forces, relative, and of the end slopes [rad]; time")
        for row in mine[:-1]:
            print(f"  ours, tolerance {row['tolerance']:.0e}: {our_error(row):.1e}, "
                  f"{1e6 * row['seconds']:.1f} us")
        equal = min(row["seconds"] for row in mine[:-1] if our_error(row) <= EQUAL_ERROR)
        for best in (False, True):
            kind = "at its best" if best else "as it comes"
            runs = []
            for points in ((20,) if quick else (10, 20, 40, 80)):
                guess = cable.catenary(exact["catenary_h"], exact["catenary_v"], points, best)
                for tolerance in 10.0 ** -np.arange(4.0 if quick else 2.0, 9.0):
                    seconds, answer = fastest_of(1 if quick else 3, lambda: cable.solve(x, w, guess, tolerance, best))
                    if answer.status == 0:
                        its = error(*(answer.p * force), answer.y[0, 0], answer.y[0, -1])
                        runs.append((its, seconds, tolerance, points, answer.x.size))
            for run in sorted(runs, reverse=True):
                if any(other[0] <= run[0] and other[1] < run[1] for other in runs):
                    continue  # another run is both faster and no less exact
                print(f"  solve_bvp {kind}, tolerance {run[2]:.0e}, {run[3]} -> {run[4]} points: {run[0]:.1e}, "
                      f"{1e3 * run[1]:.1f} ms")
            exact_enough = [run[1] for run in runs if run[0] <= EQUAL_ERROR]
            if exact_enough:
                report.append((6, f"{name}: solve_bvp {kind} / ours, to {EQUAL_ERROR:.0e}", min(exact_enough) / equal,
                               ">=", 200))
            else:
                print(f"  solve_bvp {kind} did not get to {EQUAL_ERROR:.0e}")


def rotation(quaternion):
    x, y, z, w = quaternion
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def turned(vector):
    """The rotation matrix of a rotation vector."""
    angle = np.linalg.norm(vector)
    if angle == 0.0:
        return np.eye(3)
    a = vector / angle
    cross = np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
    return np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross


class NestedForward:
    """Forward kinetostatics with a boundary value problem per cable inside the equations of equilibrium."""

    def __init__(self, robot, tolerance, best):
        self.robot = robot
        self.best = best
        self.tolerance = tolerance
        self.start_rotation = rotation(robot["start"]["orientation"])
        self.radius = max([np.linalg.norm(c["attachment"]) for c in robot["cables"]] + [1e-3])
        self.problems = 0
        self.cables = []
        self.guesses = []
        for c in robot["cables"]:
            force = math.hypot(*c["start_forces"])
            cable = Cable(c["properties"], c["length"], force)
            self.cables.append(cable)
            self.guesses.append(cable.catenary(*c["start_forces"], 20, best))

    def freedoms(self):
        """Unknowns: a point mass on two cables moves in their plane."""
        if self.robot["freedoms"] == 6:
            return 6
        return 2 if len(self.cables) == 2 else 3

    def pose(self, unknowns):
        n = self.freedoms()
        position = np.array(self.robot["start"]["position"])
        if n == 2:
            return position + [unknowns[0], 0.0, unknowns[1]], self.start_rotation
        turn = turned(unknowns[3:] / self.radius) if n == 6 else np.eye(3)
        return position + unknowns[:3], turn @ self.start_rotation

    def unbalanced(self, unknowns):
        position, turn = self.pose(unknowns)
        force = np.array([0.0, 0.0, -self.robot["weight"]])
        moment = np.cross(turn @ np.array(self.robot["com"]), force)
        for i, (cable, c) in enumerate(zip(self.cables, self.robot["cables"])):
            arm = turn @ np.array(c["attachment"])
            to_b = position + arm - np.array(c["anchor"])
            x = math.hypot(to_b[0], to_b[1])
            answer = cable.solve(x, to_b[2], self.guesses[i], self.tolerance, self.best)
            self.problems += 1
            if answer.status != 0:
                raise RuntimeError(f"solve_bvp: {answer.message}")
            if self.best:
                self.guesses[i] = (answer.x, answer.y, answer.p)
            h, v = answer.p * cable.force
            pull = np.array([-h * to_b[0] / x, -h * to_b[1] / x, v - cable.q * cable.length])
            force = force + pull
            moment = moment + np.cross(arm, pull)
        n = self.freedoms()
        if n == 2:
            return force[[0, 2]] / self.robot["weight"]
        return np.concatenate((force, moment / self.radius))[:n] / self.robot["weight"]

    def solve(self):
        return root(self.unbalanced, np.zeros(self.freedoms()), method="hybr", tol=1e-9)


def compare_robot(programs, name, displacement, tolerances, report):
    output = subprocess.run([os.path.join(programs, "solve_times"), "robot", os.path.join(ROBOTS, name + ".yaml")] +
                            [str(d) for d in displacement], check=True, capture_output=True, text=True).stdout
    robot = json.loads(output)
    our_error = np.linalg.norm(np.subtract(robot["found"]["position"], robot["pose"]["position"]))
    print(f"\n{name}, forward from {1e3 * np.linalg.norm(displacement):.0f} mm away: ours "
          f"{1e6 * robot['cold_seconds']:.0f} us cold, {1e6 * robot['warm_seconds']:.0f} us warm, position error {our_error:.1e} m")
    for best in (False, True):
        kind = "at its best" if best else "as it comes"
        least = math.inf
        for tolerance in tolerances:
            nested = NestedForward(robot, tolerance, best)
            begin = time.process_time()
            try:
                answer = nested.solve()
            except RuntimeError as problem:
                print(f"  solve_bvp {kind} at {tolerance:.0e}: {problem}")
                continue
            seconds = time.process_time() - begin
            error = np.linalg.norm(nested.pose(answer.x)[0] - robot["pose"]["position"])
            print(f"  solve_bvp {kind} at {tolerance:.0e}: {seconds:.2f} s, {nested.problems} boundary value problems, "
                  f"position error {error:.1e} m{'' if answer.success else ', root did not converge'}")
            if error < 1e-6:
                least = min(least, seconds)
        if math.isfinite(least):
            for start in ("warm", "cold"):
                report.append((6, f"{name}: forward, solve_bvp {kind} inside root / ours, {start}",
                               least / robot[start + "_seconds"], ">=", 3000))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--programs", required=True)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--csv")
    arguments = parser.parse_args()
    report = []
    compare_cables(arguments.programs, arguments.quick, report)
    # One step of a path: the paper's by changing L1, CoGiRo's by 10 mm.
    tolerances = (1e-3,) if arguments.quick else (1e-3, 1e-5)
    compare_robot(arguments.programs, "paper_point_mass", (0.01, 0.0, 0.0), tolerances, report)
    if not arguments.quick:
        compare_robot(arguments.programs, "cogiro", (0.01, 0.0, 0.0), tolerances, report)
    print()
    for item, quantity, measured, relation, target in report:
        verdict = "met" if measured >= target else "missed"
        print(f"{item}  {quantity:<78} {measured:10.4g}  ({relation} {target}: {verdict})")
    if arguments.csv:
        with open(arguments.csv, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["item", "quantity", "measured", "unit", "relation", "target"])
            for item, quantity, measured, relation, target in report:
                writer.writerow([item, quantity, measured, "", relation, target])
    return 0 if report else 1


if __name__ == "__main__":
    sys.exit(main())
