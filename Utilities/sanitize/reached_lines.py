#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Print how many lines of each room and module the tests have reached, from the counts that gcov left in a build:
reached_lines.py BUILD. The lines that none reached go to BUILD/unreached.txt, a line a stretch: file, first line, last line."""

import collections
import json
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def room_of(path):
    """Modules/Core/Mesh/scMesh.cxx is of Core/Mesh, Modules/Filters/vtkSunHours.cxx of Filters."""
    parts = path.split("/")
    return "/".join(parts[1:3]) if len(parts) > 3 else parts[1]


def counted_files(build):
    """Path of each source below Modules, and its lines with how often they ran."""
    report = os.path.join(build, "lines.json")
    subprocess.run(["gcovr", "--root", ROOT, "--object-directory", build, "--filter", os.path.join(ROOT, "Modules/"),
                    "--exclude", ".*/Testing/.*", "--gcov-ignore-parse-errors", "-j", "2", "--json", report,
                    os.path.join(build, "Modules")], check=True, stdout=subprocess.DEVNULL, cwd=ROOT)
    with open(report, encoding="utf-8") as file:
        return [(each["file"], [line for line in each["lines"] if not line.get("gcovr/noncode")])
                for each in json.load(file)["files"]]


def stretches(lines):
    """Lines that never ran, neighbours together: pairs of first and last."""
    found = []
    open_stretch = False
    for line in sorted(lines, key=lambda line: line["line_number"]):
        if line["count"] > 0:
            open_stretch = False
        elif open_stretch:
            found[-1][1] = line["line_number"]
        else:
            found.append([line["line_number"]] * 2)
            open_stretch = True
    return found


def main():
    build = os.path.abspath(sys.argv[1])
    rooms = collections.defaultdict(lambda: [0, 0])
    with open(os.path.join(build, "unreached.txt"), "w", encoding="utf-8") as out:
        for path, lines in sorted(counted_files(build)):
            for room in (room_of(path), "all"):
                rooms[room][0] += len(lines)
                rooms[room][1] += sum(line["count"] > 0 for line in lines)
            out.writelines(f"{path} {first} {last}\n" for first, last in stretches(lines))
    print(f"{'room':<22}{'lines':>8}{'missed':>8}{'reached':>10}")
    for room, (count, reached) in sorted(rooms.items(), key=lambda item: (item[0] == "all", item[0])):
        print(f"{room:<22}{count:>8}{count - reached:>8}{100 * reached / max(1, count):>8.1f} %")
    print(f"Lines that no test reached: {os.path.relpath(build, ROOT)}/unreached.txt")


if __name__ == "__main__":
    main()
