# SPDX-License-Identifier: BSD-3-Clause
"""A macro for ParaView: Light Shafts and Scattering Images look as the active view does, from now on.

Run it once to follow the view: whenever the mouse is let go the picture is made anew. Run it again to stop. Of several images the
one that is selected in the pipeline is taken, else the last one.
"""

from paraview import simple

IMAGES = ("LightShafts", "ScatteringImage")


def image_to_follow():
    """The selected image, or the last one of the pipeline."""
    selected = simple.GetActiveSource()
    if selected is not None and selected.GetXMLName() in IMAGES:
        return selected
    images = [source for source in simple.GetSources().values() if source.GetXMLName() in IMAGES]
    if not images:
        raise RuntimeError("There are no Light Shafts and no Scattering Image in the pipeline")
    return images[-1]


def look(image, view):
    """Give an image the camera of a view, and its pixels the shape of the view; their number stays."""
    pixels = image.Resolution[0] * image.Resolution[1]
    width, height = view.ViewSize
    image.Resolution = [max(1, round((pixels * width / height) ** 0.5)), max(1, round((pixels * height / width) ** 0.5))]
    image.Camera = "Camera"
    image.Camera.Position = view.CameraPosition
    image.Camera.FocalPoint = view.CameraFocalPoint
    image.Camera.ViewUp = view.CameraViewUp
    image.Camera.ViewAngle = view.CameraViewAngle
    image.Camera.ParallelProjection = view.CameraParallelProjection
    image.Camera.ParallelScale = view.CameraParallelScale


def toggle(image, view):
    """Begin to follow a view, or stop. The followers live as long as the view: they stand in the module that every macro shares."""
    followers = simple.__dict__.setdefault("_shadow_cones_followers", {})
    interactor = view.SMProxy.GetInteractor()
    key = view.SMProxy.GetGlobalIDAsString()
    if key in followers:
        interactor.RemoveObserver(followers.pop(key))
        return False

    def follow(*_):
        look(image, view)
        simple.Render(view)

    follow()
    if interactor is not None:  # none in programs without a window
        followers[key] = interactor.AddObserver("EndInteractionEvent", follow)
    return True


if __name__ == "__main__":
    print("Following the view" if toggle(image_to_follow(), simple.GetActiveViewOrCreate("RenderView")) else "No longer following")
