#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The chain as users write it, with the names that their scripts rely on, and the arrays that they then read."""

import os
import unittest

import numpy as np
import shadowcones as sc
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkCamera

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.environ.get("SHADOWCONES_DATA_DIR", os.path.join(HERE, "..", "..", "Data"))
FLOAT, INT = np.float32, np.int32


def read(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(DATA, name + ".vtp"))
    reader.Update()
    return reader.GetOutput()


class Script(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        mesh = read("chair")
        camera = vtkCamera()
        camera.SetPosition(0, 2.75, 12.5)
        camera.SetFocalPoint(0, 2.75, 0)

        light = sc.vtkAreaLightSource()
        light.SetShapeToDisc(); light.SetCenter(0, 5.49, 0); light.SetNormal(0, -1, 0); light.SetRadius(0.5)
        light.SetRadiance(1.0)

        occluders = sc.vtkLabelOccluders(); occluders.SetInputData(mesh)

        vectors = sc.vtkShadowVectorFilter()
        vectors.SetInputConnection(occluders.GetOutputPort()); vectors.SetLightConnection(light.GetOutputPort())
        vectors.SetTargetNumberOfVectors(5800)
        vectors.SetStorageToHitPoint(); vectors.SetSeed(1)

        cones = sc.vtkConeSetFilter()
        cones.SetInputConnection(vectors.GetOutputPort(0)); cones.SetPhotonPathConnection(vectors.GetOutputPort(1))
        cones.SetTuningToManual(); cones.SetNumberOfNeighbors(100); cones.SetNumberOfSectors(20)
        cones.SetPointsPerRing(16); cones.SetMinimumVectorsPerCone(20)
        cones.SetVarianceThreshold(1.6); cones.SetExpansionToMaximumDeviation(); cones.SetExpansionFraction(1.0)
        cones.SetOverlap(False)

        image = sc.vtkScatteringImageFilter()
        image.SetInputConnection(occluders.GetOutputPort()); image.SetLightConnection(light.GetOutputPort())
        image.SetConeSetConnection(cones.GetOutputPort())
        image.SetCamera(camera); image.SetResolution(24, 20); image.SetModeToMedium()
        image.SetSigmaS(0.12); image.SetSigmaA(0.0)
        image.SetPhaseFunctionToIsotropic(); image.SetMediumBounds(-2.75, 2.75, 0, 5.2, -2.75, 2.75)
        image.SetNumberOfLightSamples(16); image.SetSeed(1)
        image.Update()

        volume = sc.vtkVisibilityVolume(); volume.SetInputConnection(cones.GetOutputPort())
        volume.SetLightConnection(light.GetOutputPort()); volume.SetMeshConnection(occluders.GetOutputPort())
        volume.SetDimensions(33, 33, 33); volume.SetBounds(-2.75, 2.75, 0, 5.2, -2.75, 2.75)

        cls.light, cls.occluders, cls.vectors, cls.cones, cls.image = light, occluders, vectors, cones, image
        cls.volume = volume

    def check(self, data, tuples, arrays):
        for name, kind, components in arrays:
            with self.subTest(name):
                self.assertTrue(data.HasArray(name), "is missing")
                values = vtk_to_numpy(data.GetArray(name))
                self.assertEqual(values.shape, (tuples, components) if components > 1 else (tuples,))
                self.assertTrue(np.issubdtype(values.dtype, kind), values.dtype)
                self.assertTrue(np.isfinite(values).all())

    def test_light(self):
        field = self.light.GetOutput().GetFieldData()
        self.assertEqual(field.GetArray("LightShape").GetValue(0), 0)
        self.assertEqual(field.GetArray("LightCenter").GetTuple3(0), (0.0, 5.49, 0.0))
        self.assertEqual(field.GetArray("LightRadius").GetValue(0), 0.5)
        self.assertEqual(field.GetArray("LightSpectrum").GetNumberOfTuples(), 7)
        self.assertTrue(field.HasArray("LightNormal") and field.HasArray("LightAxes"))

    def test_occluders(self):
        output = self.occluders.GetOutput()
        self.check(output.GetCellData(), 324, [("OccluderId", INT, 1)])
        self.assertEqual(set(vtk_to_numpy(output.GetCellData().GetArray("OccluderId"))), set(range(27)))

    def test_shadow_vectors(self):
        output = self.vectors.GetOutput(0)
        count = output.GetNumberOfPoints()
        self.assertGreaterEqual(count, 5800)
        self.assertLess(count, 5850)
        self.check(output.GetPointData(), count, [
            ("Direction", FLOAT, 3), ("Normal", FLOAT, 3), ("OccluderId", INT, 1), ("EmissionPoint", np.floating, 3),
            ("PathLength", FLOAT, 1), ("Thickness", FLOAT, 1), ("PhotonIndex", np.int64, 1)])
        directions = vtk_to_numpy(output.GetPointData().GetArray("Direction"))
        self.assertTrue(np.allclose(np.linalg.norm(directions, axis=1), 1.0, atol=1e-5))
        self.assertTrue((directions[:, 1] < 0.0).all())

    def test_photon_paths(self):
        output = self.vectors.GetOutput(1)
        self.check(output.GetPointData(), output.GetNumberOfPoints(), [
            ("PathState", INT, 1), ("OccluderId", INT, 1), ("EmissionPoint", np.floating, 3), ("Direction", FLOAT, 3),
            ("Power", FLOAT, 1)])
        state = vtk_to_numpy(output.GetPointData().GetArray("PathState"))
        occluder = vtk_to_numpy(output.GetPointData().GetArray("OccluderId"))
        self.assertEqual(set(state), {0, 1})
        self.assertTrue(((state == 1) == (occluder >= 0)).all())

    def test_cone_set(self):
        output = self.cones.GetOutput(0)
        count = output.GetNumberOfPoints()
        self.assertGreater(count, 20)
        self.check(output.GetPointData(), count, [
            ("Axis", FLOAT, 3), ("BaseRadius", FLOAT, 1), ("HalfAngle", FLOAT, 1), ("InnerHalfAngle", FLOAT, 1),
            ("Normal", FLOAT, 3), ("OccluderId", INT, 1), ("VectorCount", INT, 1), ("Planarity", FLOAT, 1),
            ("Overspill", FLOAT, 1)])
        # Leftovers get cones of their own, however few they are.
        self.assertTrue((vtk_to_numpy(output.GetPointData().GetArray("VectorCount")) >= 1).all())
        self.assertEqual(output.GetFieldData().GetArray("NumberOfDiscarded").GetTuple1(0), 0)
        self.assertEqual(output.GetFieldData().GetArray("NumberOfNeighbors").GetTuple1(0), 100)
        self.assertEqual(output.GetFieldData().GetArray("ExpansionFraction").GetTuple1(0), 1.0)

    def test_labelled_vectors(self):
        output = self.cones.GetOutput(1)
        self.assertEqual(output.GetNumberOfPoints(), self.vectors.GetOutput(0).GetNumberOfPoints())
        ids = vtk_to_numpy(output.GetPointData().GetArray("ConeId"))
        self.assertEqual(set(ids) - {-1}, set(range(self.cones.GetOutput(0).GetNumberOfPoints())))

    def test_image(self):
        output = self.image.GetOutput()
        self.assertEqual(output.GetDimensions(), (24, 20, 1))
        self.check(output.GetPointData(), 480, [
            ("Radiance", FLOAT, 7), ("InScattering", FLOAT, 7), ("SurfaceRadiance", FLOAT, 7),
            ("Transmittance", FLOAT, 7), ("Depth", FLOAT, 1), ("RelativeError", FLOAT, 1),
            ("SampleCount", INT, 1), ("RGB", np.uint8, 3)])
        self.assertEqual(output.GetPointData().GetScalars().GetName(), "RGB")
        self.assertGreater(output.GetFieldData().GetArray("NumberOfOcclusionRays").GetTuple1(0), 0)
        self.assertTrue((vtk_to_numpy(output.GetPointData().GetArray("InScattering")) >= 0.0).all())

    def test_spectra(self):
        self.light.SetRadianceSpectrum(2, 5.0)
        self.light.Update()
        self.assertEqual(vtk_to_numpy(self.light.GetOutput().GetFieldData().GetArray("LightSpectrum")).tolist(),
                         [1.0, 1.0, 5.0, 1.0, 1.0, 1.0, 1.0])
        self.light.SetRadiance(1.0)
        self.image.SetSigmaSSpectrum(6, 0.5)
        self.image.SetSigmaASpectrum(0, 0.5)
        self.image.Update()
        transmittance = vtk_to_numpy(self.image.GetOutput().GetPointData().GetArray("Transmittance")).min(axis=0)
        self.assertTrue((transmittance[[0, 6]] < transmittance[3]).all())
        self.image.SetSigmaS(0.12)
        self.image.SetSigmaA(0.0)

    def test_data_instead_of_connections(self):
        image = sc.vtkScatteringImageFilter()
        image.SetInputData(self.occluders.GetOutput())
        image.SetLightData(self.light.GetOutput())
        image.SetConeSetData(self.cones.GetOutput())
        image.SetCamera(self.image.GetCamera())
        image.SetResolution(24, 20)
        image.SetModeToMedium()
        image.SetSigmaS(0.12)
        image.SetMediumBounds(-2.75, 2.75, 0, 5.2, -2.75, 2.75)
        image.Update()
        self.image.Update()
        for name in ("Radiance", "InScattering", "RGB"):
            self.assertTrue(np.array_equal(vtk_to_numpy(image.GetOutput().GetPointData().GetArray(name)),
                                           vtk_to_numpy(self.image.GetOutput().GetPointData().GetArray(name))), name)

    def test_modes(self):
        self.image.SetModeToBruteForce()
        self.image.Update()
        brute = vtk_to_numpy(self.image.GetOutput().GetPointData().GetArray("InScattering")).mean()
        self.image.SetModeToFast()
        self.image.Update()
        fast = vtk_to_numpy(self.image.GetOutput().GetPointData().GetArray("InScattering")).mean()
        self.image.SetModeToMedium()
        self.assertGreater(brute, 0.0)
        self.assertLess(fast, brute)

    def test_faster_modes(self):
        def medium_term():
            self.image.Update()
            return vtk_to_numpy(self.image.GetOutput().GetPointData().GetArray("InScattering")).mean(axis=1)

        self.image.SetModeToBruteForce()
        brute = medium_term()
        self.image.SetModeToGuided(); self.image.SetRelativeErrorGoal(0.01)
        guided = medium_term()
        goal = self.image.GetOutput().GetFieldData().GetArray("RelativeErrorGoal").GetTuple1(0)
        self.image.SetVisibilityVolumeConnection(self.volume.GetOutputPort()); self.image.SetModeToVolume()
        volume = medium_term()
        self.image.SetModeToSoft(); self.image.SetSoftDimensions(17, 17, 17)
        soft = medium_term()
        self.image.SetModeToMedium()
        self.image.Update()
        self.assertEqual(goal, 0.01)
        for name, values, bound in (("Guided", guided, 0.03), ("Volume", volume, 0.03), ("Soft", soft, 0.1)):
            with self.subTest(name):
                self.assertLess(np.sqrt(((values - brute)**2).mean()) / brute.mean(), bound)

    def test_density(self):
        def mean(density):
            self.image.SetDensityData(density)
            self.image.Update()
            return vtk_to_numpy(self.image.GetOutput().GetPointData().GetArray("InScattering")).mean()

        thin = vtkImageData()
        thin.SetDimensions(2, 2, 2)
        thin.SetOrigin(-2.75, 0.0, -2.75)
        thin.SetSpacing(5.5, 5.2, 5.5)
        thin.AllocateScalars(VTK_FLOAT, 1)
        thin.GetPointData().GetScalars().Fill(0.1)
        less = mean(thin)
        even = mean(None)
        self.assertGreater(less, 0.1 * even)  # less light is lost on the way
        self.assertLess(less, 0.3 * even)

    def test_blocks_are_occluders(self):
        blocks = vtkMultiBlockDataSet()
        for index in range(3):
            plane = vtkPlaneSource()
            plane.SetCenter(0.0, 0.0, index)
            plane.Update()
            blocks.SetBlock(index, plane.GetOutput())
        occluders = sc.vtkLabelOccluders()
        occluders.SetInputData(blocks)
        occluders.Update()
        ids = vtk_to_numpy(occluders.GetOutput().GetCellData().GetArray("OccluderId"))
        self.assertEqual(ids.tolist(), [0, 0, 1, 1, 2, 2])

    def test_exposure(self):
        said = []

        @calldata_type(VTK_STRING)
        def collect(caller, event, text):
            said.append(f"{event}: {text}")

        image = sc.vtkScatteringImageFilter()
        image.SetInputConnection(self.occluders.GetOutputPort()); image.SetLightConnection(self.light.GetOutputPort())
        image.SetResolution(8, 8); image.SetModeToBruteForce()
        image.AddObserver("WarningEvent", collect)
        image.Update()
        radiance = image.GetOutput().GetPointData().GetArray("Radiance")
        found = image.GetOutput().GetFieldData().GetArray("Exposure").GetValue(0)
        self.assertEqual(said, [])
        image.SetExposure(0.5 * found)
        image.Update()
        self.assertEqual(len(said), 1)
        self.assertIn("but AutoExposure is on and finds its own: call AutoExposureOff() to use it", said[0])
        image.AutoExposureOff()
        image.Update()
        self.assertEqual(image.GetOutput().GetFieldData().GetArray("Exposure").GetValue(0), 0.5 * found)
        self.assertIs(image.GetOutput().GetPointData().GetArray("Radiance"), radiance)  # nothing was rendered anew

        picture = sc.vtkToneMapRadiance(); picture.SetInputData(image.GetOutput())
        picture.Update()
        self.assertEqual(picture.GetOutput().GetFieldData().GetArray("Exposure").GetValue(0), found)
        self.check(picture.GetOutput().GetPointData(), 64, [("RGB", np.uint8, 3)])

    def test_a_prepared_scene_is_handed_on(self):
        first, second = sc.vtkScatteringImageFilter(), sc.vtkScatteringImageFilter()
        second.SetPreparedScene(first.GetPreparedScene())
        for image in (first, second):
            image.SetInputConnection(self.occluders.GetOutputPort())
            image.SetLightConnection(self.light.GetOutputPort())
            image.SetResolution(6, 4)
            image.Update()
        self.assertGreater(first.GetNumberOfPreparations(), 0)
        self.assertEqual(second.GetNumberOfPreparations(), 0)
        self.assertGreater(second.GetPreparedMemory(), 0)
        self.assertEqual(*[vtk_to_numpy(image.GetOutput().GetPointData().GetArray("Radiance")).tobytes()
                           for image in (first, second)])
        del first
        second.SetResolution(8, 4)
        second.Update()
        self.assertEqual(second.GetNumberOfPreparations(), 0)
        second.ReleasePreparedScene()
        self.assertEqual(second.GetPreparedMemory(), 0)

    def test_pictures_of_rising_quality(self):
        image = sc.vtkScatteringImageFilter()
        image.SetInputConnection(self.occluders.GetOutputPort()); image.SetLightConnection(self.light.GetOutputPort())
        image.SetResolution(32, 24); image.SetModeToBruteForce(); image.ProgressiveOn()
        sizes = []
        image.AddObserver("UpdateDataEvent", lambda caller, event: sizes.append(caller.GetPicture().GetDimensions()))
        image.Update()
        self.assertEqual(sizes, [(32, 24, 1)])
        self.assertEqual(image.GetPicture().GetPointData().GetArray("RGB").GetNumberOfTuples(), 32 * 24)

    def test_a_fault_is_said_and_survived(self):
        said = []

        @calldata_type(VTK_STRING)
        def collect(caller, event, text):
            said.append(f"{event}: {text}")

        image = sc.vtkScatteringImageFilter()
        image.SetInputConnection(self.occluders.GetOutputPort())
        image.SetLightConnection(self.light.GetOutputPort())
        image.SetModeToMedium()
        image.SetResolution(4, 4)
        for speaker in (image, image.GetExecutive()):
            speaker.AddObserver("ErrorEvent", collect)
            speaker.AddObserver("WarningEvent", collect)
        image.Update()
        self.assertTrue(said[0].startswith("ErrorEvent: ") and "connect a vtkConeSetFilter" in said[0], said)
        self.assertEqual(image.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main()
