#!/usr/bin/env python3
"""Moves a robot's platform on paper: pose -> cable lengths -> pose, once per cable model, and prints what it found and
which models AUTO would take."""

import argparse
import math
import sys

import rospy
from geometry_msgs.msg import Point, Pose, Quaternion
from cdpr_kinetostatics.msg import CableState, SolveReport, SolverOptions
from cdpr_kinetostatics.srv import ForwardKinetostatics, InverseKinetostatics

MODELS = (
    ("straight", SolverOptions.STRAIGHT),
    ("straight_elastic", SolverOptions.STRAIGHT_ELASTIC),
    ("catenary", SolverOptions.CATENARY),
    ("bending", SolverOptions.BENDING),
)
CONDITIONS = {CableState.TAUT: "taut", CableState.SLACK: "slack", CableState.COMPRESSED: "compressed"}
TIMEOUT = rospy.Duration(5)  # of one solve
STEP = 0.01  # distance from home to the pose asked for, in spans of the frame
MAX_POSITION_ERROR = 1e-6  # in spans of the frame
MAX_ROTATION_ERROR = 1e-5  # [rad]


def quaternion(roll, pitch, yaw):
    """Fixed axes x, y, z, as in the robot description."""
    cr, sr = math.cos(roll / 2), math.sin(roll / 2)
    cp, sp = math.cos(pitch / 2), math.sin(pitch / 2)
    cy, sy = math.cos(yaw / 2), math.sin(yaw / 2)
    return Quaternion(
        x=sr * cp * cy - cr * sp * sy,
        y=cr * sp * cy + sr * cp * sy,
        z=cr * cp * sy - sr * sp * cy,
        w=cr * cp * cy + sr * sp * sy,
    )


def distance(a, b):
    return math.sqrt((a.x - b.x) ** 2 + (a.y - b.y) ** 2 + (a.z - b.z) ** 2)


def angle(a, b):
    """Angle between two attitudes [rad], exact for small ones too."""
    minus = math.sqrt((a.x - b.x) ** 2 + (a.y - b.y) ** 2 + (a.z - b.z) ** 2 + (a.w - b.w) ** 2)
    plus = math.sqrt((a.x + b.x) ** 2 + (a.y + b.y) ** 2 + (a.z + b.z) ** 2 + (a.w + b.w) ** 2)
    return 4 * math.asin(min(1.0, min(minus, plus) / 2))


class Robot:
    """What the demonstration needs to know of ~robot."""

    def __init__(self, description):
        platform = description["platform"]
        anchors = [Point(*(float(c) for c in point["frame"])) for point in description["points"]]
        home = [float(c) for c in platform["position"]["xyz"]]
        rpy = [float(c) for c in platform["position"].get("rpy", [0, 0, 0])]
        self.name = description.get("name", "robot")  # the node's own default
        self.span = max(distance(a, b) for a in anchors for b in anchors)
        self.target = Pose(Point(home[0] + STEP * self.span, home[1], home[2]), quaternion(*rpy))
        is_point = platform.get("type", "rigid_body") == "point_mass"
        self.free_orientation = not is_point and len(anchors) < 6


def report_of(what, report):
    if report.code != SolveReport.CONVERGED:
        sys.exit(f"{what} failed with code {report.code}: {report.message}")
    return report


def run(node, robot):
    inverse = rospy.ServiceProxy(f"{node}/inverse_kinetostatics", InverseKinetostatics)
    forward = rospy.ServiceProxy(f"{node}/forward_kinetostatics", ForwardKinetostatics)
    p = robot.target.position
    print(f"\nRobot {robot.name}: lengths for the platform at ({p.x:.4f}, {p.y:.4f}, {p.z:.4f}) m, and the pose from them")
    print(f"\n{'model':>17} {'position error':>15} {'rotation error':>15} {'inverse':>10} {'forward':>10}")
    recovered = True
    answers = {}
    for name, model in MODELS:
        options = SolverOptions(model=model, timeout=TIMEOUT)
        lengths = inverse(pose=robot.target, free_orientation=robot.free_orientation, options=options)
        report_of(f"inverse_kinetostatics ({name})", lengths.report)
        pose = forward(lengths=lengths.lengths, options=options)
        report_of(f"forward_kinetostatics ({name})", pose.report)
        position_error = distance(pose.pose.position, lengths.pose.position)
        rotation_error = angle(pose.pose.orientation, lengths.pose.orientation)
        recovered &= position_error < MAX_POSITION_ERROR * robot.span and rotation_error < MAX_ROTATION_ERROR
        answers[name] = pose.cables
        print(
            f"{name:>17} {position_error:13.2e} m {rotation_error:11.2e} rad "
            f"{1e3 * lengths.report.solve_time:7.2f} ms {1e3 * pose.report.solve_time:7.2f} ms"
        )
    options = SolverOptions(model=SolverOptions.AUTO, timeout=TIMEOUT)
    choice = inverse(pose=robot.target, free_orientation=robot.free_orientation, options=options)
    print(f"\nAUTO: {report_of('inverse_kinetostatics (auto)', choice.report).message}")
    print("\nCables, by the bending model; the last column is what the catenary misses")
    print(f"\n{'cable':>12} {'length':>12} {'tension A':>12} {'tension B':>12} {'sag':>11} {'':>10} {'length - catenary':>18}")
    for cable, catenary in zip(answers["bending"], answers["catenary"]):
        print(
            f"{cable.name:>12} {cable.length:10.4f} m {cable.tension_a:10.2f} N {cable.tension_b:10.2f} N "
            f"{1e3 * cable.sag:8.2f} mm {CONDITIONS[cable.condition]:>10} {1e6 * (cable.length - catenary.length):15.3f} um"
        )
    return recovered


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--node", default="/kinetostatics", help="name of the node")
    parser.add_argument("--wait", type=float, default=30.0, help="how long to wait for the node [s]")
    arguments = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("demo_client", anonymous=True, disable_signals=True)
    try:
        rospy.wait_for_service(f"{arguments.node}/forward_kinetostatics", timeout=arguments.wait)
        rospy.wait_for_service(f"{arguments.node}/solve_cable", timeout=arguments.wait)
    except rospy.ROSException as problem:
        sys.exit(f"the node {arguments.node} does not answer: {problem}")
    if not run(arguments.node, Robot(rospy.get_param(f"{arguments.node}/robot"))):
        sys.exit("\nFAILED: a pose was not recovered")
    print("\nOK: every pose was recovered")


if __name__ == "__main__":
    main()
