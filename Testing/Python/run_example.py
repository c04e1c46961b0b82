#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Run an example in an empty folder, and look at what it wrote: run_example.py EXAMPLE [OPTIONS] --expect FILE..."""

import json
import os
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

TITLES = 30  # pixels
# Warnings that are right for a few hundred vectors and pixels.
OF_SMALL_RUNS = ("occluders have no shadow vector", "miss the RelativeErrorGoal", "asks no rays")


def points(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput().GetNumberOfPoints()


def fault(path):
    """What is wrong with a file, or None."""
    if not os.path.exists(path):
        return "was not written"
    if path.endswith(".png"):
        reader = vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        if min(width, height) < 16:
            return "is no PNG"
        image = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
        # Without the titles above and on the left: a blank picture has one colour or two.
        inside = image[:height - TITLES, TITLES:] if min(width, height) > 2 * TITLES else image
        colors = len(np.unique(inside.reshape(-1, inside.shape[2]), axis=0))
        return None if colors >= 20 else f"has {colors} colours only"
    if path.endswith(".json"):
        with open(path, encoding="utf-8") as file:
            return None if json.load(file)["rows"] else "has no rows"
    if path.endswith(".vtp"):
        return None if points(vtkXMLPolyDataReader(), path) > 0 else "has no points"
    if path.endswith(".vti"):
        return None if points(vtkXMLImageDataReader(), path) > 0 else "has no points"
    return None if os.path.getsize(path) > 0 else "is empty"


def main():
    at = sys.argv.index("--expect")
    command, expected = sys.argv[1:at], sys.argv[at + 1:]
    with tempfile.TemporaryDirectory() as folder:
        result = subprocess.run([sys.executable] + command + ["--output", folder], text=True, capture_output=True)
        print(result.stdout, result.stderr, sep="\n")
        if result.returncode != 0:
            raise SystemExit(f"exit status {result.returncode}")
        # VTK's own warnings and errors do not change the exit status.
        said = "\n".join(line for line in result.stderr.splitlines() if not any(words in line for words in OF_SMALL_RUNS))
        if "ERR|" in said or "WARN|" in said or "Warning:" in said:
            raise SystemExit("there were warnings or errors")
        faults = {name: fault(os.path.join(folder, name)) for name in expected}
        if any(faults.values()):
            raise SystemExit("; ".join(f"{name} {what}" for name, what in faults.items() if what))


if __name__ == "__main__":
    main()
