# SPDX-License-Identifier: BSD-3-Clause
# The Python package 'shadowcones': every wrapped class under one name.
set(_package_dir "lib/python3/dist-packages")
vtk_module_wrap_python(
  MODULES ShadowCones::Sources ShadowCones::Filters ShadowCones::Imaging ShadowCones::Words ShadowCones::Page
  TARGET ShadowConesPythonWrapped
  PYTHON_PACKAGE "shadowcones"
  MODULE_DESTINATION "${_package_dir}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/shadowcones"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INSTALL_HEADERS OFF
  BUILD_STATIC OFF)
# What is generated mostly reads headers, and calls more than it computes: several files are compiled at once, with less care.
foreach (_module IN ITEMS Sources Filters Imaging Words Page)
  set_target_properties(ShadowCones${_module}Python PROPERTIES UNITY_BUILD ON)
  target_compile_options(ShadowCones${_module}Python PRIVATE "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:-O1>")
  # Tables of types that VTK's wrapper writes end before the last fields of newer Pythons.
  target_compile_options(ShadowCones${_module}Python PRIVATE "$<$<CXX_COMPILER_ID:GNU,Clang>:-Wno-missing-field-initializers>")
endforeach ()

# Beside the wrapped classes: the helpers, each for one purpose, with their types.
set(_source_dir "${PROJECT_SOURCE_DIR}/Modules/Python")
set(_built_dir "${CMAKE_BINARY_DIR}/${_package_dir}/shadowcones")
# Types of the wrapped classes: VTK 9.1 writes none.
file(GLOB _headers CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/Modules/Sources/vtk*.h" "${PROJECT_SOURCE_DIR}/Modules/Filters/vtk*.h"
  "${PROJECT_SOURCE_DIR}/Modules/Imaging/vtk*.h" "${PROJECT_SOURCE_DIR}/Modules/Words/vtk*.h"
  "${PROJECT_SOURCE_DIR}/Modules/Page/vtk*.h")
set(_class_stubs)
foreach (_header IN LISTS _headers)
  get_filename_component(_class "${_header}" NAME_WE)
  string(APPEND _class_stubs "class ${_class}(_Wrapped): ...\n")
endforeach ()
configure_file("${_source_dir}/__init__.py.in" "${_built_dir}/__init__.py" @ONLY)
configure_file("${_source_dir}/__init__.pyi.in" "${_built_dir}/__init__.pyi" @ONLY)
file(GLOB _sources CONFIGURE_DEPENDS RELATIVE "${_source_dir}"
  "${_source_dir}/*.py" "${_source_dir}/py.typed")
foreach (_source IN LISTS _sources)
  configure_file("${_source_dir}/${_source}" "${_built_dir}/${_source}" COPYONLY)
endforeach ()
list(TRANSFORM _sources PREPEND "${_built_dir}/")
install(FILES "${_built_dir}/__init__.py" "${_built_dir}/__init__.pyi" ${_sources}
  DESTINATION "${_package_dir}/shadowcones" COMPONENT python)
