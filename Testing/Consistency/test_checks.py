#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each check finds the fault that it is there for, and nothing in a tree without faults."""

import os
import sys
import tempfile
import types
import unittest
from unittest import mock

import check_classes
import check_core_includes
import check_data
import check_defaults
import check_help
import check_house
import check_installed_headers
import check_licence
import check_links
import check_messages
import check_named_paths
import check_paths
import check_presets
import check_rooms
import check_snippets
import check_version
import count_duplicates
import house_numbers
import numpy as np
import sourcetree
from vtkmodules.util.numpy_support import numpy_to_vtk

sys.path.append(os.path.join(sourcetree.ROOT, "Utilities"))
import compare_builds  # noqa: E402: lies where users look for it

LICENCE = "// SPDX-License-Identifier: BSD-3-Clause\n"
CMAKE = "# SPDX-License-Identifier: BSD-3-Clause\n"

SOUND = {
    "Modules/Core/CMakeLists.txt": CMAKE + "set(headers Base/scRay.h)\nadd(HEADERS ${headers} PRIVATE_HEADERS Mesh/scInside.h)",
    "Modules/Core/README.md": "| room | may include | what |\n|---|---|---|\n| Base | | a |\n| Mesh | Base | b |\n"
                              "| Cones | Base | c |\n",
    "Modules/Core/Base/scRay.h": LICENCE + '#include "vtkType.h"\n',
    "Modules/Core/Mesh/scInside.h": LICENCE + '#include <embree3/rtcore.h>\n#include "scRay.h"\n',
    "Modules/Core/Cones/scCone.cxx": LICENCE + '#include "scRay.h"\n',
    "Modules/Filters/CMakeLists.txt": CMAKE + "set(classes\n  vtkThing)\n",
    "Modules/Filters/vtkThing.h": LICENCE + '#include "vtkPolyDataAlgorithm.h"\n',
    "Modules/Filters/Testing/Cxx/TestThing.cxx": LICENCE + '#include "vtkThing.h"\n',
    "Modules/ParaViewPlugin/Filters.xml": '<!-- SPDX-License-Identifier: BSD-3-Clause -->\n<Proxy class="vtkThing"/>\n',
    "Documentation/README.md": "[vtkThing](filters/vtkThing.md)\n",
    "Documentation/3-paraview.md": "| Thing | [vtkThing](filters/vtkThing.md) | Output |\n",
    "Documentation/filters/vtkThing.md": "Runs /usr/bin/python3 in ${HOME}/" + "work.\n",
    "Examples/Python/thing.py": CMAKE + "vtkThing()\n",
    "CHANGELOG.md": "`vtkThing`\n",
    "CMakeLists.txt": CMAKE + "project(Thing VERSION 1.2.0)\n",
}

HEADER = LICENCE + """
class vtkThing
{
  enum KindType
  {
    LARGE_KIND = 2
  };
  ///@{
  /// How much, above 0. Default 0.5.
  vtkSetMacro(Amount, double);
  ///@}
  ///@{
  /**
   * Which kind. Default: Large.
   */
  vtkSetMacro(Kind, int);
  void SetKindToLarge() { this->SetKind(LARGE_KIND); }
  ///@}
  ///@{
  /// Where. Default (0, 1).
  vtkSetVector2Macro(Place, double);
  ///@}
private:
  double Amount = 0.5;
  int Kind = LARGE_KIND;
  double Place[2] = { 0.0, 1.0 };
};
"""
XML = """<!-- SPDX-License-Identifier: BSD-3-Clause -->
<Proxy class="vtkThing"><A command="SetKind" default_values="2"/><A command="SetPlace" default_values="0 1"/></Proxy>
"""


class Thing:
    def GetAmount(self):
        return 0.5

    def GetKind(self):
        """GetKind(self) -> int
        C++: virtual int GetKind()

        2 Large.
        """
        return 2

    def GetPlace(self):
        return (0.0, 1.0)


