#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Installed headers include no third party, and no header of ours that is not installed."""

import os
import re
import sourcetree

THIRD_PARTIES = re.compile(r"embree|rtcore|^pcl/|flann|OpenMesh|Eigen|erfa", re.IGNORECASE)


def faults(root):
    installed = set(sourcetree.installed_headers(root))
    names = {path.split("/")[-1] for path in installed}
    ours = {path.split("/")[-1] for path in sourcetree.files(root) if re.fullmatch(r"Modules/\w+/(\w+/)?\w+\.h", path)}
    for path in sorted(installed):
        if not os.path.exists(os.path.join(root, path)):
            yield f"{path}: listed in CMakeLists.txt and not there"
            continue
        for line, name in sourcetree.includes(root, path):
            if THIRD_PARTIES.search(name):
                yield f"{path}:{line}: an installed header may not include {name}"
            if name in ours and name not in names:
                yield f"{path}:{line}: includes {name}, which is not installed"


if __name__ == "__main__":
    sourcetree.main(faults)
