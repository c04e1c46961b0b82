#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Files of Core lie in rooms, and a room includes only what the table of Modules/Core/README.md lets it include."""

import posixpath
import re
import sourcetree

CORE = "Modules/Core/"


def rooms(root):
    """For each room that the table names: the rooms that it may include, itself among them."""
    rows = re.findall(r"^\| (\w+) \| ([\w, ]*)\|", sourcetree.text(root, CORE + "README.md"), re.MULTILINE)
    return {room: {room, *re.findall(r"\w+", allowed)} for room, allowed in rows if room != "room"}


def faults(root):
    allowed = rooms(root)
    for room in sorted(set().union(*allowed.values()) - set(allowed)):
        yield f"{CORE}README.md: no row for the room {room}"
    sources = [path for path in sourcetree.files(root) if path.startswith(CORE) and path.endswith((".h", ".cxx"))]
    sources = [path for path in sources if not path.startswith(CORE + "Testing/")]
    room_of = {posixpath.basename(path): posixpath.dirname(path)[len(CORE):] for path in sources}
    for path in sources:
        room = room_of[posixpath.basename(path)]
        if room not in allowed:
            yield f"{path}: lies in no room of {CORE}README.md"
            continue
        for line, name in sourcetree.includes(root, path):
            other = room_of.get(name)
            if other is not None and other not in allowed[room]:
                yield f"{path}:{line}: {room} may not include {name} of {other}"


if __name__ == "__main__":
    sourcetree.main(faults)
