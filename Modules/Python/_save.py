# SPDX-License-Identifier: BSD-3-Clause
"""Results to files: by the extension of the name, whole or not at all."""

import os
import tempfile

from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkBMPWriter, vtkJPEGWriter, vtkPNGWriter, vtkTIFFWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

PICTURES = {".png": vtkPNGWriter, ".tif": vtkTIFFWriter, ".tiff": vtkTIFFWriter, ".jpg": vtkJPEGWriter,
            ".jpeg": vtkJPEGWriter, ".bmp": vtkBMPWriter}
IMAGES = {".vti": vtkXMLImageDataWriter, **PICTURES}
MESHES = {".vtp": vtkXMLPolyDataWriter, ".stl": vtkSTLWriter, ".ply": vtkPLYWriter, ".obj": vtkOBJWriter}


def save(data, path, writers):
    """Write data with the writer of the name's extension. Raises ValueError for another one, OSError where it cannot."""
    path = os.fspath(path)
    extension = os.path.splitext(path)[1].lower()
    if extension not in writers:
        raise ValueError(f"{path!r} must end in one of {', '.join(sorted(writers))}")
    folder = os.path.dirname(os.path.abspath(path))
    # Beside it first, so that a full disk leaves no half file under its name.
    handle, beside = tempfile.mkstemp(suffix=extension, prefix=".shadowcones-", dir=folder)
    os.close(handle)
    try:
        faults = []
        writer = writers[extension]()
        writer.SetInputData(data)
        writer.SetFileName(beside)
        writer.AddObserver("ErrorEvent", lambda *_: faults.append(1))
        writer.Write()
        if faults or os.path.getsize(beside) == 0:
            raise OSError(f"{path!r} could not be written: is the disk full?")
        umask = os.umask(0)
        os.umask(umask)
        os.chmod(beside, 0o666 & ~umask)
        os.replace(beside, path)
    finally:
        if os.path.exists(beside):
            os.remove(beside)


def png(image):
    """The bytes of a PNG file of an image's active scalars."""
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.WriteToMemoryOn()
    writer.Write()
    return bytes(memoryview(writer.GetResult()))
