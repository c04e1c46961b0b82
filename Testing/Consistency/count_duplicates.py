#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs of six and more equal code lines in the C++ of Modules and Testing: python3 count_duplicates.py [TREE]

Blank, comment, include and SPDX lines, lines of brackets alone, access specifiers and what opens or closes a namespace do
not count, and white space is taken as one blank. A run is as long as both places stay equal. What stands in three places
counts twice: the second and the third against the first.
"""

import re
import sys

import sourcetree

LENGTH = 6
IDLE = re.compile(r"[\s{}()\[\];,]*|#.*|using namespace.*|(inline )?namespace\b.*|(public|protected|private):")


def code_lines(text):
    """(line number, code) of the lines that count."""
    text = re.sub(r"/\*.*?\*/", lambda match: "\n" * match.group(0).count("\n"), text, flags=re.DOTALL)
    for number, line in enumerate(text.splitlines(), 1):
        line = " ".join(re.sub(r"//(?=([^\"]*\"[^\"]*\")*[^\"]*$).*", "", line).split())
        if not IDLE.fullmatch(line):
            yield number, line


def duplicates(root, length=LENGTH):
    """(number of lines, (path, first line), (path, first line)) of every run, longest first."""
    lines = []
    for path in sourcetree.files(root):
        if re.fullmatch(r"(Modules|Testing)/.*\.(h|cxx)", path):
            lines += [(path, number, code) for number, code in code_lines(sourcetree.text(root, path))]
            lines.append((path, 0, None))  # no run crosses files
    codes = [code for _, _, code in lines]
    places = {}
    for k in range(len(codes) - length + 1):
        window = tuple(codes[k:k + length])
        if None not in window:
            places.setdefault(window, []).append(k)
    runs, told = [], set()
    for first, *others in sorted(places.values()):
        for other in others:
            if other in told:
                continue
            count = 0
            while codes[first + count] is not None and codes[first + count] == codes[other + count] and first + count < other:
                told.add(other + count)
                count += 1
            if count >= length:
                runs.append((count, lines[first][:2], lines[other][:2]))
    return sorted(runs, key=lambda run: (-run[0], run[1:]))


def main():
    found = duplicates(sys.argv[1] if len(sys.argv) > 1 else sourcetree.ROOT)
    for count, first, other in found:
        print(f"{count:4} lines  {first[0]}:{first[1]}  {other[0]}:{other[1]}")
    print(f"{len(found)} runs, {sum(run[0] for run in found)} lines")


if __name__ == "__main__":
    main()
