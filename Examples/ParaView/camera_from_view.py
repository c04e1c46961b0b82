# SPDX-License-Identifier: BSD-3-Clause
"""A macro for ParaView: let the active Scattering Image look as the active render view does.

In ParaView: Macros, Import new macro. Select the Scattering Image in the pipeline, click into the render view, run the macro.
"""

from paraview import simple


def camera_from_view(image, view):
    """Copy the camera of a render view to a Scattering Image."""
    image.Camera = "Camera"
    image.Camera.Position = view.CameraPosition
    image.Camera.FocalPoint = view.CameraFocalPoint
    image.Camera.ViewUp = view.CameraViewUp
    image.Camera.ViewAngle = view.CameraViewAngle
    image.Camera.ParallelProjection = view.CameraParallelProjection
    image.Camera.ParallelScale = view.CameraParallelScale


if __name__ == "__main__":
    image = simple.GetActiveSource()
    if image is None or image.GetXMLName() != "ScatteringImage":
        raise RuntimeError("Select a Scattering Image in the pipeline first")
    camera_from_view(image, simple.GetActiveView())
    simple.Render()
