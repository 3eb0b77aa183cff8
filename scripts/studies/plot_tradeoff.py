#!/usr/bin/python3
"""Draws error against time of every cable model on every robot, and writes the tables of docs/trade.md.

    scripts/studies/plot_tradeoff.py               measures with the workspace's tradeoff (some minutes), then draws
    scripts/studies/plot_tradeoff.py trade.json    draws what tradeoff --json trade.json has measured

Pictures go to docs/images/trade_*.png, the tables between the marks in docs/trade.md. Needs python3-matplotlib.
"""

import argparse
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib import patheffects

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent
FIGURES = (
    ("forward_warm", "forward", "Forward kinetostatics, seeded 10 mm away: error of the pose"),
    ("inverse", "inverse", "Inverse kinetostatics: error of the pose that the lengths lead to"),
    ("estimate", "estimate", "Pose estimate from exact lengths and tensions: error of the pose"),
    ("cable_position", "cable", "One cable, from its forces to its end point: error of the end point"),
)
# model: name in the legend, marker, colour (that of its family: straight, catenary, bending)
RUNGS = {
    "straight": ("straight", "x", "tab:gray"),
    "straight_elastic": ("straight elastic", "s", "tab:gray"),
    "catenary_inextensible": ("catenary inextensible", "^", "tab:orange"),
    "catenary": ("catenary", "o", "tab:orange"),
    "catenary_corrected": ("catenary corrected", "P", "tab:red"),
    "bending_inextensible": ("bending inextensible", "v", "tab:blue"),
    "bending": ("bending", "D", "tab:blue"),
}
AUTO = ("auto", "*", "tab:green")
LEAST_ERROR = 1e-13  # [m], the reference's own
LABEL_DISTANCE = 0.9  # between AUTO's labels [decades]
TABLE_TOLERANCE = 1e-7
ACCURACY_NAMES = {1e-2: "1 cm", 1e-3: "1 mm", 1e-4: "0.1 mm", 1e-5: "10 um", 1e-6: "1 um"}


def measured(path):
    """The contents of the JSON file; without one, of a run of the program."""
    if path:
        return json.loads(pathlib.Path(path).read_text())
    workspace = pathlib.Path(os.environ.get("CDPR_WORKSPACE", REPOSITORY / ".ws"))
    program = workspace / "devel/lib/cdpr_kinetostatics/tradeoff"
    if not program.exists():
        sys.exit(f"{program} is not built: scripts/test.sh or scripts/demo.sh build it")
    with tempfile.TemporaryDirectory() as directory:
        file = pathlib.Path(directory) / "trade.json"
        subprocess.run([program, "--json", file], check=True)
        return json.loads(file.read_text())


def points_of(robot, problem, model):
    """(time, error, accuracy) of the rows that solved every pose."""
    rows = [r for r in robot["rows"] if r["problem"] == problem and r["model"] == model]
    rows = [r for r in rows if r["solved"] == r["trials"] and r["position_error"] is not None]
    return [(r["median_time"], max(r["position_error"], LEAST_ERROR), r["accuracy"]) for r in rows]


def front_of(points):
    """The points that no other one beats in both time and error, by time."""
    front = []
    for time, error, _ in sorted(points):
        if not front or error < front[-1][1]:
            front.append((time, error))
    return front


def automatic_groups(robot, problem):
    """AUTO's points and their accuracies; those that lead to about the same error share the fastest point."""
    groups = []
    for time, error, accuracy in points_of(robot, problem, "auto"):
        if groups and error > groups[-1][0][1] / 2.5:
            (fastest, same), accuracies = groups[-1]
            groups[-1] = ((min(time, fastest), same), accuracies + [accuracy])
        else:
            groups.append(((time, error), [accuracy]))
    return groups


