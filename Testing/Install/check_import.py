# SPDX-License-Identifier: BSD-3-Clause
"""The Python package of the folder given is the one that is imported, and it works."""

import os
import sys

import shadowcones as sc
from vtkmodules.vtkCommonCore import VTK_STRING

folder = os.path.realpath(sys.argv[1])
if os.path.commonpath([folder, os.path.realpath(sc.__file__)]) != folder:
    sys.exit(f"{sc.__file__} was imported, which is not in {folder}")

with open("/proc/self/maps", encoding="utf-8") as maps:
    loaded = sorted({line.split()[-1] for line in maps if "ShadowCones" in line})
strangers = [path for path in loaded if os.path.commonpath([folder, path]) != folder]
if strangers:
    sys.exit(f"Loaded from elsewhere: {strangers}")

light = sc.vtkAreaLightSource()
light.Update()
if light.GetOutput().GetNumberOfCells() != 1:
    sys.exit("The light has no mesh")

said = []


def hear(_caller, _event, text=""):
    said.append(text)


hear.CallDataType = VTK_STRING
light.AddObserver("ErrorEvent", hear)
light.SetResolution(0)
light.SetNumberOfWavelengths(0)
light.Update()
if not said or any(part.startswith("/") for text in said for part in text.replace(",", " ").split()):
    sys.exit(f"A message must name its file, and not the folder of the build: {said}")
print(f"{len(loaded)} libraries of {folder}")
