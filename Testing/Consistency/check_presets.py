#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pages name presets that are there, and send users of other systems to one that needs no package of the tests."""

import json
import re

import sourcetree

PAGE = "Documentation/1-getting-started.md"


def variables(presets, name):
    """Cache variables of a configure preset, with those that it inherits."""
    preset = presets[name]
    parent = preset.get("inherits")
    inherited = variables(presets, parent) if parent else {}
    return {**inherited, **preset.get("cacheVariables", {})}


def faults(root):
    files = set(sourcetree.files(root))
    if "CMakePresets.json" not in files:
        return
    presets = {one["name"]: one for one in json.loads(sourcetree.text(root, "CMakePresets.json"))["configurePresets"]}
    for path in sorted(files):
        if path.endswith((".md", ".sh")):
            for name in re.findall(r"--preset[ \n]+(\w+)", sourcetree.text(root, path)):
                if name not in presets:
                    yield f"{path}: there is no preset {name}"
    if PAGE in files:
        section = sourcetree.text(root, PAGE).split("## Other systems", 1)[-1]
        commands = re.search(r"```sh\n(.*?)```", section, re.DOTALL)
        for name in re.findall(r"cmake --preset (\w+)", commands.group(1) if commands else ""):
            if name in presets and variables(presets, name).get("SHADOWCONES_BUILD_TESTING", "ON") != "OFF":
                yield f"{PAGE}: preset {name} builds the tests, whose packages users need not have"


if __name__ == "__main__":
    sourcetree.main(faults)
