#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The command and the Python package on files of strangers, a full disk, a kill and too little memory.

    test_files.py SHADOWCONES AWKWARD_MESHES [--long]

Prints what was tried; with --long every awkward mesh in every command, and every format cut in many places.
"""

import os
import resource
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM, MESHES = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
LONG = "--long" in sys.argv[3:]
LAMP = ["--light", "disc:0,0,9", "radius", "1", "facing", "0,0,-1"]
COMMANDS = {
    "probe": ["--at", "0.1,0.2,-1"],
    "image": ["--size", "8x6", "-o", "out.png"],
    "vectors": ["-o", "out.vtp"],
    "cones": ["-o", "out.vtp"],
    "irradiance": ["--at", "0.1,0.2,-1", "--facing", "0,0,1"],
    "fluence": ["--at", "0.1,0.2,-1"],
    "shadow-of": ["--at", "0.1,0.2,-1"],
    "widths": ["--ground", "-1,4,8", "-o", "out.vtp"],
    "footprints": ["--ground", "-1,4,8", "-o", "out.geojson"],
    "solids": ["--resolution", "12", "-o", "out.stl"],
    "sun-hours": ["--at", "0.1,0.2,-1", "--latitude", "50", "--longitude", "8", "--start", "2026-06-01", "--end", "2026-06-02",
                  "--step", "120"],
    "page": ["-o", "out.html"],
}
BOX_POINTS = [(x, y, z) for z in (1, 2) for y in (-1, 1) for x in (-1, 1)]
BOX_FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]

SCRIPT = """
import sys
import numpy as np
import shadowcones as sc
for path in sys.argv[1:]:
    try:
        seen = sc.visibility([[0.1, 0.2, -1.0]], path, "disc:0,0,9 radius 1 facing 0,0,-1")
        print("answer" if np.isfinite(np.asarray(seen)).all() else "no number: %r" % seen, flush=True)
    except (ValueError, RuntimeError, OSError) as error:
        print("refused", str(error).replace(chr(10), " "), flush=True)
