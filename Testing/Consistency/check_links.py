#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every relative link and picture of a page leads to a file."""

import os
import re
import sourcetree


def faults(root):
    for path in sourcetree.files(root):
        if not path.endswith(".md"):
            continue
        for number, line in enumerate(sourcetree.text(root, path).splitlines(), 1):
            for target in re.findall(r"\]\(([^)\s]+)\)", line):
                target = target.split("#")[0]
                if target and "://" not in target:
                    if not os.path.exists(os.path.join(root, os.path.dirname(path), target)):
                        yield f"{path}:{number}: leads to {target}, which is not there"


if __name__ == "__main__":
    sourcetree.main(faults)
