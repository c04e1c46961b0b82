# SPDX-License-Identifier: BSD-3-Clause
"""A macro for ParaView: a bulb, a sphere that shines to all sides, in seven wavelengths of a warm white.

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
    """A sphere over a corner of a box; its radiance falls to the short wavelengths as that of a black body of 2700 K does."""
    x, y, z = (bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3))
    largest = max(x, y, z)
    return simple.AreaLight(registrationName="Bulb", Shape="Sphere", Radius=0.03 * largest, NumberOfWavelengths=7,
                            Center=[bounds[0], bounds[3] + 0.3 * largest, bounds[5]],
                            RadianceSpectrum=[0.20, 0.39, 0.66, 1.00, 1.39, 1.79, 2.20])


if __name__ == "__main__":
    lamp = place(bounds_of(simple.GetActiveSource()))
    simple.Show(lamp, simple.GetActiveViewOrCreate("RenderView"))
    simple.Render()