"""

tried, lost = {}, []


def note(kind, what, fault):
    tried[kind] = tried.get(kind, 0) + 1
    if fault:
        lost.append(f"{kind}, {what}: {fault}")
        print(f"  LOST {lost[-1]}", flush=True)


def run(words, folder, before=None, timeout=120):
    return subprocess.run([PROGRAM, *words, "-q"], cwd=folder, capture_output=True, text=True, errors="replace", timeout=timeout,
                          preexec_fn=before)


def verdict(done, wanted):
    """Empty where the program ended as it says it does: 0, or 1 with a sentence."""
    if done.returncode not in wanted:
        return f"exit code {done.returncode}: {done.stderr[:300]}"
    if done.returncode != 0 and not done.stderr.strip().split("\n")[-1].startswith("shadowcones: "):
        return f"no sentence: {done.stderr[:300]!r}"
    if done.returncode == 0 and ("nan" in done.stdout.lower() or "inf" in done.stdout.lower()):
        return f"an answer that is no number: {done.stdout[:300]}"
    return ""


def words_of(command, mesh):
    lamp = [] if command == "sun-hours" else LAMP
    return [command, mesh, *lamp, *COMMANDS[command]]


def awkward_files(folder):
    """Every awkward mesh as a file: what casts gives an answer, what has none a sentence."""
    listing = subprocess.run([MESHES, "--write", folder], capture_output=True, text=True, check=True).stdout
    for number, line in enumerate(listing.strip().split("\n")):
        path, kind = line.split("\t")
        # A shadow may miss the lamp's place: only files that have no answer must fail.
        known = path.endswith((".vtp", ".vtu"))
        wanted = (0, 1) if kind in ("casts", "empty") and known else (1,)
        commands = list(COMMANDS) if LONG else ["probe"] if number % 5 == 0 else []
        for command in commands:
            note("awkward files", f"{command} {os.path.basename(path)}", verdict(run(words_of(command, path), folder), wanted))


def python_package(folder):
    """The same files in one script, which sees an answer or an exception each time."""
    package = os.path.join(os.path.dirname(os.path.dirname(PROGRAM)), "lib", "python3", "dist-packages")
    if not os.path.isdir(os.path.join(package, "shadowcones")):
        return
    listing = subprocess.run([MESHES, "--write", folder], capture_output=True, text=True, check=True).stdout
    files = [line.split("\t") for line in listing.strip().split("\n")]
    done = subprocess.run(["/usr/bin/python3", "-c", SCRIPT, *[path for path, _ in files]], capture_output=True, text=True, timeout=300,
                          env={**os.environ, "PYTHONPATH": package})
    said = done.stdout.strip().split("\n")
    for number, (path, kind) in enumerate(files):
        answer = said[number] if number < len(said) else f"the script ended: {done.returncode} {done.stderr[-300:]}"
        wanted = ("answer", "refused") if kind in ("casts", "empty") else ("refused",)
        note("Python", os.path.basename(path), "" if answer.startswith(wanted) else answer)


def formats():
    """A box in the formats that are text."""
    lines = [f"v {x} {y} {z}" for x, y, z in BOX_POINTS] + ["f " + " ".join(str(i + 1) for i in face) for face in BOX_FACES]
    yield "box.obj", "\n".join(lines) + "\n"
    head = f"ply\nformat ascii 1.0\nelement vertex {len(BOX_POINTS)}\nproperty float x\nproperty float y\nproperty float z\n"
    head += f"element face {len(BOX_FACES)}\nproperty list uchar int vertex_indices\nend_header\n"
    yield "box.ply", head + "".join(f"{x} {y} {z}\n" for x, y, z in BOX_POINTS) + "".join(
        "4 " + " ".join(map(str, face)) + "\n" for face in BOX_FACES)
    facets = ""
    for a, b, c, d in BOX_FACES:
        for triangle in ((a, b, c), (a, c, d)):
            facets += "facet normal 0 0 0\nouter loop\n" + "".join(
                "vertex {} {} {}\n".format(*BOX_POINTS[i]) for i in triangle) + "endloop\nendfacet\n"
    yield "box.stl", f"solid box\n{facets}endsolid box\n"
    yield "box.vtk", (f"# vtk DataFile Version 3.0\nbox\nASCII\nDATASET POLYDATA\nPOINTS {len(BOX_POINTS)} float\n" + "".join(
        f"{x} {y} {z}\n" for x, y, z in BOX_POINTS) + f"POLYGONS {len(BOX_FACES)} {5 * len(BOX_FACES)}\n" + "".join(
            "4 " + " ".join(map(str, face)) + "\n" for face in BOX_FACES))


def cut_files(folder):
    """Files that end too early."""
    places = 40 if LONG else 3
    for name, text in formats():
        path = os.path.join(folder, name)
        for k in range(places):
            with open(path, "w", encoding="utf-8") as file:
                file.write(text[:len(text) * k // places])
            note("cut files", f"{name} after {k} of {places}", verdict(run(words_of("probe", path), folder), (0, 1)))
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        note("cut files", f"{name} whole", verdict(run(words_of("probe", path), folder), (0,)))


def full_disk(folder):
    """A file takes no more than some bytes: an error, and what was there before as it was."""
    commands = [name for name in COMMANDS if "-o" in COMMANDS[name]] if LONG else ["footprints", "vectors"]
    for command in commands:
        words = words_of(command, os.path.join(folder, "box.obj"))
        output = os.path.join(folder, words[-1])
        for room in (0, 10, 300) if LONG else (10,):
            with open(output, "w", encoding="utf-8") as file:
                file.write("old")
            before = sorted(os.listdir(folder))

            def limit(room=room):
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))

            fault = verdict(run(words, folder, before=limit), (1,))
            with open(output, encoding="utf-8", errors="replace") as file:
                fault = fault or ("" if file.read() == "old" else "the old file is not as it was")
            fault = fault or ("" if sorted(os.listdir(folder)) == before else "a part of a file is left")
            note("full disk", f"{command} with room for {room} bytes", fault)
        os.remove(output)


def killed(folder):
    """Killed at any moment: the old file or the new one, whole."""
    words = ["page", os.path.join(folder, "box.obj"), *LAMP, "-o", "out.html", "-q"]
    output = os.path.join(folder, "out.html")
    for k in range(12 if LONG else 2):
        with open(output, "w", encoding="utf-8") as file:
            file.write("old")
        running = subprocess.Popen([PROGRAM, *words], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(0.05 + 0.1 * k)
        running.kill()
        running.wait()
        with open(output, encoding="utf-8") as file:
            text = file.read()
        note("killed runs", f"after {0.05 + 0.1 * k:.2f} s", "" if text == "old" or text.rstrip().endswith("</html>") else "half a file")


def little_memory(folder):
    """More memory is asked for than there is: a sentence, and no kill."""
    mesh = os.path.join(folder, "box.obj")
    requests = [["image", mesh, *LAMP, "--size", "30000x30000", "-o", "out.png"],
                ["probe", mesh, *LAMP, "--grid", "2000,2000,2000", "-o", "out.vti"],
                ["solids", mesh, *LAMP, "--resolution", "600", "-o", "out.stl"],
                ["vectors", mesh, *LAMP, "--vectors", "200000000", "-o", "out.vtp"]]
    for words in requests if LONG else requests[:2]:
        for megabytes in (700, 1500) if LONG else (900,):
            limit = megabytes << 20
            done = run(words, folder, before=lambda limit=limit: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
            note("little memory", f"{words[0]} in {megabytes} MiB", verdict(done, (1,)))


with tempfile.TemporaryDirectory() as temporary:
    cut_files(temporary)
    awkward_files(temporary)
    python_package(temporary)
    full_disk(temporary)
    killed(temporary)
    little_memory(temporary)
for kind, count in tried.items():
    print(f"{kind}: {count}")
print(f"tried: {sum(tried.values())}, lost: {len(lost)}")
sys.exit(1 if lost else 0)
