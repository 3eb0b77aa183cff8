#!/usr/bin/env python3
"""Records cable_states into a bag, or plays a bag to the node twice with ~reset between and compares what comes out."""

import argparse
import io
import sys
import threading
import time

import rosbag
import rospy
from sensor_msgs.msg import JointState
from std_srvs.srv import Trigger
from cdpr_kinetostatics.msg import KinetostaticState

LIMIT = 120.0  # how long to wait for anything [s]


class Collector:
    """What arrives on a topic."""

    def __init__(self, topic, kind):
        self.lock = threading.Condition()
        self.messages = []
        self.subscriber = rospy.Subscriber(topic, kind, self.add, queue_size=100000)

    def add(self, message):
        with self.lock:
            self.messages.append(message)
            self.lock.notify_all()

    def wait(self, count):
        with self.lock:
            if not self.lock.wait_for(lambda: len(self.messages) >= count, timeout=LIMIT):
                sys.exit(f"FAILED: {len(self.messages)} of {count} messages within {LIMIT:.0f} s")
            return self.messages[:count]


def wait_for_connection(topic):
    """rospy tells nobody when a subscriber connects: asks until it has, or the limit passes."""
    deadline = time.monotonic() + LIMIT
    while topic.get_num_connections() == 0:
        if time.monotonic() > deadline:
            sys.exit(f"FAILED: {topic.resolved_name} has no other end within {LIMIT:.0f} s")
        time.sleep(0.01)


def essence(state):
    """Pose, covariance, load and cables to the last bit; not the times that solves took."""
    state.header.seq = 0
    state.report.solve_time = 0.0
    stream = io.BytesIO()
    state.serialize(stream)
    return stream.getvalue()


def record(path, count):
    collector = Collector("cable_states", JointState)
    messages = collector.wait(count)
    with rosbag.Bag(path, "w") as bag:
        for message in messages:
            bag.write("cable_states", message, message.header.stamp)
    print(f"recorded {count} messages in {path}")


def play(publisher, messages):
    collector = Collector("kinetostatic_state", KinetostaticState)
    wait_for_connection(collector.subscriber)
    wait_for_connection(publisher)
    for message in messages:
        publisher.publish(message)
    states = collector.wait(len(messages))
    collector.subscriber.unregister()
    return states


def compare(path, node):
    with rosbag.Bag(path) as bag:
        messages = [message for _, message, _ in bag.read_messages(["cable_states", "/cable_states"])]
    if not messages:
        sys.exit(f"FAILED: no cable_states in {path}")
    rospy.wait_for_service(f"{node}/reset", timeout=LIMIT)
    reset = rospy.ServiceProxy(f"{node}/reset", Trigger)
    publisher = rospy.Publisher("cable_states", JointState, queue_size=len(messages))
    runs = []
    for _ in range(2):
        reset()
        runs.append([essence(state) for state in play(publisher, messages)])
    different = sum(first != second for first, second in zip(*runs))
    print(f"{len(messages)} messages played twice: {different} estimates differ")
    return different == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bag")
    parser.add_argument("--record", type=int, metavar="COUNT", help="record that many messages instead of playing")
    parser.add_argument("--node", default="/kinetostatics", help="name of the node")
    arguments = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("replay_client", anonymous=True, disable_signals=True)
    if arguments.record:
        record(arguments.bag, arguments.record)
    elif not compare(arguments.bag, arguments.node):
        sys.exit("FAILED: the same measurements gave different estimates")


if __name__ == "__main__":
    main()
