#!/usr/bin/env python3
"""Listens to the rig's truth and the node's estimates until there are enough, prints rate, latency and errors."""

import argparse
import math
import sys
import threading

import numpy as np
import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from cdpr_kinetostatics.msg import KinetostaticState, SolveReport


def angle(a, b):
    """Angle between two attitudes [rad], exact for small ones too."""
    minus = math.sqrt((a.x - b.x) ** 2 + (a.y - b.y) ** 2 + (a.z - b.z) ** 2 + (a.w - b.w) ** 2)
    plus = math.sqrt((a.x + b.x) ** 2 + (a.y + b.y) ** 2 + (a.z + b.z) ** 2 + (a.w + b.w) ** 2)
    return 4 * math.asin(min(1.0, min(minus, plus) / 2))


class Track:
    def __init__(self):
        self.lock = threading.Condition()
        self.truths, self.estimates, self.states = {}, {}, {}
        self.subscribers = [
            rospy.Subscriber("true_pose", PoseStamped, self.on_truth, queue_size=10000),
            rospy.Subscriber("platform_pose", PoseWithCovarianceStamped, self.on_estimate, queue_size=10000),
            rospy.Subscriber("kinetostatic_state", KinetostaticState, self.on_state, queue_size=10000),
        ]

    def on_truth(self, message):
        with self.lock:
            self.truths[message.header.stamp.to_nsec()] = message.pose

    def on_estimate(self, message):
        latency = (rospy.Time.now() - message.header.stamp).to_sec()
        with self.lock:
            self.estimates[message.header.stamp.to_nsec()] = (message.pose, latency)
            self.lock.notify_all()

    def on_state(self, message):
        with self.lock:
            self.states[message.header.stamp.to_nsec()] = message.report

    def duration(self):
        stamps = self.truths.keys() & self.estimates.keys()
        return 1e-9 * (max(stamps) - min(stamps)) if stamps else 0.0

    def wait(self, duration, limit):
        """True once estimates cover `duration` [s]; False if `limit` [s] passes before."""
        with self.lock:
            return self.lock.wait_for(lambda: self.duration() >= duration, timeout=limit)

    def table(self):
        """Rows of time, position error, rotation error, predicted position deviation, latency."""
        with self.lock:
            stamps = sorted(self.truths.keys() & self.estimates.keys())
            rows = []
            for stamp in stamps:
                truth, (estimate, latency) = self.truths[stamp], self.estimates[stamp]
                p, q = estimate.pose.position, truth.position
                error = math.sqrt((p.x - q.x) ** 2 + (p.y - q.y) ** 2 + (p.z - q.z) ** 2)
                deviation = math.sqrt(sum(estimate.covariance[7 * k] for k in range(3)))
                turn = angle(estimate.pose.orientation, truth.orientation)
                rows.append((1e-9 * (stamp - stamps[0]), error, turn, deviation, latency))
            return np.array(rows)


def plot(table, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(8, 4), constrained_layout=True)
    axes.plot(table[:, 0], 1e3 * table[:, 1], linewidth=0.8, label="position error")
    axes.plot(table[:, 0], 1e3 * table[:, 3], linewidth=1.2, label="predicted standard deviation")
    axes.set_xlabel("time [s]")
    axes.set_ylabel("[mm]")
    axes.set_ylim(bottom=0)
    axes.legend()
    axes.grid(True, alpha=0.3)
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--duration", type=float, default=20.0, help="how long to track [s]")
    parser.add_argument("--limit", type=float, default=90.0, help="how long to wait for that [s]")
    parser.add_argument("--plot", help="file for a picture of the error over time")
    parser.add_argument("--point-mass", action="store_true", help="do not speak of attitudes")
    arguments = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("track_client", anonymous=True, disable_signals=True)
    track = Track()
    enough = track.wait(arguments.duration, arguments.limit)
    table = track.table()
    if len(table) == 0:
        sys.exit("no estimates: is the rig running? rostopic echo /diagnostics says what the node waits for")
    failures = sum(report.code != SolveReport.CONVERGED for report in track.states.values())
    latency = 1e3 * table[:, 4]
    duration = table[-1, 0]
    print(f"\nTracking for {duration:.1f} s: {len(table)} estimates, {(len(table) - 1) / max(duration, 1e-9):.1f} per second, {failures} failed")
    print(f"  latency         median {np.median(latency):7.2f} ms   99 % {np.percentile(latency, 99):7.2f} ms")
    print(f"  position error  rms {1e3 * np.sqrt(np.mean(table[:, 1] ** 2)):10.3f} mm   max {1e3 * table[:, 1].max():8.3f} mm")
    print(f"  predicted       rms {1e3 * np.sqrt(np.mean(table[:, 3] ** 2)):10.3f} mm")
    if not arguments.point_mass:
        print(f"  rotation error  rms {1e3 * np.sqrt(np.mean(table[:, 2] ** 2)):10.3f} mrad max {1e3 * table[:, 2].max():8.3f} mrad")
    if arguments.plot:
        plot(table, arguments.plot)
    if not enough:
        sys.exit(f"FAILED: only {duration:.1f} of {arguments.duration:.1f} s within {arguments.limit:.0f} s")
    if table[:, 1].max() > 10 * table[:, 3].max():
        sys.exit("FAILED: the error is beyond what the covariance predicts")


if __name__ == "__main__":
    main()
