#!/usr/bin/env python3
"""Prints rviz/kinetostatics.rviz with the camera and the axes as large as a robot wants them."""

import math
import pathlib
import re
import sys

import yaml


def main():
    robot = yaml.safe_load(open(sys.argv[1], encoding="utf-8"))
    config = (pathlib.Path(__file__).resolve().parent.parent / "rviz" / "kinetostatics.rviz").read_text(encoding="utf-8")
    anchors = [[float(c) for c in point["frame"]] for point in robot["points"]]
    corners = list(anchors)
    corners.append([float(c) for c in robot["platform"]["position"]["xyz"]])
    low, high = [min(c) for c in zip(*corners)], [max(c) for c in zip(*corners)]
    low[2] = min(low[2], 0.0)  # posts reach down to the floor
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    high[2] += 0.2 * max(math.dist(a, b) for a in anchors for b in anchors)  # where the legend is
    size = max(math.dist(low, high), 2.0 * (high[2] - low[2]))  # the window is wider than high
    scale = size / 20.9  # the file is drawn for a robot of this size
    values = {"Distance": 29 * scale, "Cell Size": 10 ** round(math.log10(scale)), "Marker Scale": 3 * scale}
    for key, value in values.items():
        config = re.sub(rf"(?m)^( *{key}: )[\d.]+", rf"\g<1>{value:.4g}", config)
    for key in ("Axes Length", "Axes Radius"):
        config = re.sub(rf"({key}: )([\d.]+)", lambda m: f"{m[1]}{float(m[2]) * scale:.4g}", config)
    for axis, coordinate in zip("XYZ", middle):
        config = re.sub(rf"(        {axis}: )[-\d.]+", rf"\g<1>{coordinate:.4g}", config)
    sys.stdout.write(config)


if __name__ == "__main__":
    main()
