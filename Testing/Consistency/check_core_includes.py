#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Core knows threads and the id type of VTK, and neither pipeline nor data sets; nor do headers that its tests share."""

import posixpath
import re
import sourcetree

ALLOWED = {"vtkSMPTools.h", "vtkType.h", "vtkVersionMacros.h"}
SUPPORT = "Testing/Support/"


def vtk_includes(root, path):
    """(line, name) of what a file may not include in Core; of Testing/Support also what stands behind an include."""
    for line, name in sourcetree.includes(root, path):
        if posixpath.basename(name).startswith("vtk") and name not in ALLOWED:
            yield line, name


def with_data_sets(root):
    """Names of the headers of Testing/Support that need data sets, themselves or through another."""
    paths = [path for path in sourcetree.files(root) if re.fullmatch(SUPPORT + r"\w+\.h", path)]
    headers = {posixpath.basename(path): {name for _, name in sourcetree.includes(root, path)} for path in paths}
    found = {posixpath.basename(path) for path in paths if any(vtk_includes(root, path))}
    while True:
        more = {name for name, included in headers.items() if included & found} - found
        if not more:
            return found
        found |= more


def faults(root):
    data_sets = with_data_sets(root)
    for path in sourcetree.files(root):
        if re.fullmatch(r"Modules/Core/(?!Testing/).*\.(h|cxx)", path):
            for line, name in vtk_includes(root, path):
                yield f"{path}:{line}: Core may not include {name}"
        if re.fullmatch(r"Modules/Core/Testing/.*\.(h|cxx)", path):
            for line, name in sourcetree.includes(root, path):
                if name in data_sets:
                    yield f"{path}:{line}: a test of Core may not include {name}, which needs data sets of VTK"


if __name__ == "__main__":
    sourcetree.main(faults)
