# How FaceToBone's targets are made: one library function, one test function, one set of warnings.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release or RelWithDebInfo" FORCE)
endif()

find_program(FACETOBONE_CCACHE ccache)
if(FACETOBONE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${FACETOBONE_CCACHE}")
endif()

set(FACETOBONE_SANITIZE "" CACHE STRING "Sanitizers for every target, such as address,undefined")
if(FACETOBONE_SANITIZE)
  add_compile_options(-fsanitize=${FACETOBONE_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=undefined)
  add_link_options(-fsanitize=${FACETOBONE_SANITIZE})
endif()

function(facetobone_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
  if(NOT FACETOBONE_IN_SLICER) # whose compiler and headers are another's
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# facetobone_add_library(NAME SOURCES a.cpp ... PUBLIC lib ... PRIVATE lib ...)
# Headers are included from Logic/, as <Core/mesh/mixed_mesh.hpp>.
function(facetobone_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC "${PROJECT_SOURCE_DIR}/Logic")
  # Eigen's own threads would sum a large product in an order that depends on their number
  target_compile_definitions(${name} PUBLIC EIGEN_DONT_PARALLELIZE)
  target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  facetobone_warnings(${name})
endfunction()

# Tests share the cores, one thread each: two threads that wait for each other at every short loop are
# many times slower than one as soon as another program wants a core. Those on threads set their own.
set(facetobone_test_environment OMP_NUM_THREADS=1)

# facetobone_add_test(NAME SOURCES a.cpp ... LINK lib ... [TIMEOUT s])
# One GoogleTest program; each of its tests is a CTest test.
function(facetobone_add_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINK" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gtest_main)
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/Testing")
  facetobone_warnings(${name})
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST
    PROPERTIES TIMEOUT ${ARG_TIMEOUT} ENVIRONMENT ${facetobone_test_environment})
endfunction()
