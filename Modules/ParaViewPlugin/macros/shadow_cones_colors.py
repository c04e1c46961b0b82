# SPDX-License-Identifier: BSD-3-Clause
"""A macro for ParaView: the colour maps of Shadow Cones, for what is shown.

It imports the maps once, and colours the selected source by "Visibility", "ShadowClass" or "OccluderId", the first that it has.
"""

import os

from paraview import servermanager, simple

MAPS = {"Visibility": "Shadow Cones: Visibility", "ShadowClass": "Shadow Cones: Class", "OccluderId": "Shadow Cones: Occluder"}


def presets_file():
    """The file of the colour maps, which lies beside the plugin."""
    plugins = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().GetLocalInformation()
    for index in range(plugins.GetNumberOfPlugins()):
        if plugins.GetPluginName(index) == "ShadowConesParaView" and plugins.GetPluginFileName(index):
            return os.path.join(os.path.dirname(plugins.GetPluginFileName(index)), "presets", "shadow-cones.json")
    raise RuntimeError("The plugin ShadowConesParaView is not loaded")


def import_maps():
    """Add the maps to those of ParaView, once."""
    if not servermanager.vtkSMTransferFunctionPresets.GetInstance().HasPreset(MAPS["Visibility"]):
        simple.ImportPresets(presets_file())


def color(source, view):
    """Colour a source by the first array that a map is for. Returns its name, or None."""
    display = simple.Show(source, view)
    for name, preset in MAPS.items():
        for association, data in (("POINTS", source.PointData), ("CELLS", source.CellData)):
            if data.GetArray(name) is not None:
                simple.ColorBy(display, (association, name))
                colors = simple.GetColorTransferFunction(name)
                colors.ApplyPreset(preset, name == "Visibility")
                if name == "Visibility":
                    colors.RescaleTransferFunction(0.0, 1.0)
                display.SetScalarBarVisibility(view, True)
                return name
    return None


if __name__ == "__main__":
    import_maps()
    if simple.GetActiveSource() is not None:
        color(simple.GetActiveSource(), simple.GetActiveViewOrCreate("RenderView"))
        simple.Render()
