# SPDX-License-Identifier: BSD-3-Clause
# The Python package 'shadowcones': every wrapped class under one name.
set(_package_dir "lib/python3/dist-packages")
vtk_module_wrap_python(
  MODULES ShadowCones::Sources ShadowCones::Filters ShadowCones::Imaging
  TARGET ShadowConesPythonWrapped
  PYTHON_PACKAGE "shadowcones"
  MODULE_DESTINATION "${_package_dir}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/shadowcones"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INSTALL_HEADERS OFF
  BUILD_STATIC OFF)

configure_file("${CMAKE_CURRENT_LIST_DIR}/__init__.py.in"
  "${CMAKE_BINARY_DIR}/${_package_dir}/shadowcones/__init__.py" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/${_package_dir}/shadowcones/__init__.py"
  DESTINATION "${_package_dir}/shadowcones")