def draw_panel(axes, robot, problem):
    every = [p for model in RUNGS for p in points_of(robot, problem, model)]
    front = front_of(every)
    if front:
        times, errors = zip(*front)
        axes.step(times, errors, where="post", color="black", linewidth=0.8, alpha=0.5, zorder=1)
    for model, (_, marker, color) in RUNGS.items():
        points = points_of(robot, problem, model)
        if points:
            fill = "white" if model.endswith("_inextensible") else color
            axes.plot(*list(zip(*points))[:2], marker=marker, markersize=6, color=color, markerfacecolor=fill,
                      linewidth=0.8, zorder=2)
    label_height = math.inf
    for (time, error), accuracies in automatic_groups(robot, problem):
        axes.plot(time, error, marker=AUTO[1], markersize=11, color=AUTO[2], markeredgecolor="black",
                  markeredgewidth=0.5, linestyle="none", zorder=3)
        ends = (accuracies[0], accuracies[-1])
        label = " .. ".join(dict.fromkeys(f"{a:.0e}".replace("e-0", "e-") for a in ends))
        label_height = min(math.log10(error) + 0.2, label_height - LABEL_DISTANCE)
        axes.text(1.3 * time, 10**label_height, label, va="center", fontsize=8, color=AUTO[2], zorder=4,
                  path_effects=[patheffects.withStroke(linewidth=2, foreground="white")])
    layers = ", $\\kappa L$ {:.0f} to {:.0f}".format(*robot["kappa_length"]) if robot["kappa_length"] else ""
    axes.set_title(f"{robot['name']}\n{robot['cables']} cables{layers}", fontsize=10)
    axes.set(xscale="log", yscale="log")
    axes.grid(True, which="major", linewidth=0.3)
    axes.tick_params(labelsize=8)


def draw(document, problem, title, path):
    robots = document["robots"]
    columns = 4 if len(robots) > 3 else len(robots) + 1
    rows = -(-(len(robots) + 1) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(2.6 * columns, 2.7 * rows + 0.5), constrained_layout=True,
                                sharex=True, sharey=True, squeeze=False)
    panels = grid.flatten()
    for axes, robot in zip(panels, robots):
        draw_panel(axes, robot, problem)
    for k in range(len(robots), len(panels)):
        panels[k].axis("off")
        if k >= columns:
            panels[k - columns].tick_params(labelbottom=True)
    used = {row["model"] for robot in robots for row in robot["rows"]}
    handles = [plt.Line2D([], [], marker=marker, color=color, linewidth=0.8, label=name,
                          markerfacecolor="white" if name.endswith(" inextensible") else color)
               for model, (name, marker, color) in RUNGS.items() if model in used]
    if "auto" in used:
        handles.append(plt.Line2D([], [], marker=AUTO[1], markersize=10, color=AUTO[2], linestyle="none",
                                  label="auto, at its accuracy [m]"))
    handles.append(plt.Line2D([], [], color="black", linewidth=0.8, alpha=0.5, label="best error for the time"))
    panels[len(robots)].legend(handles=handles, loc="center", fontsize=9, frameon=False)
    figure.supxlabel("median time [s]", fontsize=10)
    figure.supylabel("largest error [m]", fontsize=10)
    figure.suptitle(title, fontsize=11)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def length_text(metres):
    if metres is None:
        return "-"
    if metres < 1e-12:
        return "< 1 pm"
    for factor, unit in ((1, "m"), (1e-3, "mm"), (1e-6, "um"), (1e-9, "nm"), (1e-12, "pm")):
        if metres >= 0.995 * factor:
            return f"{metres / factor:.2g} {unit}" if metres < 99.5 * factor else f"{metres / factor:.0f} {unit}"
    return "< 1 pm"


def time_text(seconds):
    value, unit = (seconds * 1e6, "us") if seconds < 0.9995e-3 else (seconds * 1e3, "ms")
    return f"{value:.2g} {unit}" if value < 99.5 else f"{value:.0f} {unit}"


def recommendation_table(document):
    lines = ["| robot | error up to | model | time | neglected |", "|---" * 5 + "|"]
    for robot in document["robots"]:
        same = []
        choices = robot["recommendations"]
        for k, choice in enumerate(choices):
            same.append(ACCURACY_NAMES[choice["accuracy"]])
            key = (choice["model"], choice["tolerance"])
            if k + 1 < len(choices) and key == (choices[k + 1]["model"], choices[k + 1]["tolerance"]):
                continue
            cells = ["none", "", ""]
            if choice["model"]:
                cells = [choice["model"], time_text(choice["time"]), length_text(choice["error"])]
            lines.append(f"| `{robot['name']}` | {', '.join(same)} | " + " | ".join(cells) + " |")
            same = []
    return lines


def example(document):
    """The recommendation for CoGiRo, or else the first robot, as the program prints it last."""
    robot = next((r for r in document["robots"] if r["name"] == "cogiro"), document["robots"][0])
    choice = next(r for r in robot["recommendations"] if r["accuracy"] == 1e-4)
    return ["```"] + textwrap.wrap(choice["sentence"] + ".", 116) + ["```"]


