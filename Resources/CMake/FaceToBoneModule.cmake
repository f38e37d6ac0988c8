# Libraries of the Slicer module, under the same names in both hosts: through Slicer's macros, or static.

# facetobone_add_module_library(NAME KIND MRML|Logic SOURCES a.cxx ... PUBLIC lib ... PRIVATE lib ...)
function(facetobone_add_module_library name)
  cmake_parse_arguments(ARG "" "KIND" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  string(TOUPPER "VTK_SLICER_FACETOBONE_MODULE_${ARG_KIND}_EXPORT" directive)
  add_library(${name} STATIC ${ARG_SOURCES})
  set(MODULE_EXPORT_DIRECTIVE ${directive})
  configure_file("${PROJECT_SOURCE_DIR}/Resources/CMake/StaticExport.h.in"
    "${CMAKE_CURRENT_BINARY_DIR}/${name}Export.h" @ONLY)
  target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}" "${CMAKE_CURRENT_BINARY_DIR}")
  # system, as VTK's macros in our headers are not pedantic
  target_include_directories(${name} SYSTEM INTERFACE
    "${CMAKE_CURRENT_SOURCE_DIR}" "${CMAKE_CURRENT_BINARY_DIR}")
  facetobone_warnings(${name})
  target_compile_options(${name} PRIVATE -Wno-pedantic)
endfunction()
