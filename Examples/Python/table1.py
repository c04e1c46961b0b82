#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Seconds, error and occlusion rays of each mode for chair and tree (the paper's table 1), as Markdown and JSON.

The work is done by the benchmark program scattering-table: its truth is the reference implementation of
Testing/Reference, which shares no light rule with any mode. The reference is kept in the output folder from one run to
the next.
"""

import argparse
import json
import os
import re
import subprocess

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "bin", "scattering-table")
ROW = re.compile(r"(\w+) +(.+?) +(\d+) +([\d.]+) +([\d.]+) +(-?[\d.]+) +(-?[\d.]+) +(\d+)$")
COLUMNS = ("scene", "mode", "cones", "seconds", "speed", "error", "bias", "rays")


def read(line):
    """A row of the program's table by column, or None."""
    match = ROW.match(line)
    if not match:
        return None
    row = dict(zip(COLUMNS, match.groups()))
    for column in ("cones", "rays"):
        row[column] = int(row[column])
    for column in ("seconds", "speed", "error", "bias"):
        row[column] = float(row[column])
    return row


def markdown(rows):
    yield "| model | mode | cones | seconds | speed | error | bias | occlusion rays |"
    yield "|---|---|---:|---:|---:|---:|---:|---:|"
    for row in rows:
        yield (f"| {row['scene']} | {row['mode']} | {row['cones'] or '-'} | {row['seconds']:.2f} | "
               f"{row['speed']:.2f} | {row['error']:.2%} | {row['bias']:+.2%} | {row['rays']:,} |")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--output", default="output", help="folder to write to (default: output)")
    options.add_argument("--size", type=int, default=256, help="width and height of the images, pixels (default: 256)")
    options.add_argument("--vectors", type=int, default=5800, help="number of shadow vectors (default: 5800)")
    options.add_argument("--pixels", type=int, default=2048,
                         help="pixels held against the reference (default: 2048)")
    options.add_argument("--samples", type=int, default=65536,
                         help="samples of the reference a pixel (default: 65536)")
    options.add_argument("--light-samples", type=int, default=16, help="light points a march sample (default: 16)")
    options.add_argument("--threads", type=int, default=1, help="threads for the images (default: 1)")
    options.add_argument("--repeats", type=int, default=3, help="the best time of so many runs (default: 3)")
    options.add_argument("--program", default=PROGRAM, help="scattering-table (default: that of the folder build)")
    arguments = options.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    if not os.access(arguments.program, os.X_OK):
        raise SystemExit(f"There is no program {arguments.program}: build the target scattering-table (it needs "
                         "libcli11-dev), or name it with --program")

    command = [arguments.program, "--cache", arguments.output]
    for name in ("size", "vectors", "pixels", "samples", "light_samples", "threads", "repeats"):
        command += ["--" + name.replace("_", "-"), str(getattr(arguments, name))]
    rows, notes = [], []
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as program:
        for line in program.stdout:
            print(line, end="", flush=True)
            row = read(line.strip())
            if row:
                rows.append(row)
            elif line.startswith("#"):
                notes.append(line[1:].strip())
    if program.returncode != 0 or not rows:
        raise SystemExit("scattering-table failed")

    table = "\n".join(markdown(rows))
    print("\n" + table)
    used = {key: value for key, value in vars(arguments).items() if key not in ("output", "program")}
    contents = {"table1.md": table + "\n\n" + "\n".join(notes),
                "table1.json": json.dumps({"options": used, "notes": notes, "rows": rows}, indent=2)}
    for name, content in contents.items():
        with open(os.path.join(arguments.output, name), "w", encoding="utf-8") as file:
            file.write(content + "\n")
        print(f"wrote {os.path.join(arguments.output, name)}")


if __name__ == "__main__":
    main()
