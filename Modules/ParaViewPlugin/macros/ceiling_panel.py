# SPDX-License-Identifier: BSD-3-Clause
"""A macro for ParaView: a lamp as a ceiling has them, a panel twice as long as wide, that faces down.

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
    """A panel over the middle of a box, half as long as the box is wide."""
    x, y, z = (bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3))
    length = 0.5 * max(x, z)
    return simple.AreaLight(registrationName="Ceiling panel", Shape="Rectangle", Width=length, Height=0.5 * length,
                            Center=[0.5 * (bounds[0] + bounds[1]), bounds[3] + 0.5 * max(x, y, z), 0.5 * (bounds[4] + bounds[5])],
                            Normal=[0.0, -1.0, 0.0], Up=[0.0, 0.0, 1.0])


if __name__ == "__main__":
    lamp = place(bounds_of(simple.GetActiveSource()))
    simple.Show(lamp, simple.GetActiveViewOrCreate("RenderView"))
    simple.Render()
