#!/usr/bin/env python3
"""Homes the winches of a rig at rest whose zeros nobody knows, and says what that changes."""

import argparse
import math
import sys
import threading

import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from cdpr_kinetostatics.msg import SolveReport
from cdpr_kinetostatics.srv import Home


class Errors:
    """Differences of estimated and true positions of the same stamp, as they arrive."""

    def __init__(self):
        self.lock = threading.Condition()
        self.truths, self.pose, self.differences = {}, None, []
        self.subscribers = [
            rospy.Subscriber("true_pose", PoseStamped, self.on_truth, queue_size=1000),
            rospy.Subscriber("platform_pose", PoseWithCovarianceStamped, self.on_estimate, queue_size=1000),
        ]

    def on_truth(self, message):
        with self.lock:
            self.pose = message.pose
            self.truths[message.header.stamp] = message.pose.position

    def on_estimate(self, message):
        with self.lock:
            truth = self.truths.get(message.header.stamp)
            if truth is None:
                return
            p = message.pose.pose.position
            self.differences.append((p.x - truth.x, p.y - truth.y, p.z - truth.z))
            self.lock.notify_all()

    def mean(self, count, limit=60.0):
        """Distance [m] of the mean of the next estimates from the truth: noise averages out, wrong offsets stay."""
        with self.lock:
            self.differences.clear()
            if not self.lock.wait_for(lambda: len(self.differences) >= count, timeout=limit):
                sys.exit("no estimates: is the rig running? rostopic echo /diagnostics says what the node waits for")
            return math.sqrt(sum((sum(axis) / len(axis)) ** 2 for axis in zip(*self.differences)))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--samples", type=int, default=100, help="measurements to average")
    parser.add_argument("--without-tensions", action="store_true", help="take tensions from equilibrium")
    arguments = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("home_client", anonymous=True, disable_signals=True)
    errors = Errors()
    before = errors.mean(100)
    rospy.wait_for_service("kinetostatics/home", timeout=30.0)
    home = rospy.ServiceProxy("kinetostatics/home", Home)
    reply = home(errors.pose, not arguments.without_tensions, rospy.Duration(0), arguments.samples)
    if reply.report.code != SolveReport.CONVERGED:
        sys.exit(f"FAILED: {reply.report.message}")
    print(f"\nHoming: {reply.report.message}")
    for i, (offset, stddev) in enumerate(zip(reply.offsets, reply.stddev)):
        print(f"  cable {i}: offset {1e3 * offset:8.2f} mm +- {1e3 * stddev:.2f} mm")
    after = errors.mean(100)
    print(f"  error of the estimated position, noise averaged: {1e3 * before:.2f} mm before, {1e3 * after:.2f} mm after")
    if after >= before:
        sys.exit("FAILED: the estimate has not become better")


if __name__ == "__main__":
    main()
