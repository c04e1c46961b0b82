#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether two builds give the same results: python3 Utilities/compare_builds.py OLD_BUILD NEW_BUILD [--only NAME...]

Runs the demo, examples and benchmarks of both builds at small sizes. Files are compared byte by byte; data sets array by array
where their bytes differ, since an image holds the seconds that it took. Of what the benchmarks print everything is
compared but times, rates and memory. Exit status 1 at a difference, 2 where a program fails or is missing in one build.
Each build runs the examples of its own source tree.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

SMALL = ["--vectors", "600"]
# Examples, with options that make them quick.
EXAMPLES = {
    "chair_demo": ["--vectors", "2000", "--size", "48", "--no-display"],
    "exposures": ["--size", "24", *SMALL],
    "figure8": ["--size", "16", "--samples", "2", *SMALL],
    "fog_bank": ["--size", "16", "--points", "12", *SMALL],
    "lights": ["--size", "16"],
    "modes": ["--size", "24", "--goal", "0.05", *SMALL],
    "two_lamps": ["--size", "16", *SMALL],
}
# Benchmarks, with options, and the columns of what they print that are no results.
BENCHMARKS = {
    "cone-accuracy": (["--scene", "chair", "tree", "--vectors", "3000", "--set", "paper", "bounds", "soft", "--points",
                       "5000", "--light-points", "16"], ["vectors[s]", "tuning[s]", "fit[s]", "ray[ns]"]),
    "cone-building": (["--vectors", "5000", "20000"],
                      ["trace s", "fit s", "exponent", "us/vector", "all exp.", "peak MB"]),
    "cone-image": (["--scene", "chair", "--size", "64", "--pixels", "64", "--samples", "1", "--grid", "17"],
                   ["cones s", "fill s", "image s"]),
    "cone-proof": (["--scene", "chair", "--vectors", "2000", "--points", "3000"], ["seconds", "check s"]),
    "cone-tuning": (["--scenes", "chair", "--vectors", "2000", "--sets", "4"], ["seconds"]),
    "scattering-table": (["--scene", "chair", "--vectors", "2000", "--size", "32", "--pixels", "32", "--samples", "256",
                          "--repeats", "1"], ["seconds", "speed"]),
    "scattering-speed": (["--scene", "chair", "--vectors", "1000", "--size", "16", "--pixels", "16", "--samples", "256",
                          "--repeats", "1", "--enough", "0", "--json", "speed.json"], None),
}
VOLATILE = {"RenderSeconds"}
# Keys of scattering-speed's figures that are times, or made of them.
TIMES = re.compile(r"second|processor|speed|ratio|threading|comparison|growth|exponent|time|runs|at_equal_error", re.IGNORECASE)


def source_of(build):
    """The source tree of a build: the folder around it, else where CMake found it."""
    around = os.path.dirname(os.path.abspath(build))
    if os.path.exists(os.path.join(around, "Examples", "Python")):
        return around
    with open(os.path.join(build, "CMakeCache.txt"), encoding="utf-8") as cache:
        return re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", cache.read(), re.MULTILINE).group(1)


def without_columns(text, names):
    """The table in @p text without the columns of these names; right-aligned columns under the line of all names."""
    cuts = []
    for line in text.splitlines():
        if names and all(name in line for name in names) and not line.startswith("#"):
            cuts = []
            for name in names:
                begin = re.search(r"(?<!\S)" + re.escape(name) + r"(?!\S)", line).start()
                cuts.append((len(line[:begin].rstrip()), begin + len(name)))
        if not line.startswith("#"):
            for begin, end in sorted(cuts, reverse=True):
                line = line[:begin] + line[end:]
        yield line


def figures(value):
    """The figures of scattering-speed that are no times."""
    if isinstance(value, dict):
        return {key: figures(part) for key, part in value.items() if not TIMES.search(key)}
    return [figures(part) for part in value] if isinstance(value, list) else value


