#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every class has a page, a test, a Python example, an entry in the ParaView plugin, its page's list, and the changelog.

A helper, which has no ports, has a test, a line of the changelog, and a page that speaks of it.
"""

import os
import re
import sourcetree


def faults(root):
    paths = list(sourcetree.files(root))

    def mentioned(pattern, word):
        word = re.compile(word)
        return any(word.search(sourcetree.text(root, p) or "") for p in paths if re.fullmatch(pattern, p))

    menus = sourcetree.text(root, "Documentation/3-paraview.md") if "Documentation/3-paraview.md" in paths else ""
    for module, name in sourcetree.classes(root):
        if not os.path.exists(os.path.join(root, f"Documentation/filters/{name}.md")):
            yield f"{name}: no page Documentation/filters/{name}.md"
        if not mentioned(r"Documentation/README\.md", rf"\(filters/{name}\.md\)"):
            yield f"{name}: Documentation/README.md does not link its page"
        if not mentioned(rf"Modules/{module}/Testing/Cxx/Test\w+\.cxx", rf'#include "{name}\.h"'):
            yield f"{name}: no test in Modules/{module}/Testing/Cxx includes it"
        if not mentioned(r"Examples/Python/\w+\.py", rf"\b{name}\("):
            yield f"{name}: no example in Examples/Python uses it"
        if not mentioned(r"Modules/ParaViewPlugin/\w+\.xml", rf'class="{name}"'):
            yield f"{name}: no server-manager XML in Modules/ParaViewPlugin"
        rows = re.findall(rf"^\|.*\(filters/{name}\.md\)", menus, re.MULTILINE)
        if len(rows) != 1:
            yield f"{name}: Documentation/3-paraview.md lists it {len(rows)} times"
        if not mentioned(r"CHANGELOG\.md", rf"\b{name}\b"):
            yield f"{name}: no line in CHANGELOG.md"
    for module, name in sourcetree.classes(root, "helpers"):
        for pattern, word, lacking in (
                (rf"Modules/{module}/Testing/Cxx/Test\w+\.cxx", rf'#include "{name}\.h"', "no test includes it"),
                (r"Documentation/\d+-[\w-]+\.md", rf"\b{name}\b", "no page speaks of it"),
                (r"CHANGELOG\.md", rf"\b{name}\b", "no line in CHANGELOG.md")):
            if not mentioned(pattern, word):
                yield f"{name}: {lacking}"


if __name__ == "__main__":
    sourcetree.main(faults)
