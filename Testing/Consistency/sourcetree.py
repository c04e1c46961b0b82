# SPDX-License-Identifier: BSD-3-Clause
"""What the checks of this folder share: the files of the project, and what CMake installs of them."""

import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
SKIPPED_FOLDERS = {".git", "__pycache__", "build", "output"}


def files(root):
    """Paths of all files of the source tree, relative to its root, with '/' between folders."""
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in SKIPPED_FOLDERS and not f.startswith(("build-", "output-")))
        for name in sorted(set(names) - SKIPPED_FOLDERS):  # .git is a file in a worktree
            yield os.path.relpath(os.path.join(folder, name), root).replace(os.sep, "/")


def text(root, path):
    """The text of a file; None where it is not text."""
    try:
        with open(os.path.join(root, path), encoding="utf-8") as stream:
            return stream.read()
    except UnicodeDecodeError:
        return None


def includes(root, path):
    """Names that a C++ file includes, each with its line number."""
    for number, line in enumerate(text(root, path).splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
        if match:
            yield number, match.group(1)


def cmake_lists(root):
    """For each module: its name and the words of its CMakeLists.txt without comments."""
    for path in files(root):
        match = re.fullmatch(r"Modules/(\w+)/CMakeLists\.txt", path)
        if match:
            yield match.group(1), re.findall(r"[()]|[^\s()]+", re.sub(r"#[^\n]*", "", text(root, path)))


def classes(root, kind="classes"):
    """(module, class) of every class that is listed in a module's set(classes ...): filters and sources.

    Of the kind "helpers": classes without ports, which have no place in ParaView.
    """
    for module, words in cmake_lists(root):
        inside = False
        for before, word in zip([""] + words, words):
            if word == kind and before == "(":
                inside = True
            elif word == ")":
                inside = False
            elif inside:
                yield module, word


def installed_headers(root):
    """Paths of the headers that are installed: of classes, and what else a CMakeLists.txt names, private ones aside."""
    for module, name in [*classes(root), *classes(root, "helpers")]:
        yield f"Modules/{module}/{name}.h"
    for module, words in cmake_lists(root):
        private = False
        for word in words:
            if word.isupper() or word in "()":
                private = word == "PRIVATE_HEADERS"
            elif word.endswith(".h") and not private:
                yield f"Modules/{module}/{word}"


def main(faults):
    """Run a check on the tree named on the command line, by default the one that this file is in."""
    root = sys.argv[1] if len(sys.argv) > 1 else ROOT
    found = list(faults(root))
    for fault in found:
        print(fault)
    print(f"{len(found)} faults")
    sys.exit(1 if found else 0)
