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
  find_program(XVFB Xvfb)
  # The window is looked at by the system's Python, which has VTK and numpy.
  find_program(SYSTEM_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
  if (PVPYTHON_EXECUTABLE AND XVFB_RUN)
    # A screen starts anew when its last window closes, unless told otherwise: a new session would find none meanwhile.
    set(pvpython "${XVFB_RUN}" -a -s "-screen 0 1280x1024x24 -noreset" "${PVPYTHON_EXECUTABLE}")
    add_test(NAME ParaView.chair
      COMMAND ${pvpython} "${PROJECT_SOURCE_DIR}/Examples/ParaView/chair.py" --size 48
        --plugin "$<TARGET_FILE:ShadowConesParaView>" --output "${CMAKE_BINARY_DIR}/chair")
    add_test(NAME ParaView.states
      COMMAND ${pvpython} "${PROJECT_SOURCE_DIR}/Testing/ParaView/states.py"
        --plugin "$<TARGET_FILE:ShadowConesParaView>" --data "${PROJECT_SOURCE_DIR}/Data")
    add_test(NAME ParaView.macros
      COMMAND ${pvpython} "${PROJECT_SOURCE_DIR}/Testing/ParaView/macros.py"
        --plugin "$<TARGET_FILE:ShadowConesParaView>" --data "${PROJECT_SOURCE_DIR}/Data")
    set(tests ParaView.chair ParaView.states ParaView.macros)
    get_filename_component(paraview_programs "${PVPYTHON_EXECUTABLE}" DIRECTORY)
    if (XVFB AND SYSTEM_PYTHON AND EXISTS "${paraview_programs}/paraview")
      add_test(NAME ParaView.window
        COMMAND "${SYSTEM_PYTHON}" -B "${PROJECT_SOURCE_DIR}/Testing/ParaView/window.py" --paraview "${paraview_programs}"
          --plugin "$<TARGET_FILE:ShadowConesParaView>" --save "${CMAKE_BINARY_DIR}/window.png")
      list(APPEND tests ParaView.window)
    endif ()
    # ParaView reports a fault of the XML as a line of its log, and goes on.
    set_tests_properties(${tests} PROPERTIES TIMEOUT 300 FAIL_REGULAR_EXPRESSION "ERR[|]")
  else ()
    message(STATUS "No pvpython or no xvfb-run: the plugin is built and not tested")
  endif ()
endif ()
