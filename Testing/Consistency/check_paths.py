#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""No file names a folder of somebody's machine."""

import re
import sourcetree

# Split, so that this file does not match itself.
PRIVATE = re.compile(r"(?<![\w.})\]*-])/(" + "|".join(("wo" "rk", "ro" "ot", "ho" "me", "t" "mp")) + r")(?![\w-])")


def faults(root):
    for path in sourcetree.files(root):
        for number, line in enumerate((sourcetree.text(root, path) or "").splitlines(), 1):
            if PRIVATE.search(line):
                yield f"{path}:{number}: names a folder of one machine: {line.strip()[:100]}"


if __name__ == "__main__":
    sourcetree.main(faults)