CHECKS = (check_classes, check_core_includes, check_house, check_installed_headers, check_licence, check_links,
          check_named_paths, check_paths, check_rooms)


class TestChecks(unittest.TestCase):
    def faults(self, check, changes):
        with tempfile.TemporaryDirectory() as root:
            for path, content in {**SOUND, **changes}.items():
                if content is not None:
                    os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
                    with open(os.path.join(root, path), "w", encoding="utf-8") as stream:
                        stream.write(content)
            return list(check.faults(root))

    def test_sound_tree(self):
        for check in CHECKS:
            self.assertEqual(self.faults(check, {}), [], check.__name__)

    def test_core_includes(self):
        for name in ("vtkPolyData.h", "vtkInformation.h", "vtkAlgorithm.h"):
            changes = {"Modules/Core/Base/scRay.h": LICENCE + f'#include "{name}"\n'}
            self.assertEqual(len(self.faults(check_core_includes, changes)), 1, name)

    def test_core_tests(self):
        test, support = "Modules/Core/Testing/Cxx/Mesh/TestInside.cxx", "Testing/Support/"
        sound = {test: LICENCE + '#include "TestMeshes.h"\n#include "vtkSMPTools.h"\n',
                 support + "TestMeshes.h": LICENCE + '#include "scRay.h"\n',
                 support + "TestPolyData.h": LICENCE + '#include "vtkPolyData.h"\n'}
        self.assertEqual(self.faults(check_core_includes, sound), [])
        through = {support + "TestMeshes.h": LICENCE + '#include "TestPolyData.h"\n'}
        for changes in (through, {test: LICENCE + '#include "TestPolyData.h"\n'}):
            self.assertEqual(len(self.faults(check_core_includes, {**sound, **changes})), 1, changes)

    def test_house(self):
        path = "Modules/Core/Mesh/scInside.cxx"
        lines = "".join(f"int a{k} = {k};\n" for k in range(600))
        self.assertEqual(len(self.faults(check_house, {path: LICENCE + lines})), 1)
        self.assertEqual(self.faults(check_house, {path: LICENCE + lines[:lines.rindex("int")]}), [])
        for head in ("// One file because it is a test.\n", "/**\n * One file because it is.\n */\n"):
            self.assertEqual(self.faults(check_house, {path: LICENCE + head + lines}), [], head)
        self.assertEqual(len(self.faults(check_house, {path: LICENCE + lines + "// One file because it is.\n"})), 1)
        code = "".join(f"  a({k}); // the {k}th\n\n" for k in range(6))
        again = "/* once\n more */\n" + code.replace("  a", "a").replace("//", "/// ")
        twice = {"Modules/Core/Mesh/scInside.cxx": LICENCE + "{\n" + code + "}\n",
                 "Testing/Support/Inside.h": LICENCE + "#include <a>\n" + again}
        with mock.patch.object(check_house, "RUNS", 0):
            self.assertEqual(len(self.faults(check_house, twice)), 1)
            other = {**twice, "Testing/Support/Inside.h": again.replace("a(5)", "b(5)")}
            self.assertEqual(self.faults(check_house, other), [])
        self.assertEqual(self.faults(check_house, twice), [])

    def test_duplicates_count_every_place_once(self):
        code = "".join(f"a({k});\n" for k in range(20))
        files = {f"Testing/{name}.cxx": code for name in "abc"}
        with tempfile.TemporaryDirectory() as root:
            os.makedirs(os.path.join(root, "Testing"))
            for path, content in files.items():
                with open(os.path.join(root, path), "w", encoding="utf-8") as stream:
                    stream.write(content)
            self.assertEqual([run[0] for run in count_duplicates.duplicates(root)], [20, 20])

    def test_numbers(self):
        source = LICENCE + """
namespace a
{
struct B
{
  void One(int x, std::pair<int, int> y) const
  {
    if (x)
    {
      f(1, 2, 3);
    }
  }
  B()
    : C(1, 2)
  {
  }
};
} // namespace a

int Long(
  int a,
  int b, int c)
{
  return 1;
}
"""
        with tempfile.TemporaryDirectory() as root:
            os.makedirs(os.path.join(root, "Modules", "Core"))
            with open(os.path.join(root, "Modules", "Core", "a.cxx"), "w", encoding="utf-8") as stream:
                stream.write(source)
            found = [(lines, count) for _, _, lines, count in house_numbers.functions(root)]
        self.assertEqual(found, [(7, 2), (4, 0), (6, 3)])

    def test_named_paths(self):
        sound = {"CONTRIBUTING.md": "Look at `Modules/Core/README.md`, `Modules/Core/Base/`, `Modules/Filters/vtkNewThing.h`.\n"}
        self.assertEqual(self.faults(check_named_paths, sound), [])
        for name in ("Modules/Core/Base/scGone.h", "Testing/Nowhere"):
            self.assertEqual(len(self.faults(check_named_paths, {"CONTRIBUTING.md": f"Look at `{name}`.\n"})), 1, name)

    def test_compared_tables(self):
        table = "name     cones  fit s   error\nchair, a     3   0.25  0.1000\n# 1 pixel\n"
        other = table.replace("0.25", "9.75")
        self.assertEqual(list(compare_builds.without_columns(table, ["fit s"])),
                         list(compare_builds.without_columns(other, ["fit s"])))
        for old, new in (("0.1000", "0.1001"), ("  3", "  4"), ("1 pixel", "2 pixel")):
            self.assertNotEqual(list(compare_builds.without_columns(table, ["fit s"])),
                                list(compare_builds.without_columns(table.replace(old, new), ["fit s"])), new)

    def test_compared_figures(self):
        speed = [{"modes": [{"error": 0.5, "frame": {"seconds": 1.0, "processor_seconds": 2.0}}], "at_equal_error": [{"met": True}]}]
        other = [{"modes": [{"error": 0.5, "frame": {"seconds": 3.0, "processor_seconds": 4.0}}], "at_equal_error": []}]
        self.assertEqual(compare_builds.figures(speed), compare_builds.figures(other))
        other[0]["modes"][0]["error"] = 0.6
        self.assertNotEqual(compare_builds.figures(speed), compare_builds.figures(other))

    def test_rooms(self):
        inside, cone = "Modules/Core/Mesh/scInside.h", "Modules/Core/Cones/scCone.cxx"
        for changes in ({cone: SOUND[cone] + '#include "scInside.h"\n'},
                        {"Modules/Core/Base/scRay.h": LICENCE + '#include "scInside.h"\n'},
                        {"Modules/Core/scLoose.cxx": LICENCE},
                        {"Modules/Core/Attic/scOld.h": LICENCE},
                        {"Modules/Core/README.md": SOUND["Modules/Core/README.md"].replace("| Base | c", "| Roof | c")}):
            self.assertGreaterEqual(len(self.faults(check_rooms, changes)), 1, changes)
        self.assertEqual(self.faults(check_rooms, {inside: SOUND[inside] + '#include "scRay.h"\n'}), [])

    def test_installed_headers(self):
        for name in ("<embree4/rtcore.h>", "<Eigen/Dense>", "<pcl/types.h>", "<OpenMesh/Core.hh>", "<erfa.h>", '"scInside.h"'):
            for path in ("Modules/Core/Base/scRay.h", "Modules/Filters/vtkThing.h"):
                changes = {path: LICENCE + f"#include {name}\n"}
                self.assertEqual(len(self.faults(check_installed_headers, changes)), 1, name)
        self.assertEqual(len(self.faults(check_installed_headers, {"Modules/Core/Base/scRay.h": None})), 1)

    def test_licence(self):
        for path in ("Modules/Core/Base/scRay.h", "Modules/Core/CMakeLists.txt", "Examples/Python/a.py", "Utilities/run"):
            self.assertEqual(len(self.faults(check_licence, {path: "\n" + LICENCE})), 1, path)
        self.assertEqual(self.faults(check_licence, {"Utilities/run": "#!/bin/sh\n" + CMAKE}), [])

    def test_paths(self):
        for folder in ("/wo" "rk/main", "/ro" "ot", "'/ho" "me/a'", "cd /t" "mp"):
            self.assertEqual(len(self.faults(check_paths, {"CHANGELOG.md": f"vtkThing {folder}\n"})), 1, folder)

    def test_links(self):
        changes = {"CHANGELOG.md": "`vtkThing` ![a](b.png) [c](https://d) [e](#f)\n"}
        self.assertEqual(len(self.faults(check_links, changes)), 1)

    def test_defaults(self):
        header, xml = "Modules/Filters/vtkThing.h", "Modules/ParaViewPlugin/Filters.xml"
        sound = {header: HEADER, xml: XML}
        before = sys.modules.get("shadowcones")
        sys.modules["shadowcones"] = types.SimpleNamespace(vtkThing=Thing)
        try:
            self.assertEqual(self.faults(check_defaults, sound), [])
            for old, new in (("Default 0.5", "Default 0.6"), ("Default 0.5", "Usual 0.5"),
                             ("Default: Large", "Default: Small"), ("Default (0, 1)", "Default (0, 2)")):
                self.assertEqual(len(self.faults(check_defaults, {**sound, header: HEADER.replace(old, new)})), 1, new)
            for old, new in (('"2"', '"1"'), ('"0 1"', '"0 0"')):
                self.assertEqual(len(self.faults(check_defaults, {**sound, xml: XML.replace(old, new)})), 1, new)
            sys.modules["shadowcones"].vtkThing = type("Other", (Thing,), {"GetKind": lambda self: 1})
            self.assertEqual(len(self.faults(check_defaults, sound)), 1)
        finally:
            sys.modules["shadowcones"] = before

    def test_help(self):
        before = sys.modules.get("shadowcones")
        sys.modules["shadowcones"] = types.SimpleNamespace(vtkThing=Thing)
        try:
            bare = "GetAmount(self) -> float\nC++: virtual double\n    GetAmount()\n\n"
            for text, count in ((None, 2), (bare, 2), (bare + "How much.", 1)):
                Thing.GetAmount.__doc__ = text
                self.assertEqual(len(self.faults(check_help, {})), count, text)
        finally:
            sys.modules["shadowcones"] = before

    def test_messages(self):
        page, source = "Documentation/6-errors.md", "Modules/Filters/vtkThing.cxx"
        words = 'vtkErrorMacro("Amount of \\"thing\\" is " << x // not "in any case here"\n  << " at port 3:"\n  " lower it.");'
        sound = {source: LICENCE + words, page: '| Amount of "thing" is *x* at port *n*: lower it. | do |\n'}
        self.assertEqual(self.faults(check_messages, sound), [])
        self.assertEqual(len(self.faults(check_messages, {**sound, page: "| Amount is *x*: lower it. | do |\n"})), 2)
        self.assertEqual(len(self.faults(check_messages, {source: LICENCE + words})), 2)

    def test_presets(self):
        presets = '{"configurePresets": [{"name": "all"}, {"name": "small", "inherits": "all", "cacheVariables": %s}]}'
        page = "## Other systems\n```sh\ncmake --preset small\n```\nOr cmake --preset all\n"
        sound = {"CMakePresets.json": presets % '{"SHADOWCONES_BUILD_TESTING": "OFF"}',
                 "Documentation/1-getting-started.md": page}
        self.assertEqual(self.faults(check_presets, sound), [])
        self.assertEqual(len(self.faults(check_presets, {**sound, "CMakePresets.json": presets % "{}"})), 1)
        self.assertEqual(len(self.faults(check_presets, {**sound, "CHANGELOG.md": "`vtkThing` --preset tiny"})), 1)

    def test_version(self):
        log = "## 1.2.0 (%s)\n- `vtkThing`\n\n## 1.1.0 (2020-01-02)\n"
        sound = {"CHANGELOG.md": log % "2021-03-04", "a.md": "find_package(ShadowCones 1.2 REQUIRED)\n"}
        self.assertEqual(self.faults(check_version, sound), [])
        self.assertEqual(self.faults(check_version, {"CHANGELOG.md": log % "unreleased"}), [])
        for changes in ({"CHANGELOG.md": log % "soon"}, {"CHANGELOG.md": log.replace("1.2.0", "1.3.0") % "2021-03-04"},
                        {"CHANGELOG.md": log.replace("1.1.0", "1.2.1") % "2021-03-04"}, {"CMakeLists.txt": CMAKE + "project(A)\n"},
                        {"CHANGELOG.md": (log % "2021-03-04").replace("2020-01-02", "unreleased")},
                        {"a.md": "find_package(ShadowCones 1.1 REQUIRED)\n"}):
            self.assertGreaterEqual(len(self.faults(check_version, {**sound, **changes})), 1, changes)

    def test_exposure(self):
        def fault(values):
            return check_snippets.exposure_fault(numpy_to_vtk(np.repeat(values, 3).reshape(-1, 3).astype(np.uint8), deep=True))

        sound = np.concatenate((np.zeros(40), np.linspace(20, 255, 60)))
        self.assertIsNone(fault(sound))
        self.assertIn("mid grey", fault(0.2 * sound))
        self.assertIn("burnt out", fault(np.minimum(1.3 * sound, 255)))
        self.assertIn("are lit", fault(np.where(np.arange(100) < 90, 0, 100)))
        self.assertIn("no picture", check_snippets.exposure_fault(None))

    def test_data(self):
        made = {"points": np.array([0.0, 1.0], dtype=np.float32), "offsets": np.array([0, 3])}
        self.assertEqual(list(check_data.compare("a", made, dict(made))), [])
        for key, values in (("points", made["points"] + 1e-5), ("points", made["points"][:1]),
                            ("offsets", made["offsets"] + 1)):
            self.assertEqual(len(list(check_data.compare("a", made, {**made, key: values.astype(made[key].dtype)}))), 1)
        self.assertEqual(len(list(check_data.compare("a", made, {"points": made["points"]}))), 1)

    def test_classes(self):
        for path in SOUND:
            if path.startswith(("Documentation", "Examples", "CHANGELOG", "Modules/ParaView", "Modules/Filters/Test")):
                self.assertEqual(len(self.faults(check_classes, {path: None})), 1, path)
        twice = 2 * SOUND["Documentation/3-paraview.md"]
        self.assertEqual(len(self.faults(check_classes, {"Documentation/3-paraview.md": twice})), 1)

    def test_helpers(self):
        lists = {"Modules/Words/CMakeLists.txt": CMAKE + "set(helpers\n  vtkWords)\n",
                 "Modules/Words/vtkWords.h": LICENCE + '#include "vtkObject.h"\n'}
        self.assertEqual(len(self.faults(check_classes, lists)), 3)
        told = {**lists, "Modules/Words/Testing/Cxx/TestWords.cxx": LICENCE + '#include "vtkWords.h"\n',
                "Documentation/9-words.md": "`vtkWords`\n", "CHANGELOG.md": "`vtkThing`, `vtkWords`\n"}
        self.assertEqual(self.faults(check_classes, told), [])
        inside = {**lists, "Modules/Words/vtkWords.h": LICENCE + '#include "scInside.h"\n'}
        self.assertEqual(len(self.faults(check_installed_headers, inside)), 1)


if __name__ == "__main__":
    unittest.main()
