#!/usr/bin/env python3
"""Counts what the rig sends and what the node makes of it for some time; prints a table and writes it as JSON."""

import argparse
import json
import os
import struct
import sys
import threading
import time
import xmlrpc.client

import numpy as np
import rosgraph
import rospy
from diagnostic_msgs.msg import DiagnosticArray

LIMIT = 60.0  # how long to wait for anything but the measurement itself [s]
WARM_UP = 2.0  # time between the rig's first lap and the measurement [s]


class Arrivals:
    """Stamps of a topic's messages and when they came. The body stays unread: reading 1000 a second takes a core."""

    HEADER = struct.Struct("<III")  # seq, seconds, nanoseconds

    def __init__(self, topic):
        self.changed = threading.Condition()
        self.stamps, self.times = [], []
        self.subscriber = rospy.Subscriber(
            topic, rospy.AnyMsg, self.add, queue_size=100000, buff_size=1 << 20, tcp_nodelay=True
        )

    def add(self, message):
        now = time.time_ns()
        _, seconds, nanoseconds = self.HEADER.unpack_from(message._buff)
        with self.changed:
            self.stamps.append(10**9 * seconds + nanoseconds)
            self.times.append(now)
            self.changed.notify_all()

    def wait_for_count(self, count):
        with self.changed:
            if not self.changed.wait_for(lambda: len(self.stamps) >= count, timeout=LIMIT):
                sys.exit(f"FAILED: {len(self.stamps)} of {count} messages on {self.subscriber.resolved_name} within {LIMIT:.0f} s")

    def wait_for_stamp(self, stamp, limit):
        """Until a message of that stamp or later is here; ends the program after `limit` [s]."""
        with self.changed:
            if not self.changed.wait_for(lambda: self.stamps and self.stamps[-1] >= stamp, timeout=limit):
                sys.exit(f"FAILED: nothing on {self.subscriber.resolved_name} within {limit:.0f} s")

    def between(self, first, last):
        with self.changed:
            stamps, times = np.array(self.stamps, dtype=np.int64), np.array(self.times, dtype=np.int64)
        inside = (stamps >= first) & (stamps < last)
        return stamps[inside], times[inside]


class Diagnostics:
    """The last values of each of the node's diagnostics."""

    def __init__(self):
        self.changed = threading.Condition()
        self.values, self.stamp = {}, 0
        self.subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, self.add, queue_size=100)

    def add(self, message):
        with self.changed:
            self.stamp = message.header.stamp.to_nsec()
            for status in message.status:
                self.values.update({item.key: item.value for item in status.values})
            self.changed.notify_all()

    def after(self, stamp):
        """All values, told after that time."""
        with self.changed:
            if not self.changed.wait_for(lambda: self.stamp > stamp and "solves" in self.values, timeout=LIMIT):
                sys.exit(f"FAILED: no diagnostics within {LIMIT:.0f} s")
            return dict(self.values)


class Process:
    """Processor time and memory of a node, as Linux counts them."""

    def __init__(self, node):
        uri = rosgraph.Master("/sustained_rate").lookupNode(node)
        self.pid = xmlrpc.client.ServerProxy(uri).getPid("/sustained_rate")[2]

    def cpu(self):
        """[s] since it started."""
        fields = open(f"/proc/{self.pid}/stat", encoding="utf-8").read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def memory(self):
        """[MiB] resident."""
        pages = int(open(f"/proc/{self.pid}/statm", encoding="utf-8").read().split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def measure(duration, node, rig):
    measurements, poses, diagnostics = Arrivals("cable_states"), Arrivals("platform_pose"), Diagnostics()
    poses.wait_for_stamp(time.time_ns(), LIMIT)
    lap = rospy.get_param(f"{rig}/rate") * rospy.get_param(f"{rig}/path_period")
    measurements.wait_for_count(int(lap))
    poses.wait_for_stamp(time.time_ns() + int(1e9 * WARM_UP), WARM_UP + LIMIT)
    processes = {"node": Process(node), "rig": Process(rig)}
    first = time.time_ns()
    before = diagnostics.after(first)
    memory_before = {name: process.memory() for name, process in processes.items()}
    first = time.time_ns()
    cpu_before = {name: process.cpu() for name, process in processes.items()}
    last = first + int(1e9 * duration)
    poses.wait_for_stamp(last, duration + LIMIT)
    elapsed = 1e-9 * (time.time_ns() - first)
    cpu = {name: (process.cpu() - cpu_before[name]) / elapsed for name, process in processes.items()}
    memory = {name: process.memory() for name, process in processes.items()}
    after = diagnostics.after(time.time_ns())

    sent, _ = measurements.between(first, last)
    estimated, times = poses.between(first, last)
    latency = 1e-6 * (times - estimated)
    counted = ("gave way to newer ones", "failures", "refused: malformed", "refused: stale", "refused: repeated stamp",
               "refused: out of order")  # fmt: skip
    return {
        "duration [s]": duration,
        "messages in": len(sent),
        "rate of the rig [Hz]": len(sent) / duration,
        "poses out": len(estimated),
        "without a pose": len(set(sent.tolist()) - set(estimated.tolist())),
        "latency median [ms]": float(np.median(latency)),
        "latency 99 % [ms]": float(np.percentile(latency, 99)),
        "latency max [ms]": float(latency.max()),
        "solve mean, last period [ms]": float(after["mean solve time [ms]"]),
        "node, cores": cpu["node"],
        "node, memory before [MiB]": memory_before["node"],
        "node, memory after [MiB]": memory["node"],
        "rig, cores": cpu["rig"],
        **{f"node: {key}": int(after[key]) - int(before[key]) for key in counted},
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--duration", type=float, default=60.0, help="how long to measure [s]")
    parser.add_argument("--node", default="/kinetostatics")
    parser.add_argument("--rig", default="/rig")
    parser.add_argument("--json", help="file for the figures")
    arguments = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("sustained_rate", anonymous=True, disable_signals=True)
    figures = measure(arguments.duration, arguments.node, arguments.rig)
    figures = {"model": rospy.get_param(f"{arguments.node}/model"), "rate asked for [Hz]": rospy.get_param(f"{arguments.rig}/rate"), **figures}
    for key, value in figures.items():
        print(f"{key:>32}  {value:.2f}" if isinstance(value, float) else f"{key:>32}  {value}")
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(figures, file, indent=2)
            file.write("\n")


if __name__ == "__main__":
    main()
