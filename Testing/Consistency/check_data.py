#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The meshes of Data/ are what Utilities/generate_data.py makes."""

import os
import subprocess
import sys
import tempfile

import numpy as np
import sourcetree
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def arrays(path):
    """Everything in a file, by name."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    mesh = reader.GetOutput()
    result = {
        "points": vtk_to_numpy(mesh.GetPoints().GetData()),
        "offsets": vtk_to_numpy(mesh.GetPolys().GetOffsetsArray()),
        "connectivity": vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()),
    }
    for kind, data in (("point", mesh.GetPointData()), ("cell", mesh.GetCellData()), ("field", mesh.GetFieldData())):
        for i in range(data.GetNumberOfArrays()):
            result[f"{kind} data {data.GetArrayName(i)}"] = vtk_to_numpy(data.GetArray(i))
    return result


def compare(name, committed, made):
    if committed.keys() != made.keys():
        yield f"{name}: has {sorted(committed)}, the generator makes {sorted(made)}"
        return
    for key, values in committed.items():
        if values.shape != made[key].shape or values.dtype.kind != made[key].dtype.kind:
            yield f"{name}: {key} has another size or type"
        # Coordinates are rounded to six decimals: another sine may move the last of them.
        elif not np.allclose(values, made[key], rtol=0.0, atol=2e-6 if values.dtype.kind == "f" else 0.0):
            yield f"{name}: {key} differs"


def faults(root):
    committed = {name for name in os.listdir(os.path.join(root, "Data")) if name.endswith(".vtp")}
    with tempfile.TemporaryDirectory() as folder:
        generator = os.path.join(root, "Utilities", "generate_data.py")
        subprocess.run([sys.executable, generator, "--output", folder], check=True)
        made = set(os.listdir(folder))
        for name in sorted(committed ^ made):
            yield f"Data/{name}: " + ("missing" if name in made else "made by nothing")
        for name in sorted(committed & made):
            here, there = os.path.join(root, "Data", name), os.path.join(folder, name)
            yield from compare(f"Data/{name}", arrays(here), arrays(there))


if __name__ == "__main__":
    sourcetree.main(faults)
