#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""check_paraview_xml.py finds each fault that it is there for, put into the project's own XML."""

import os
import shutil
import tempfile
import unittest

import check_paraview_xml

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")

# File, what stands in it, what is put in its place, and a word of the fault that must be found.
MUTATIONS = (
    ("Sources", 'class="vtkAreaLightSource"', 'class="vtkNothing"', "0 proxies"),
    ("Sources", 'default_values="0.533"', 'default_values="0.5"', "AngularDiameter"),
    ("Sources", 'command="SetRadius"', 'command="SetRadus"', "SetRadus"),
    ("Sources", 'text="Sphere"', 'text="Ball"', "Ball"),
    ("Sources", '<Entry value="4" text="Sun"/>', "", "Sun"),
    ("Sources", 'min="3" max="4096"', 'min="33" max="4096"', "outside"),
    ("Sources", 'property="Shape"', 'property="Form"', "Form"),
    ("Sources", 'name="sources"', 'name="filters"', "group"),
    ("Filters", '<Entry value="2" text="Box"/>', '<Entry value="3" text="Box"/>', "Box should be 2"),
    ("Filters", 'name="PhotonPaths" command="SetInputConnection" port_index="1"',
     'name="PhotonPaths" command="SetInputConnection" port_index="0"', "inputs for ports"),
    ("Filters", '<OutputPort name="Photon Paths" index="1"/>', "", "output ports"),
    ("Filters", 'name="Light"', 'name="Lamp"', "Lamp"),
    ("Imaging", 'number_of_elements="2" default_values="256 256"', 'number_of_elements="1" default_values="256 256"',
     "number_of_elements should be 2"),
    ("Imaging", 'command="SetViewAngle" number_of_elements="1" default_values="30"',
     'command="SetViewAngle" number_of_elements="1" default_values="20"', "vtkCamera"),
    ("Imaging", 'command="SetSeed"', 'command="SetMode"', "SetSeed"),
    ("Words", '<Property name="OpticalDepth"/>', "", "stands in no group"),
    ("Words", 'Camera (resolution in pixels)', "Camera", "says pixel"),
    ("Sources", 'label="Latitude (°)"', "", "says °"),
    ("Sources", 'label="Latitude (°)"', 'label="Latitude (degrees, °)"', "by its label"),
    ("Imaging", 'category="Shadow Cones"', 'category="Filters"', "another category"),
    ("Filters", '<Property name="LabelBy"/>', '<Property name="LabelBy"/><Property name="LabelFor"/>', "LabelFor"),
)


class TestParaViewXml(unittest.TestCase):
    def faults(self, changed=None, old="", new=""):
        with tempfile.TemporaryDirectory() as root:
            for module in ("Sources", "Filters", "Imaging", "Words"):
                os.makedirs(os.path.join(root, "Modules", module))
                path = f"Modules/{module}/CMakeLists.txt"
                shutil.copy(os.path.join(ROOT, path), os.path.join(root, path))
            os.makedirs(os.path.join(root, "Modules", "ParaViewPlugin"))
            for module in ("Sources", "Filters", "Imaging", "Words"):
                path = f"Modules/ParaViewPlugin/ShadowCones{module}.xml"
                with open(os.path.join(ROOT, path), encoding="utf-8") as stream:
                    content = stream.read()
                if module == changed:
                    self.assertIn(old, content)
                    content = content.replace(old, new)
                with open(os.path.join(root, path), "w", encoding="utf-8") as stream:
                    stream.write(content)
            return list(check_paraview_xml.faults(root))

    def test_mutations(self):
        before = set(self.faults())
        for module, old, new, word in MUTATIONS:
            with self.subTest(old):
                found = set(self.faults(module, old, new)) - before
                self.assertTrue(any(word in fault for fault in found), found)


if __name__ == "__main__":
    unittest.main()
