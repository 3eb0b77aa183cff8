#!/usr/bin/env python3
"""Counts the test cases below a directory of JUnit files: names those that failed, then prints PASSED FAILED SKIPPED.

catkin_test_results gives the verdict but counts every gtest case twice, as a case and in its suite."""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def outcome(case):
    if case.find("failure") is not None or case.find("error") is not None:
        return "failed"
    if case.find("skipped") is not None or case.get("status") == "notrun":
        return "skipped"
    return "passed"


def main():
    counts = {"passed": 0, "failed": 0, "skipped": 0}
    for path in sorted(pathlib.Path(sys.argv[1]).rglob("*.xml")):
        try:
            cases = list(ElementTree.parse(path).iter("testcase"))
        except ElementTree.ParseError as problem:
            print(f"FAILED: {path.name} is broken off: {problem}")
            counts["failed"] += 1
            continue
        # A rostest's own file says that its launch worked; its tests are in the rosunit file.
        launch = path.name.startswith("rostest-")
        for case in cases:
            result = outcome(case)
            if launch and result == "passed":
                continue
            counts[result] += 1
            if result == "failed":
                print(f"FAILED: {path.stem} {case.get('classname')}.{case.get('name')}")
    print(counts["passed"], counts["failed"], counts["skipped"])


if __name__ == "__main__":
    main()
