#!/usr/bin/python3
"""Draws what bending does to one cable, by the ~solve_cable service: shapes, and the tension over the length.

    roslaunch cdpr_kinetostatics kinetostatics.launch
    scripts/studies/plot_cable_models.py docs/cable_models.png       (needs python3-matplotlib)
"""

import argparse
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import rospy
from cdpr_kinetostatics.msg import SolveReport, SolverOptions
from cdpr_kinetostatics.srv import SolveCable, SolveCableRequest

# The paper's solid bar: radius 1 cm, 170 GPa, 8050 kg/m^3.
AREA = math.pi * 0.01**2
BAR = {"axial_stiffness": 170e9 * AREA, "bending_stiffness": 170e9 * math.pi * 0.01**4 / 4, "linear_density": 8050 * AREA}
END = (5.0, -2.5)  # [m]
CHORD = math.hypot(*END)
MODELS = (("catenary", SolverOptions.CATENARY, "tab:orange"), ("bending", SolverOptions.BENDING, "tab:blue"))
RATIOS = (1.0003, 1.01, 1.3)  # length over chord, of the shapes


def solve(service, model, ratio, points=0):
    request = SolveCableRequest(
        problem=SolveCableRequest.FIND_FORCES, x=END[0], y=END[1], length=ratio * CHORD, profile_points=points, **BAR
    )
    request.options = SolverOptions(model=model, timeout=rospy.Duration(5))
    reply = service(request)
    if reply.report.code != SolveReport.CONVERGED:
        sys.exit(f"L/chord = {ratio}: {reply.report.message}")
    return reply.cable


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", help="picture to write")
    parser.add_argument("--node", default="/kinetostatics", help="name of the node")
    arguments = parser.parse_args()
    service = rospy.ServiceProxy(f"{arguments.node}/solve_cable", SolveCable)
    try:
        service.wait_for_service(timeout=10)
    except rospy.ROSException as problem:
        sys.exit(f"the node {arguments.node} does not answer: {problem}")

    figure, (shapes, tensions) = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    for name, model, color in MODELS:
        for i, ratio in enumerate(RATIOS):
            profile = solve(service, model, ratio, 201).profile
            shapes.plot([p.x for p in profile], [p.z for p in profile], color=color, label=None if i else name)
        excess = [1e-4 * 10 ** (0.01 * k) for k in range(421)]
        force = [solve(service, model, 1 + x).tension_a for x in excess]
        tensions.loglog(excess, force, color=color, label=name)
    shapes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    shapes.set_title("L/chord = " + ", ".join(str(r) for r in RATIOS))
    shapes.legend()
    tensions.axhline(220, color="gray", linewidth=0.8, linestyle="--")
    tensions.set(xlabel="L/chord - 1", ylabel="tension at A [N]", title="220 N: two lengths, or four")
    tensions.legend()
    figure.savefig(arguments.file, dpi=100)


if __name__ == "__main__":
    main()