def row_of(robot, problem, model, tolerance):
    rows = [r for r in robot["rows"] if (r["problem"], r["model"]) == (problem, model)]
    rows = [r for r in rows if r["accuracy"] is None and r["solved"] == r["trials"]]
    return min(rows, key=lambda r: abs(r["tolerance"] / tolerance - 1), default=None)


def pair_of(row):
    """Time and error of a row that solved every pose."""
    if row is None or row["solved"] < row["trials"]:
        return ["-", "-"]
    return [time_text(row["median_time"]), length_text(row["position_error"])]


def rung_table(document):
    lines = ["| robot | model | forward | p99 | error | tension | inverse | error | estimate | error |",
             "|---" * 10 + "|"]
    for robot in document["robots"]:
        for model in RUNGS:
            forward, inverse, estimate = (row_of(robot, problem, model, TABLE_TOLERANCE)
                                          for problem in ("forward_warm", "inverse", "estimate"))
            if not any((forward, inverse, estimate)):
                continue
            first = pair_of(forward)
            extra = [time_text(forward["p99_time"]), f"{forward['tension_error']:.1e} N"] if forward else ["-", "-"]
            cells = [first[0], extra[0], first[1], extra[1]] + pair_of(inverse) + pair_of(estimate)
            lines.append(f"| `{robot['name']}` | {model} | " + " | ".join(cells) + " |")
    return lines


def work_table(document):
    lines = ["| robot | tolerance | forward | error | iterations | steps | evaluations |", "|---" * 7 + "|"]
    for robot in document["robots"]:
        for row in robot["rows"]:
            if (row["model"], row["problem"]) == ("bending", "forward_warm") and row["solved"]:
                cells = [time_text(row["median_time"]), length_text(row["position_error"]), f"{row['iterations']:.0f}",
                         f"{row['integrator_steps']:.0f}", f"{row['evaluations']:.0f}"]
                tolerance = f"{row['tolerance']:.0e}".replace("e-0", "e-")
                lines.append(f"| `{robot['name']}` | {tolerance} | " + " | ".join(cells) + " |")
    return lines


def automatic_table(document):
    lines = ["| robot | accuracy | finest | forward | error | estimated | inverse | error | estimated |",
             "|---" * 9 + "|"]
    for robot in document["robots"]:
        rows = {(r["problem"], r["accuracy"]): r for r in robot["rows"] if r["model"] == "auto"}
        for accuracy in sorted({accuracy for _, accuracy in rows}, reverse=True):
            forward, inverse = rows["forward_warm", accuracy], rows["inverse", accuracy]
            cells = [forward["finest_model"] or "-"]
            for row in (forward, inverse):
                cells += pair_of(row) + [length_text(row["estimated_error"])]
            lines.append(f"| `{robot['name']}` | {length_text(accuracy)} | " + " | ".join(cells) + " |")
    return lines


def write_tables(document, path):
    machine = document["machine"]
    origin = (f"{machine['cores']} x {machine['cpu']}, {machine['compiler']}, {machine['build_type']}, "
              f"commit {machine['commit']}.")
    text = path.read_text()
    for mark, lines in (("origin", [origin]), ("example", example(document)),
                        ("recommendations", recommendation_table(document)),
                        ("rungs", rung_table(document)), ("automatic", automatic_table(document)),
                        ("work", work_table(document))):
        block = f"<!-- {mark} -->\n" + "\n".join(lines) + "\n<!-- end -->"
        text, count = re.subn(rf"<!-- {mark} -->.*?<!-- end -->", lambda _: block, text, flags=re.DOTALL)
        if count != 1:
            sys.exit(f"{path} has {count} places for '{mark}', expected 1")
    path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("json", nargs="?", help="what tradeoff --json has written; measured anew if not given")
    parser.add_argument("--images", type=pathlib.Path, help="only pictures, into this folder")
    arguments = parser.parse_args()
    document = measured(arguments.json)
    images = arguments.images or REPOSITORY / "docs/images"
    images.mkdir(parents=True, exist_ok=True)
    for problem, name, title in FIGURES:
        draw(document, problem, title, images / f"trade_{name}.png")
    if not arguments.images:
        write_tables(document, REPOSITORY / "docs/trade.md")


if __name__ == "__main__":
    main()
