#!/usr/bin/python3
"""Prints one table of what the benchmarks measured, beside the targets, from their CSV files (docs/performance.md)."""
import csv
import sys


def main():
    rows = []
    for path in sys.argv[1:]:
        with open(path, newline="") as file:
            rows += csv.DictReader(file)
    rows.sort(key=lambda row: int(row["item"]))
    print("| item | quantity | measured | target | |")
    print("|---|---|---|---|---|")
    for row in rows:
        measured = float(row["measured"])
        target = f"{row['relation']} {float(row['target']):g}" if row["relation"] else ""
        verdict = ""
        if row["relation"]:
            met = measured <= float(row["target"]) if row["relation"] == "<=" else measured >= float(row["target"])
            verdict = "met" if met else "missed"
        print(f"| {row['item']} | {row['quantity']} | {measured:.3g} {row['unit']} | {target} | {verdict} |")


if __name__ == "__main__":
    main()
