# SPDX-License-Identifier: BSD-3-Clause
# The plugin instead of the VTK modules: ParaView brings a VTK of its own, and one build can only be for one of them.
find_package(ParaView 5.11 REQUIRED)

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/Modules/ParaViewPlugin/paraview.plugin"
  PROVIDES_PLUGINS plugins
  REQUIRES_MODULES plugin_modules
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
foreach (module IN LISTS plugin_modules)
  if (NOT TARGET "${module}")
    message(FATAL_ERROR "This ParaView has no module ${module}, which the plugin needs.")
  endif ()
endforeach ()

# Pages for ParaView's help window would need xmlpatterns of Qt 5; the panels show the same text.
paraview_plugin_build(
  PLUGINS ${plugins}
  PLUGINS_FILE_NAME "shadowcones.paraview.xml"
  DISABLE_XML_DOCUMENTATION ON)
