#!/usr/bin/python3
"""Draws whether AUTO keeps to the accuracy asked for, and writes the table of docs/models.md.

    scripts/studies/plot_auto.py                   runs the workspace's auto_honesty (a minute or two), then draws
    scripts/studies/plot_auto.py --scenes 1500     the same with fewer answers
    scripts/studies/plot_auto.py auto.csv          draws what auto_honesty --csv auto.csv has measured

The picture is docs/images/auto_honesty.png, the table goes between the marks in docs/models.md. Needs
python3-matplotlib.
"""

import argparse
import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent
RUNGS = {  # from coarse to fine: colour
    "straight_elastic": "tab:green",
    "catenary": "tab:orange",
    "catenary_corrected": "tab:red",
    "bending": "tab:blue",
}
LEAST_ERROR = 1e-13  # [m], about the reference's own
FACTOR = 5.0


def run(file, scenes):
    """Runs the program of the workspace."""
    workspace = pathlib.Path(os.environ.get("CDPR_WORKSPACE", REPOSITORY / ".ws"))
    program = workspace / "devel/lib/cdpr_kinetostatics/auto_honesty"
    if not program.exists():
        sys.exit(f"{program} is not built: build with -DCDPR_BUILD_BENCHMARKS=ON (scripts/benchmarks.sh does)")
    subprocess.run([program, "--csv", file] + (["--scenes", str(scenes)] if scenes else []), check=True)


class Answer:
    def __init__(self, row):
        self.solved = row["truth"] != ""
        self.problem = row["problem"]
        self.accuracy = float(row["accuracy"])
        if self.solved:
            self.truth = float(row["truth"])
            self.estimate = float(row["estimate"])
            used = [rung for rung in RUNGS if int(row[rung])]
            self.coarsest, self.finest = used[0], used[-1]

    def has_estimate(self):
        return self.solved and self.coarsest != "bending"

    def estimated_within(self, factor):
        return self.truth < factor * self.estimate and self.estimate < factor * self.truth


def read(path):
    with open(path, newline="") as file:
        return [Answer(row) for row in csv.DictReader(file)]


def dots(axes, answers, x):
    for rung, color in reversed(list(RUNGS.items())):  # the rare ones on top
        here = [a for a in answers if a.finest == rung]
        axes.scatter([x(a) for a in here], [max(a.truth, LEAST_ERROR) for a in here], s=6, color=color, linewidths=0,
                     alpha=0.7, label=f"{rung} ({len(here)})")
    axes.set(xscale="log", yscale="log")
    axes.grid(alpha=0.3)


def draw(answers, file):
    solved = [a for a in answers if a.solved]
    figure, (asked, estimated) = plt.subplots(1, 2, figsize=(11, 4.8), constrained_layout=True)
    dots(asked, solved, lambda a: a.accuracy)
    ends = (1e-6, 1e-2)
    asked.plot(ends, ends, color="black", linewidth=0.9)
    asked.set(xlabel="accuracy asked for [m]", ylabel="true error at the platform [m]",
              title="Below the line: as accurate as asked for", xlim=(8e-7, 1.25e-2))
    asked.legend(title="finest model of a cable", fontsize=8, title_fontsize=8, markerscale=2, loc="upper left")

    judged = [a for a in solved if a.has_estimate()]
    dots(estimated, judged, lambda a: max(a.estimate, LEAST_ERROR))
    ends = (0.5 * min(max(a.estimate, LEAST_ERROR) for a in judged), 2.0 * max(a.estimate for a in judged))
    for factor, style in ((1.0, "-"), (FACTOR, "--"), (1.0 / FACTOR, "--")):
        estimated.plot(ends, [factor * e for e in ends], color="black", linewidth=0.9, linestyle=style)
    estimated.set(xlabel="estimated error [m]", ylabel="true error at the platform [m]",
                  title=f"Between the dashed lines: within a factor of {FACTOR:.0f}")
    figure.savefig(file, dpi=100)


def percent(part, whole):
    return f"{100 * len(part) / len(whole):.2f} %" if whole else "-"


def table_row(name, answers):
    solved = [a for a in answers if a.solved]
    judged = [a for a in solved if a.has_estimate()]
    cells = [
        name,
        len(answers),
        len(answers) - len(solved),
        percent([a for a in solved if a.truth <= a.accuracy], solved),
        f"{max((a.truth / a.accuracy for a in solved), default=0.0):.2g}",
        len(judged),
        percent([a for a in judged if a.estimated_within(2.0)], judged),
        percent([a for a in judged if a.estimated_within(FACTOR)], judged),
    ]
    return "| " + " | ".join(str(c) for c in cells) + " |"


def table(answers):
    lines = [
        "| answers | number | refused | within the accuracy | largest error / accuracy | estimated "
        "| estimate / truth within 2 | within 5 |",
        "|---|---|---|---|---|---|---|---|",
        table_row("all", answers),
    ]
    for problem in ("forward", "inverse"):
        lines.append(table_row(problem, [a for a in answers if a.problem == problem]))
    for rung in RUNGS:
        lines.append(table_row(f"finest model `{rung}`", [a for a in answers if a.solved and a.finest == rung]))
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("csv", nargs="?", help="what auto_honesty has measured; without it, the program is run")
    parser.add_argument("--scenes", type=int, help="answers to ask the program for; its default otherwise")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as directory:
        file = arguments.csv or pathlib.Path(directory) / "auto.csv"
        if not arguments.csv:
            run(file, arguments.scenes)
        answers = read(file)
    draw(answers, REPOSITORY / "docs/images/auto_honesty.png")
    document = REPOSITORY / "docs/models.md"
    document.write_text(re.sub(r"(?s)(<!-- honesty -->\n).*?(<!-- end -->)", rf"\g<1>{table(answers)}\n\g<2>",
                               document.read_text()))


if __name__ == "__main__":
    main()
