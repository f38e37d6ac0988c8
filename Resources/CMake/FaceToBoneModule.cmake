# Libraries of the Slicer module, under the same names in both hosts: through Slicer's macros, or static.

# facetobone_add_module_library(NAME KIND MRML|Logic CLASSES a.cxx ... [SOURCES b.cxx ...]
#   PUBLIC lib ... PRIVATE lib ...)
# CLASSES are files of one VTK class each, with a header of the same name: Slicer wraps them for Python.
function(facetobone_add_module_library name)
  cmake_parse_arguments(ARG "" "KIND" "CLASSES;SOURCES;PUBLIC;PRIVATE" ${ARGN})
  string(TOUPPER "VTK_SLICER_FACETOBONE_MODULE_${ARG_KIND}_EXPORT" directive)
  if(FACETOBONE_IN_SLICER)
    facetobone_add_slicer_library(${name} ${directive})
  else()
    facetobone_add_static_module_library(${name} ${directive})
  endif()
endfunction()

# Slicer's macros export their targets. Our own static libraries are in no export set: they are linked
# privately, into a shared library that then holds them. The macro appends libraries of its own, which
# fall under the last keyword.
macro(facetobone_add_slicer_library name directive)
  set(slicer_arguments
    NAME ${name}
    EXPORT_DIRECTIVE ${directive}
    SRCS ${ARG_CLASSES}
    TARGET_LIBRARIES PRIVATE ${ARG_PRIVATE} PUBLIC ${ARG_PUBLIC})
  if(ARG_KIND STREQUAL "MRML")
    SlicerMacroBuildModuleMRML(${slicer_arguments})
  else()
    SlicerMacroBuildModuleLogic(${slicer_arguments})
  endif()
  target_sources(${name} PRIVATE ${ARG_SOURCES})
  target_include_directories(${name} INTERFACE
    "${CMAKE_CURRENT_SOURCE_DIR}" "${CMAKE_CURRENT_BINARY_DIR}"
    ${Slicer_Libs_INCLUDE_DIRS} ${Slicer_Base_INCLUDE_DIRS} ${Slicer_ModuleMRML_INCLUDE_DIRS})
endmacro()

macro(facetobone_add_static_module_library name directive)
  add_library(${name} STATIC ${ARG_CLASSES} ${ARG_SOURCES})
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
endmacro()
