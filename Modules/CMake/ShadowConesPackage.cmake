# SPDX-License-Identifier: BSD-3-Clause
# find_package(ShadowCones) from the install tree and from the build tree.
include(CMakePackageConfigHelpers)
set(_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/shadowcones")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/ShadowConesConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${_cmake_dir}/shadowcones-config.cmake"
  INSTALL_DESTINATION "${_cmake_dir}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/${_cmake_dir}/shadowcones-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_BINARY_DIR}/${_cmake_dir}/shadowcones-config.cmake"
  "${CMAKE_BINARY_DIR}/${_cmake_dir}/shadowcones-config-version.cmake"
  DESTINATION "${_cmake_dir}" COMPONENT development)
