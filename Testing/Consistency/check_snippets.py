#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Python of the first pages runs as printed, on the chair, and gives shadow vectors, cones and an image."""

import os
import re
import shutil
import tempfile

import sourcetree
from vtkmodules.vtkIOGeometry import vtkOBJWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

PAGES = ("README.md", "Documentation/1-getting-started.md")


def snippets(root, page):
    """The page's Python; only the image is made small."""
    return [block.replace("256, 256", "16, 16")
            for block in re.findall(r"```python\n(.*?)```", sourcetree.text(root, page), re.DOTALL)]


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
        for page in PAGES:
            for number, code in enumerate(snippets(root, page), 1):
                names = {"mesh": reader.GetOutput()}
                try:
                    exec(code, names)
                except Exception as error:
                    yield f"{page}: snippet {number}: {error}"
                    continue
                for name in ("vectors", "cones", "image"):
                    if names[name].GetOutput().GetNumberOfPoints() == 0:
                        yield f"{page}: snippet {number}: {name} is empty"
                colours = names["image"].GetOutput().GetPointData().GetArray("RGB")
                if colours is None or not 0 < colours.GetRange(0)[1] < 256:
                    yield f"{page}: snippet {number}: the image is black"
    finally:
        os.chdir(back)
        shutil.rmtree(folder)


if __name__ == "__main__":
    sourcetree.main(lambda root: faults(os.path.abspath(root)))
