#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every method that a class declares itself and a user calls has help text in Python: Set..., Get..., ...On, ...Off.

VTK's wrapper gives the comment of a ///@{ group to its first method alone. The others take a comment of their own: after
the method (///<), or on the line before it (vtkGetVector3Macro, and the On of vtkBooleanMacro).
"""

import importlib
import re

import sourcetree


def has_text(documentation):
    """Whether there is more than signatures, which stand in paragraphs of their own."""
    return any(p.strip() and "C++: " not in p for p in re.split(r"\n\s*\n", documentation or ""))


def faults(root):
    try:
        package = importlib.import_module("shadowcones")
    except ImportError:
        yield "the Python package 'shadowcones' is not on PYTHONPATH"
        return
    for _, name in [*sourcetree.classes(root), *sourcetree.classes(root, "helpers")]:
        for method, value in sorted(vars(getattr(package, name, object)).items()):
            if re.fullmatch(r"(Set|Get|Add|Remove)[A-Z]\w*|[A-Z]\w*(On|Off)", method) and not has_text(value.__doc__):
                yield f"{name}: {method} has no help text in Python"


if __name__ == "__main__":
    sourcetree.main(faults)
