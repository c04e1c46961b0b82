# SPDX-License-Identifier: BSD-3-Clause
# How a program of tests is put together: its files in batches, what all of them read precompiled, its suites as tests of CTest.

# Most of the time that a test's file takes is that of reading what it includes: the result is files that compile five each. The debug
# build reads each file alone, and so finds a missing include.
function (batch_files result program)
  if (NOT SHADOWCONES_BATCH_TESTS)
    set(${result} ${ARGN} PARENT_SCOPE)
    return()
  endif ()
  set(batches)
  list(LENGTH ARGN count)
  foreach (first RANGE 0 ${count} 5)
    if (first LESS count)
      list(SUBLIST ARGN ${first} 5 members)
      set(batch "${CMAKE_CURRENT_BINARY_DIR}/${program}/batch-${first}.cxx")
      add_custom_command(OUTPUT "${batch}"
        COMMAND "${CMAKE_COMMAND}" "-Dbatch=${batch}" "-Dmembers=${members}" -P "${PROJECT_SOURCE_DIR}/Testing/WriteBatch.cmake"
        DEPENDS ${members} "${PROJECT_SOURCE_DIR}/Testing/WriteBatch.cmake"
        VERBATIM)
      list(APPEND batches "${batch}")
    endif ()
  endforeach ()
  # A fixture in a nameless namespace is right in a file that is included once.
  if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set_source_files_properties(${batches} PROPERTIES COMPILE_OPTIONS "-Wno-subobject-linkage")
  endif ()
  set(${result} ${batches} PARENT_SCOPE)
endfunction ()

# What nearly every test includes is read once for all programs, and once for those of Core, which know no data sets. The few files
# of a program that is named before these do without.
function (precompile_tests program)
  set(standard_headers <algorithm> <array> <cmath> <functional> <gtest/gtest.h> <map> <memory> <sstream> <string> <vector>)
  if (program STREQUAL "TestShadowConesCore")
    target_precompile_headers(${program} PRIVATE ${standard_headers})
  elseif (program STREQUAL "TestShadowConesData")
    target_precompile_headers(${program} PRIVATE ${standard_headers} <vtkCellArray.h> <vtkCellData.h> <vtkDoubleArray.h> <vtkFieldData.h>
      <vtkFloatArray.h> <vtkImageData.h> <vtkInformation.h> <vtkIntArray.h> <vtkMultiBlockDataSet.h> <vtkNew.h> <vtkPointData.h>
      <vtkPolyData.h> <vtkSmartPointer.h> <vtkSphereSource.h> <vtkStreamingDemandDrivenPipeline.h>)
  elseif (TARGET TestShadowConesData)
    target_precompile_headers(${program} REUSE_FROM TestShadowConesData)
  endif ()
endfunction ()

# A process loads the libraries of VTK, which takes longer than most tests: each suite is one.
function (add_suites program prefix)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${program}/suites.cmake")
  if (NOT EXISTS "${output}")
    file(WRITE "${output}" "add_test(${program}_NOT_BUILT ${program}_NOT_BUILT)\n")
  endif ()
  add_custom_command(TARGET ${program} POST_BUILD
    COMMAND "${CMAKE_COMMAND}" "-Dprogram=$<TARGET_FILE:${program}>" "-Dprefix=${prefix}" "-Dtimeout=${test_timeout}"
      "-Doutput=${output}" -P "${PROJECT_SOURCE_DIR}/Testing/ListSuites.cmake"
    VERBATIM)
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${output}")
endfunction ()

# The program ${program} of the files given; in CTest each of its suites is ${name}.<suite>.
function (add_test_program program name)
  batch_files(sources ${program} ${ARGN})
  add_executable(${program} ${sources})
  target_link_libraries(${program} PRIVATE GTest::gtest_main)
  precompile_tests(${program})
  add_suites(${program} "${name}.")
endfunction ()
