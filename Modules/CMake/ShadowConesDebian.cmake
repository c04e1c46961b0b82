# SPDX-License-Identifier: BSD-3-Clause
# Debian packages by CPack, one an install component; Utilities/debian.sh builds and tries them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME shadowcones)
set(CPACK_PACKAGE_VENDOR ShadowCones)
set(CPACK_PACKAGE_CONTACT "ShadowCones maintainers <shadowcones@localhost>")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Our own libraries are not installed while the packages are made.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(_same "libshadowcones (= ${PROJECT_VERSION})")

# One package: its component and name, whether it holds programs or libraries, what it depends on beside what these need,
# and what it is.
function (shadowcones_package component name binary depends summary)
  string(TOUPPER "${component}" upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_COMPONENTS_ALL "${CPACK_COMPONENTS_ALL}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ${binary} PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION
    "light, penumbra and umbra of meshes: ${summary}\nFrom a mesh and an area light: shadow vectors, cone sets, shadow queries, light shafts." PARENT_SCOPE)
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "share/doc/${name}" COMPONENT ${component} RENAME copyright)
endfunction ()

shadowcones_package(runtime libshadowcones ON "" "libraries")
shadowcones_package(development libshadowcones-dev OFF "${_same}, libvtk9-dev" "headers and CMake package")
if (SHADOWCONES_WRAP_PYTHON)
  shadowcones_package(python python3-shadowcones ON "${_same}, python3-vtk9, python3-numpy" "Python package")
endif ()
if (TARGET shadowcones)
  shadowcones_package(program shadowcones ON "${_same}" "the command")
endif ()
shadowcones_package(documentation shadowcones-doc OFF "" "pages and examples")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)

set(_pages "share/doc/shadowcones-doc")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/Documentation" "${PROJECT_SOURCE_DIR}/Examples" "${PROJECT_SOURCE_DIR}/Data"
  DESTINATION "${_pages}" COMPONENT documentation PATTERN __pycache__ EXCLUDE)
install(FILES "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
  DESTINATION "${_pages}" COMPONENT documentation)
include(CPack)
