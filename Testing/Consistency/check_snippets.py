#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of the first pages runs as printed, on the chair, and gives what it says and a well exposed image."""

import os
import re
import shutil
import tempfile

import numpy as np
import sourcetree
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOBJWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

PAGES = ("README.md", "Documentation/1-getting-started.md")


def snippets(root, page):
    """The page's Python; only the image is made small."""
    return [block.replace("256, 256", "48, 48").replace("chair.vtp\", lamp)\nshot", "chair.vtp\", lamp, size=(64, 48))\nshot")
            for block in re.findall(r"```python\n(.*?)```", sourcetree.text(root, page), re.DOTALL)]


def exposure_fault(colours):
    """What a person would say of the picture's exposure, or None."""
    if colours is None:
        return "there is no picture"
    bytes_ = vtk_to_numpy(colours)
    grey = bytes_ @ np.array([0.2126, 0.7152, 0.0722])
    lit = grey[grey > 8]
    if lit.size < 0.2 * grey.size:
        return f"only {lit.size} of {grey.size} pixels are lit"
    if not 64 <= np.median(lit) <= 190:
        return f"lit pixels have a median of {np.median(lit):.0f} of 255, which is no mid grey"
    clipped = (bytes_ == 255).any(axis=1).mean()
    if clipped > 0.1:
        return f"{clipped:.0%} of the pixels are burnt out"
    return None


def faults(root):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(root, "Data", "chair.vtp"))
    reader.Update()
    back = os.getcwd()
    folder = tempfile.mkdtemp()
    os.chdir(folder)
    try:
        writer = vtkOBJWriter()
        writer.SetInputConnection(reader.GetOutputPort())
        writer.SetFileName("mine.obj")
        writer.Write()
        os.symlink(os.path.join(root, "Data"), "Data")
        for page in PAGES:
            for number, code in enumerate(snippets(root, page), 1):
                names = {"mesh": reader.GetOutput()}
                try:
                    exec(code, names)
                except Exception as error:
                    yield f"{page}: snippet {number}: {error}"
                    continue
                for name in ("vectors", "cones", "image"):
                    if name in names and names[name].GetOutput().GetNumberOfPoints() == 0:
                        yield f"{page}: snippet {number}: {name} is empty"
                image = names["shot"].image if "shot" in names else names["image"].GetOutput()
                fault = exposure_fault(image.GetPointData().GetArray("RGB"))
                if fault:
                    yield f"{page}: snippet {number}: {fault}"
    finally:
        os.chdir(back)
        shutil.rmtree(folder)


if __name__ == "__main__":
    sourcetree.main(lambda root: faults(os.path.abspath(root)))
