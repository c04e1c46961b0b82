#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Run the C++ example of several processes with 1 and 2 of them: the same bytes, and an even share of the work."""

import argparse
import re
import subprocess
import sys


def run(mpirun, ranks, program, mesh):
    """Items of each process, and the line of hashes."""
    command = [mpirun, "--oversubscribe", "-np", str(ranks), program, mesh, "--size", "24"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=100, check=False)
    if done.returncode or "ERROR" in done.stderr:
        sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
    items = [int(found) for found in re.findall(r"process \d+ of \d+: (\d+) items", done.stdout)]
    hashes = re.search(r"^vectors \d+ cones \d+ grid \d+$", done.stdout, re.M)
    if len(items) != ranks or not hashes:
        sys.exit(f"{' '.join(command)} said:\n{done.stdout}{done.stderr}")
    return items, hashes.group()


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("mpirun")
parser.add_argument("program")
parser.add_argument("mesh")
options = parser.parse_args()
_, alone = run(options.mpirun, 1, options.program, options.mesh)
shares, together = run(options.mpirun, 2, options.program, options.mesh)
print(f"items {shares}")
if together != alone:
    sys.exit(f"two processes give {together}, one gives {alone}")
if max(shares) * 2 > 1.2 * sum(shares):
    sys.exit(f"they share unevenly: {shares}")
