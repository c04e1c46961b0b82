# SPDX-License-Identifier: BSD-3-Clause
"""Whatever people have as a light: words, light sources, meshes that shine, and lists of these."""

import os

from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkTrivialProducer

from . import _classes as sc
from . import _meshes


def lights_of_words(text, up=None, north=None):
    words = sc.vtkLightWords()
    if up is not None:
        words.SetUp(*up)
    if north is not None:
        words.SetNorth(*north)
    if not words.Read(text):
        raise ValueError(words.GetError())
    return [words.GetLight(index) for index in range(words.GetNumberOfLights())]


def lights_of(light, up=None, north=None):
    """Algorithms, one a light, whose first output is that light."""
    if isinstance(light, (str, os.PathLike)):
        return lights_of_words(os.fspath(light), up, north)
    if isinstance(light, vtkAlgorithm):
        return [light]
    if isinstance(light, (list, tuple)) and not _meshes.is_pair(light):
        if not light:
            raise ValueError("the list of lights is empty")
        return [one for part in light for one in lights_of(part, up, north)]
    if light is None:
        raise TypeError('a light is needed: words such as "disc:0,5,0 radius 0.5 facing 0,-1,0", or "sun: azimuth 135 '
                        'altitude 40", a vtkAreaLightSource, or a mesh that shines')
    shining = vtkTrivialProducer()
    # A vtkDataSet whose polygons have to be found first, arrays, or what carries a light's exact shape already.
    shining.SetOutput(light if isinstance(light, vtkDataObject) and light.IsA("vtkPolyData") else _meshes.data_of(light))
    return [shining]


def connect(filter_, lights):
    """Make lights the lights of a filter."""
    filter_.RemoveAllLights()
    for light in lights:
        filter_.AddLightConnection(light.GetOutputPort())


def number_of_wavelengths(light):
    """Of a light that is up to date."""
    spectrum = light.GetOutputDataObject(0).GetFieldData().GetArray("LightSpectrum")
    return spectrum.GetNumberOfTuples() if spectrum else 7
