# SPDX-License-Identifier: BSD-3-Clause
# Build and run Examples/Consumer against the package, with only VTK to be found, and import the Python package.
set(work_dir "${build_dir}/Testing/Install/${tree}-tree")
file(REMOVE_RECURSE "${work_dir}")
file(MAKE_DIRECTORY "${work_dir}")

# Run a command; stop with what it printed where it fails, and hand its output back in 'output'.
function (run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${output}")
  endif ()
  set(output "${output}" PARENT_SCOPE)
endfunction ()

# Nothing but what the package itself carries may lead to our libraries.
unset(ENV{LD_LIBRARY_PATH})
unset(ENV{PYTHONPATH})
unset(ENV{CMAKE_PREFIX_PATH})

if (tree STREQUAL "install")
  # Moved after installing: no file of the tree may know where it was.
  set(prefix "${work_dir}/moved")
  run("Installing" "${CMAKE_COMMAND}" --install "${build_dir}" --config "${config}" --prefix "${work_dir}/prefix")
  file(RENAME "${work_dir}/prefix" "${prefix}")
  file(GLOB_RECURSE files LIST_DIRECTORIES false "${prefix}/*")
  list(LENGTH files count)
  if (count EQUAL 0)
    message(FATAL_ERROR "Nothing is installed in ${prefix}")
  endif ()
  # Sanitizers name the sources in what they report.
  if (NOT cxx_flags MATCHES "-fsanitize")
    foreach (place IN ITEMS "${source_dir}/" "${build_dir}/")
      execute_process(COMMAND grep -rlF -e "${place}" "${prefix}" OUTPUT_VARIABLE found RESULT_VARIABLE result)
      if (NOT result EQUAL 1)
        message(SEND_ERROR "${found}name ${place}, which what is installed must neither need nor tell (grep: ${result})")
      endif ()
    endforeach ()
  endif ()
else ()
  set(prefix "${build_dir}")
endif ()

# find_package() of these fails even where they are installed: a user of the package does not need them.
set(hidden PCL Eigen3 OpenMesh embree)
list(TRANSFORM hidden REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")
run("Configuring the consumer" "${CMAKE_COMMAND}"
  -S "${source_dir}/Examples/Consumer" -B "${work_dir}/consumer" -G "${generator}"
  "-DCMAKE_BUILD_TYPE=${config}" "-DCMAKE_CXX_COMPILER=${cxx_compiler}" "-DCMAKE_CXX_FLAGS=${cxx_flags}"
  "-DShadowCones_DIR=${prefix}/${package_dir}" "-DVTK_DIR=${vtk_dir}" ${hidden})
run("Building the consumer" "${CMAKE_COMMAND}" --build "${work_dir}/consumer" --config "${config}")
run("Running the consumer" "${work_dir}/consumer/consumer")
message("${output}")

if (python)
  set(ENV{PYTHONPATH} "${prefix}/lib/python3/dist-packages")
  # -B: no bytecode, so that the build tree stays as the build made it.
  run("Importing the Python package" "${python}" -B "${CMAKE_CURRENT_LIST_DIR}/check_import.py" "${prefix}")
  message("${output}")
endif ()