def arrays(path):
    """Every array of a data set by name, but for times."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader
    reader = vtkXMLGenericDataObjectReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    result = {"bounds": str(data.GetBounds())}
    if hasattr(data, "GetPoints") and data.GetPoints():
        result["points"] = vtk_to_numpy(data.GetPoints().GetData()).tobytes()
    for kind, fields in (("point", data.GetPointData()), ("cell", data.GetCellData()), ("field", data.GetFieldData())):
        for i in range(fields.GetNumberOfArrays()):
            array, name = fields.GetAbstractArray(i), fields.GetArrayName(i)
            if name not in VOLATILE:
                strings = not fields.GetArray(i)
                result[f"{kind} {name}"] = ([array.GetValue(k) for k in range(array.GetNumberOfValues())] if strings else
                                            vtk_to_numpy(array).tobytes())
    return result


def difference(old, new):
    """What differs between two files; None where nothing does."""
    with open(old, "rb") as a, open(new, "rb") as b:
        one, two = a.read(), b.read()
    if one == two:
        return None
    if old.endswith((".vtp", ".vti")):
        one, two = arrays(old), arrays(new)
        names = [key for key in sorted(one.keys() | two.keys()) if one.get(key) != two.get(key)]
        return ", ".join(names) or None
    if old.endswith(".json"):
        return None if figures(json.loads(one)) == figures(json.loads(two)) else "figures"
    if old.endswith(".txt"):
        lines = zip(one.decode().splitlines(), two.decode().splitlines())
        return next((f"'{a.strip()}' is '{b.strip()}'" for a, b in lines if a != b), "number of lines")
    return f"{len(one)} and {len(two)} bytes"


def run(build, name, folder):
    """Run an example or a benchmark of a build; what it prints and writes lies in the folder. @return a fault or None."""
    source = source_of(build)
    environment = dict(os.environ, PYTHONPATH=os.path.join(build, "lib", "python3", "dist-packages"),
                       PYTHONDONTWRITEBYTECODE="1", LD_LIBRARY_PATH=os.path.join(build, "lib"),
                       SHADOWCONES_DATA_DIR=os.path.join(source, "Data"))
    data, names = os.path.join(source, "Data"), None
    if name in EXAMPLES:
        command = [sys.executable, os.path.join(source, "Examples", "Python", name + ".py"), "--data", data,
                   "--output", folder, *EXAMPLES[name]]
    elif name == "chair":
        command = [os.path.join(build, "bin", name), os.path.join(data, "chair.vtp"),
                   os.path.join(data, "cornell-box.vtp"), folder]
    else:
        options, names = BENCHMARKS[name]
        command = [os.path.join(build, "bin", name), *options]
    if not os.path.exists(command[0]) or not os.path.exists(command[1 if name in EXAMPLES else 0]):
        return "is not there"
    result = subprocess.run(command, cwd=folder, env=environment, text=True, capture_output=True, check=False)
    if result.returncode != 0:
        return f"ends with {result.returncode}: {(result.stderr or result.stdout).strip()[-300:]}"
    if names:
        with open(os.path.join(folder, "printed.txt"), "w", encoding="utf-8") as file:
            file.write("\n".join(without_columns(result.stdout, names)) + "\n")
    return None


def compare(name, builds, folder):
    """(state, line) of every file that a program leaves, state 0 same, 1 different, 2 failed."""
    folders = []
    for which, build in zip(("old", "new"), builds):
        folders.append(os.path.join(folder, name, which))
        os.makedirs(folders[-1])
        fault = run(build, name, folders[-1])
        if fault:
            yield 2, f"failed     {name}: the {which} build's {fault}"
            return
    files = [set(os.listdir(one)) for one in folders]
    for file in sorted(files[0] | files[1]):
        if not (file in files[0] and file in files[1]):
            yield 1, f"different  {name}/{file}: in one build only"
            continue
        what = difference(*(os.path.join(one, file) for one in folders))
        yield bool(what), f"different  {name}/{file}: {what}" if what else f"same       {name}/{file}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("old", help="build folder, with the examples and benchmarks built")
    parser.add_argument("new", help="the other one")
    names = [*EXAMPLES, "chair", *BENCHMARKS]
    parser.add_argument("--only", nargs="+", choices=names, default=names, help="programs to run (default: all)")
    options = parser.parse_args()
    worst = 0
    with tempfile.TemporaryDirectory() as folder:
        for name in options.only:
            for state, line in compare(name, [os.path.abspath(options.old), os.path.abspath(options.new)], folder):
                print(line, flush=True)
                worst = max(worst, state)
    sys.exit(worst)


if __name__ == "__main__":
    main()
