#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Core knows threads and the id type of VTK, and neither pipeline nor data sets."""

import posixpath
import re
import sourcetree

ALLOWED = {"vtkSMPTools.h", "vtkType.h"}


def faults(root):
    for path in sourcetree.files(root):
        if re.fullmatch(r"Modules/Core/(?!Testing/).*\.(h|cxx)", path):
            for line, name in sourcetree.includes(root, path):
                if posixpath.basename(name).startswith("vtk") and name not in ALLOWED:
                    yield f"{path}:{line}: Core may not include {name}"


if __name__ == "__main__":
    sourcetree.main(faults)
