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
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_FILE_NAME "shadowcones.paraview.xml"
  DISABLE_XML_DOCUMENTATION ON)

if (SHADOWCONES_BUILD_TESTING)
  enable_testing()
  find_program(PVPYTHON_EXECUTABLE NAMES pvpython HINTS "${ParaView_PREFIX_PATH}/bin")
  find_program(XVFB_RUN xvfb-run)
  if (PVPYTHON_EXECUTABLE AND XVFB_RUN)
    add_test(NAME ParaView.chair
      COMMAND "${XVFB_RUN}" -a -s "-screen 0 1280x1024x24" "${PVPYTHON_EXECUTABLE}"
        "${PROJECT_SOURCE_DIR}/Examples/ParaView/chair.py" --size 48
        --plugin "$<TARGET_FILE:ShadowConesParaView>" --output "${CMAKE_BINARY_DIR}/chair")
    # ParaView reports a fault of the XML as a line of its log, and goes on.
    set_tests_properties(ParaView.chair PROPERTIES TIMEOUT 300 FAIL_REGULAR_EXPRESSION "ERR[|]")
  else ()
    message(STATUS "No pvpython or no xvfb-run: the plugin is built and not tested")
  endif ()
endif ()
