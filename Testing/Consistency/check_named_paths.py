#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Files and folders that the pages for contributors name in backticks are there."""

import os
import re

import sourcetree

PAGES = re.compile(r"CONTRIBUTING\.md|(Modules|Testing)/.*README\.md")
NAMED = re.compile(r"`((?:Modules|Testing|Documentation|Examples|Utilities|Data)/[\w./-]*)`")


def faults(root):
    for path in sourcetree.files(root):
        if not PAGES.fullmatch(path):
            continue
        for number, line in enumerate(sourcetree.text(root, path).splitlines(), 1):
            for name in NAMED.findall(line):
                # The page on adding a filter speaks of one that nobody has made.
                if "NewThing" not in name and not os.path.exists(os.path.join(root, name)):
                    yield f"{path}:{number}: names {name}, which is not there"


if __name__ == "__main__":
    sourcetree.main(faults)
