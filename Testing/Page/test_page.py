#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A page as its reader meets it: opened from disk in a browser that has no network, clicked, and slid."""

import base64
import json
import os
import re
import sys
import tempfile
import unittest

import numpy as np
import shadowcones as sc
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkPlaneSource
from vtkmodules.vtkFiltersCore import vtkElevationFilter

VIEWER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Modules", "Page", "viewer")


def answers():
    """Planes at two heights, each with a value of its own everywhere."""
    for height in (0.0, 1.0):
        plane = vtkPlaneSource()
        elevation = vtkElevationFilter()
        elevation.SetInputConnection(plane.GetOutputPort())
        elevation.SetLowPoint(0, 0, -1)
        elevation.SetHighPoint(0, 0, -1 - 1e-9)
        elevation.SetScalarRange(height, height + 1e-30)
        elevation.Update()
        yield elevation.GetOutput(), f"height {height:g}"


def make_page():
    cone = vtkConeSource()
    cone.Update()
    page = sc.vtkShadowPage()
    page.SetTitle("One <cone> & two planes")
    page.AddMesh(cone.GetOutput(), "Cone </script>", 1, 0, 0)
    for data, label in answers():
        page.AddAnswer(data, "Elevation", label)
    return page


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = os.path.join(cls.folder.name, "page.html")
        assert make_page().Write(cls.path)
        options = webdriver.ChromeOptions()
        for option in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
                       "--enable-unsafe-swiftshader", "--host-resolver-rules=MAP * ~NOTFOUND", "--window-size=800,600"):
            options.add_argument(option)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        cls.browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        cls.browser.set_network_conditions(offline=True, latency=0, throughput=0)
        cls.browser.get("file://" + cls.path)
        WebDriverWait(cls.browser, 30).until(lambda browser: browser.execute_script("return document.body.dataset.ready"))

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.folder.cleanup()

    def picture(self):
        return self.browser.find_element(By.ID, "view").screenshot_as_png

    def test_console(self):
        self.assertEqual([entry for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"], [])

    def test_title(self):
        self.assertEqual(self.browser.title, "One <cone> & two planes")
        self.assertIn("Cone </script>", self.browser.find_element(By.ID, "layers").text)

    def test_switch(self):
        """A click on the switch of a layer takes it away, a second brings it back."""
        before = self.picture()
        switch = self.browser.find_element(By.CSS_SELECTOR, "#layers input")
        switch.click()
        self.assertNotEqual(self.picture(), before)
        switch.click()
        self.assertEqual(self.picture(), before)

    def test_slider(self):
        """The slider shows the other step: another label, other pixels."""
        before, label = self.picture(), self.browser.find_element(By.ID, "step").text
        slider = self.browser.find_element(By.ID, "slider")
        slider.send_keys(Keys.ARROW_RIGHT)
        self.assertEqual((label, self.browser.find_element(By.ID, "step").text), ("height 0", "height 1"))
        self.assertNotEqual(self.picture(), before)
        slider.send_keys(Keys.ARROW_LEFT)
        self.assertEqual(self.picture(), before)

    def test_legend(self):
        text = [self.browser.find_element(By.ID, name).text for name in ("quantity", "low", "high")]
        self.assertEqual(text, ["Elevation", "0", "1"])


class DataTest(unittest.TestCase):
    def test_scene(self):
        """What stands in the file is the data: points about the middle, triangles, values."""
        scene = json.loads(re.search(r'<script id="scene"[^>]*>(.*?)</script>', make_page().GetPage(), re.S)[1])
        plane = scene["steps"][1]
        points = np.frombuffer(base64.b64decode(plane["points"]), np.float32).reshape(-1, 3)
        self.assertEqual(sorted(map(tuple, points[:, :2].tolist())), [(-.5, -.5), (-.5, .5), (.5, -.5), (.5, .5)])
        triangles = np.frombuffer(base64.b64decode(plane["triangles"]), np.uint32).reshape(-1, 4)
        self.assertEqual(triangles[:, 0].tolist(), [3, 3])
        self.assertEqual(sorted(set(triangles[:, 1:].ravel().tolist())), [0, 1, 2, 3])
        self.assertEqual(np.frombuffer(base64.b64decode(plane["values"]), np.float32).tolist(), [1.0] * 4)

    def test_messages(self):
        messages = []

        def hear(caller, event, text):
            messages.append(text)

        hear.CallDataType = "string0"
        page = sc.vtkShadowPage()
        page.AddObserver("ErrorEvent", hear)
        cone = vtkConeSource()
        cone.Update()
        self.assertEqual(page.GetPage(), "")
        self.assertFalse(page.Write("nothing.html"))
        self.assertFalse(page.AddMesh(None, "a"))
        self.assertFalse(page.AddMesh(cone.GetOutput(), "a", 1, 1, 1, 0))
        self.assertFalse(page.AddCones(None))
        self.assertFalse(page.AddAnswer(cone.GetOutput(), "Visibility", "a"))
        self.assertTrue(page.AddMesh(cone.GetOutput(), "a"))
        self.assertFalse(page.Write("/nowhere/at/all.html"))
        wanted = ("nothing to write", "no points", "opacity", "no cones", "no point or cell array", "Cannot write")
        self.assertEqual(len(messages), len(wanted))
        for message, words in zip(messages, wanted):
            self.assertIn(words, message)

    def test_lock(self):
        """No registry's address in the lock file, and every version is exact."""
        with open(os.path.join(VIEWER, "package-lock.json"), encoding="utf-8") as file:
            text = file.read()
        self.assertNotIn('"resolved"', text)
        with open(os.path.join(VIEWER, "package.json"), encoding="utf-8") as file:
            about = json.load(file)
        for version in [*about["dependencies"].values(), *about["devDependencies"].values()]:
            self.assertRegex(version, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main(verbosity=2)
