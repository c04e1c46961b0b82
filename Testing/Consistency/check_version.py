#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The version of CMake is the one at the top of the changelog, versions fall from there, and find_package asks for it."""

import re

import sourcetree

HEADING = re.compile(r"## (\d+)\.(\d+)\.(\d+) \((\d{4}-\d\d-\d\d|unreleased)\)")


def faults(root):
    listed = re.search(r"^project\(\w+ VERSION ([\d.]+)", sourcetree.text(root, "CMakeLists.txt"), re.MULTILINE)
    if not listed:
        yield "CMakeLists.txt: project() has no VERSION"
        return
    version = listed.group(1)
    versions = []
    for line in re.findall(r"^## .*", sourcetree.text(root, "CHANGELOG.md"), re.MULTILINE):
        heading = HEADING.fullmatch(line)
        if not heading:
            yield f"CHANGELOG.md: '{line}' is no version with a date, or with (unreleased)"
            continue
        if versions and heading.group(4) == "unreleased":
            yield f"CHANGELOG.md: '{line}' is below another version"
        versions.append(tuple(int(part) for part in heading.groups()[:3]))
    if not versions or ".".join(map(str, versions[0])) != version:
        yield f"CHANGELOG.md: the first version is not {version}, that of CMakeLists.txt"
    if versions != sorted(set(versions), reverse=True):
        yield "CHANGELOG.md: the newest version does not come first"
    minor = version.rsplit(".", 1)[0]
    for path in sourcetree.files(root):
        if path.endswith((".md", ".txt")) and path != "CHANGELOG.md":
            for asked in re.findall(r"find_package\(ShadowCones (\d[\d.]*)", sourcetree.text(root, path) or ""):
                if asked != minor:
                    yield f"{path}: find_package asks for {asked}, this is {minor}"


if __name__ == "__main__":
    sourcetree.main(faults)
