#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every source file names its licence in its first line, or in the second after a line for the shell or XML."""

import posixpath
import sourcetree

LINE = "SPDX-License-Identifier: " + "BSD-3-Clause"
# Pages and data say it in LICENSE and Data/README.md; JSON has no comments; bundles have their licences beside them.
EXEMPT = (".md", ".json", ".vtp", ".vti", ".png", ".svg", ".pvsm", "LICENSE", "LICENSES.txt", ".bundle.js", ".gitignore",
          ".gitattributes")


def faults(root):
    for path in sourcetree.files(root):
        if posixpath.basename(path).endswith(EXEMPT):
            continue
        content = sourcetree.text(root, path)
        first = (content or "").splitlines()[:2]
        lines = first if first and first[0].startswith(("#!", "<?xml", "<!DOCTYPE")) else first[:1]
        if not any(LINE in line for line in lines):
            yield f"{path}: does not begin with '{LINE}'"


if __name__ == "__main__":
    sourcetree.main(faults)
