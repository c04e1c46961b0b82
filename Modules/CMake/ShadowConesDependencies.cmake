# SPDX-License-Identifier: BSD-3-Clause
# Third parties. Each is hidden behind one small Core class and stays out of installed headers.
if (NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  # Another python3 on PATH need not be the one that VTK's Python modules were built for.
  set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python interpreter")
endif ()

if (NOT SHADOWCONES_BUILD_PARAVIEW_PLUGIN)
  set(_components CommonCore CommonDataModel CommonExecutionModel CommonMath FiltersCore FiltersGeneral
    FiltersGeometry IOCore IOGeometry IOLegacy IOPLY IOXML ParallelCore RenderingCore)
  if (SHADOWCONES_WRAP_PYTHON)
    list(APPEND _components WrappingPythonCore)
  endif ()
  if (SHADOWCONES_BUILD_PROGRAM)
    list(APPEND _components FiltersSources IOCore IOImage)
  endif ()
  if (SHADOWCONES_BUILD_TESTING OR SHADOWCONES_BUILD_EXAMPLES)
    list(APPEND _components FiltersSources FiltersModeling IOImage IOImport IOGeometry IOPLY
      ImagingCore RenderingOpenGL2 InteractionStyle)
  endif ()
  find_package(VTK 9.1 REQUIRED COMPONENTS ${_components})
endif ()

# Without components PCL drags in its own VTK and Qt.
find_package(PCL 1.12 REQUIRED COMPONENTS common kdtree search QUIET)
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(OpenMesh REQUIRED)
find_package(nlohmann_json 3 REQUIRED)
find_package(embree 4 QUIET)
if (NOT embree_FOUND)
  find_package(embree 3.13 REQUIRED)
endif ()
# ERFA has no package file of CMake's.
find_path(ERFA_INCLUDE_DIR erfa.h)
find_library(ERFA_LIBRARY erfa)
mark_as_advanced(ERFA_INCLUDE_DIR ERFA_LIBRARY)
if (NOT ERFA_INCLUDE_DIR OR NOT ERFA_LIBRARY)
  message(FATAL_ERROR "ERFA was not found: install liberfa-dev, or set ERFA_INCLUDE_DIR and ERFA_LIBRARY")
endif ()
