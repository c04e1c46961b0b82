#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A file of more than 600 lines says in its head why it is one file, and code does not stand twice."""

import count_duplicates
import house_numbers
import sourcetree

# Runs of six and more equal lines that are there for a reason or await one; the number may fall, not rise.
RUNS = 6


def faults(root):
    for path, count, said in house_numbers.long_files(root):
        if not said:
            yield f"{path}: {count} lines, and no '{house_numbers.REASON}...' in its head"
    runs = count_duplicates.duplicates(root)
    if len(runs) > RUNS:
        for count, first, other in runs:
            yield f"{other[0]}:{other[1]}: {count} lines stand in {first[0]}:{first[1]} too; {len(runs)} runs, at most {RUNS}"


if __name__ == "__main__":
    sourcetree.main(faults)
