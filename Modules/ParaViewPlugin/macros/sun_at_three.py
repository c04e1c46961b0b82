# SPDX-License-Identifier: BSD-3-Clause
"""A macro for ParaView: the Sun of a summer's afternoon, 45 degrees high, from the right and the front.

It takes its place from the bounds of what is selected (y is up), and stands in the pipeline as an Area Light of yours to change.
"""

from paraview import simple


def bounds_of(source):
    """The box of a source: x from, to, y from, to, z from, to; one around the origin where nothing is selected."""
    if source is None:
        return (-0.5, 0.5, -0.5, 0.5, -0.5, 0.5)
    simple.UpdatePipeline(proxy=source)
    return source.GetDataInformation().GetBounds()


def place(bounds):
    """The Sun; it is drawn beside the box."""
    largest = max(bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3))
    center = [0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]) for axis in range(3)]
    towards = [0.58, 0.707, 0.41]
    return simple.AreaLight(registrationName="Sun", Shape="Sun", Normal=[-c for c in towards],
                            Center=[c + largest * t for c, t in zip(center, towards)])


if __name__ == "__main__":
    lamp = place(bounds_of(simple.GetActiveSource()))
    simple.Show(lamp, simple.GetActiveViewOrCreate("RenderView"))
    simple.Render()
