#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The house in numbers: python3 house_numbers.py [TREE]

Files and lines of each folder, includes between the rooms of Core, longest functions, functions with the most parameters,
duplicated runs, and files of more than 600 lines. For people, before and after a change; check_house.py holds what must hold.
"""

import collections
import posixpath
import re
import sys

import check_rooms
import count_duplicates
import sourcetree

MANY_LINES = 600
REASON = "One file because "
CODE = r"(Modules|Testing|Examples|Utilities)/.*\.(h|cxx|py|sh)"
# What the line before a signature looks like: empty, the end of something, a comment, a specifier.
NO_SIGNATURE = re.compile(r"^\s*$|[;{}]\s*(//.*)?$|^\s*(//|/?\*|#)|^\s*(public|private|protected):")
LAMBDA = re.compile(r"\[[^\]]*\]\s*\(")
NO_FUNCTION = re.compile(r"(namespace|class|struct|union|enum|if|for|while|else|switch|do|try|catch|extern|return|case)\b")


def sources(root, pattern=CODE):
    return [path for path in sourcetree.files(root) if re.fullmatch(pattern, path)]


def head(text):
    """The comment that a file begins with, and the licence before it."""
    return re.match(r'(?:\s*(?://|#[! ])[^\n]*\n)*(?:\s*/\*.*?\*/|\s*""".*?""")?', text, re.DOTALL | re.MULTILINE).group(0)


def long_files(root):
    """(path, lines, whether its head says why) of every file with more lines than there should be."""
    for path in sources(root):
        text = sourcetree.text(root, path)
        count = len(text.splitlines())
        if count > MANY_LINES:
            yield path, count, REASON in head(text)


def parameters(signature):
    """Number of parameters of a function's signature; None where it is not one."""
    match = re.search(r"(~?\w+|operator\W+)\s*\(", signature)
    if not match or NO_FUNCTION.match(signature) or LAMBDA.search(signature) or re.search(r"[=\]]\s*$", signature[:match.start()]):
        return None
    depth, count, anything = 0, 1, False
    for sign in signature[match.end() - 1:]:
        depth += sign in "(<[{"
        depth -= sign in ")>]}"
        if depth == 0:
            break
        count += sign == "," and depth == 1
        anything = anything or (depth >= 1 and sign not in "( ")
    return count if anything else 0


def functions(root):
    """(path, line, lines, parameters) of the functions that are defined in the modules, by their layout."""
    for path in sources(root, r"Modules/(?!.*Testing/).*\.(h|cxx)"):
        lines = sourcetree.text(root, path).splitlines()
        for k, line in enumerate(lines):
            if line.strip() != "{":
                continue
            indent = line[:len(line) - 1]
            begin = k
            while begin > 0 and not NO_SIGNATURE.search(lines[begin - 1]):
                begin -= 1
            signature = " ".join(part.strip() for part in lines[begin:k])
            count = parameters(signature)
            end = next((n for n in range(k + 1, len(lines)) if lines[n].rstrip() in (indent + "}", indent + "};")), k)
            if count is not None and begin < k:
                yield path, begin + 1, end - begin + 1, count


def room_includes(root):
    """(room, other room) to the number of includes; and those that the table does not allow."""
    between = collections.Counter()
    paths = [path for path in sources(root, r"Modules/Core/\w+/\w+\.(h|cxx)") if "/Testing/" not in path]
    room_of = {posixpath.basename(path): path.split("/")[2] for path in paths}
    for path in paths:
        for _, name in sourcetree.includes(root, path):
            if room_of.get(name, path.split("/")[2]) != path.split("/")[2]:
                between[path.split("/")[2], room_of[name]] += 1
    return between, len(list(check_rooms.faults(root))) if between else 0


def folder_of(path):
    parts = path.split("/")
    if "Testing" in parts[1:]:
        return "/".join(parts[:2]) + "/Testing"
    return "/".join(parts[:3 if parts[1] == "Core" and len(parts) > 3 else 2])


def report(root):
    """The numbers as (name, value), and lists that explain them."""
    files = collections.Counter(folder_of(path) for path in sources(root))
    lines = {path: len(sourcetree.text(root, path).splitlines()) for path in sources(root)}
    between, wrong = room_includes(root)
    defined = list(functions(root))
    longest = sorted(defined, key=lambda f: -f[2])[:5]
    widest = sorted(defined, key=lambda f: -f[3])[:5]
    runs = count_duplicates.duplicates(root)
    long = list(long_files(root))
    for folder in sorted(files):
        print(f"{files[folder]:6} files {sum(n for p, n in lines.items() if folder_of(p) == folder):7} lines  {folder}")
    for (room, other), count in sorted(between.items()):
        print(f"{count:6} includes  {room} -> {other}")
    for path, line, count, _ in longest:
        print(f"{count:6} lines of a function  {path}:{line}")
    for path, line, _, count in widest:
        print(f"{count:6} parameters  {path}:{line}")
    for path, count, said in long:
        print(f"{count:6} lines{'' if said else ', no reason in its head'}  {path}")
    yield "files in the largest folder of sources", max(n for f, n in files.items() if "Testing" not in f)
    yield "includes between rooms", sum(between.values())
    yield "includes between rooms, the wrong way", wrong
    yield "lines of the longest function", longest[0][2]
    yield "functions of more than 60 lines", sum(f[2] > 60 for f in defined)
    yield "most parameters", widest[0][3]
    yield "functions of more than 6 parameters", sum(f[3] > 6 for f in defined)
    yield "duplicated runs", len(runs)
    yield "lines in them", sum(run[0] for run in runs)
    yield "files over 600 lines", len(long)
    yield "of these without a reason", sum(not said for _, _, said in long)
    yield "lines of the modules", sum(n for p, n in lines.items() if p.startswith("Modules/") and "Testing/" not in p)
    yield "lines of tests", sum(n for p, n in lines.items() if "Testing/" in p)
    yield "lines in all", sum(lines.values())


if __name__ == "__main__":
    for name, value in report(sys.argv[1] if len(sys.argv) > 1 else sourcetree.ROOT):
        print(f"{value:8}  {name}")
