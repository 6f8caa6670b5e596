# A function that makes a Python module of the objects of a schema as a part of a build.
#
#   physgen_python(TARGET name SCHEMA a.h [SOURCES b.cpp...] [OUTPUT_DIR dir] [LAYOUT layout] [CHECKED_IN dir])
#
# The library `name` is the module a, which `import a` finds where the folder that it is built in is on PYTHONPATH. It has
# a class for each object type; <physgen/python/module.h> says what a class can do. SOURCES are C++ of the program's own,
# which define physgen::python::add_functions() to give the module functions over these arrays. The other arguments are
# those of physgen_generate(), which writes a.physgen.h and a.python.cpp. pybind11 2.10 or later is needed, and the headers
# of Python (pybind11-dev and python3-dev of Debian); -DPython_EXECUTABLE=... says of which Python.
include_guard(DIRECTORY)
cmake_policy(VERSION 3.25)

function(physgen_python)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;SCHEMA;OUTPUT_DIR;LAYOUT;CHECKED_IN" "SOURCES")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "physgen_python: unknown arguments: ${arg_UNPARSED_ARGUMENTS}; a module is made of one SCHEMA")
  elseif(NOT arg_TARGET)
    message(FATAL_ERROR "physgen_python: TARGET is missing: the name of the module to make")
  elseif(NOT arg_SCHEMA)
    message(FATAL_ERROR "physgen_python(${arg_TARGET}): SCHEMA is missing: the schema whose objects Python sees")
  elseif(TARGET ${arg_TARGET})
    message(FATAL_ERROR "physgen_python(${arg_TARGET}): a target of this name exists already")
  endif()
  set(PYBIND11_FINDPYTHON ON)
  find_package(Python 3.9 QUIET COMPONENTS Interpreter Development)
  find_package(pybind11 2.10 CONFIG QUIET)
  if(NOT Python_FOUND OR NOT pybind11_FOUND)
    message(FATAL_ERROR "physgen_python(${arg_TARGET}): pybind11 2.10 and the headers of Python 3.9 are needed, or later "
      "ones; install pybind11-dev and python3-dev, or say where they are by -Dpybind11_DIR=... and "
      "-DPython_EXECUTABLE=...")
  endif()

  if(NOT arg_OUTPUT_DIR)
    set(arg_OUTPUT_DIR physgen/${arg_TARGET})
  endif()
  cmake_path(ABSOLUTE_PATH arg_OUTPUT_DIR BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
  set(options "")
  foreach(option IN ITEMS LAYOUT CHECKED_IN)
    if(arg_${option})
      list(APPEND options ${option} ${arg_${option}})
    endif()
  endforeach()
  physgen_generate(TARGET ${arg_TARGET}_classes SCHEMAS ${arg_SCHEMA} OUTPUT_DIR ${arg_OUTPUT_DIR} PYTHON ${options})
  if(NOT TARGET physgen::physgen)
    cmake_path(ABSOLUTE_PATH arg_CHECKED_IN BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE
      OUTPUT_VARIABLE arg_OUTPUT_DIR)
  endif()
  cmake_path(GET arg_SCHEMA STEM LAST_ONLY module)
  pybind11_add_module(${arg_TARGET} MODULE NO_EXTRAS ${arg_OUTPUT_DIR}/${module}.python.cpp ${arg_SOURCES})
  target_link_libraries(${arg_TARGET} PRIVATE ${arg_TARGET}_classes)
  set_target_properties(${arg_TARGET} PROPERTIES OUTPUT_NAME ${module})
  # What takes time there is in the library, and compilers take twice as long for more.
  set_source_files_properties(${arg_OUTPUT_DIR}/${module}.python.cpp PROPERTIES
    COMPILE_OPTIONS "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:-O1>")
  if(arg_SOURCES)
    target_compile_definitions(${arg_TARGET} PRIVATE PHYSGEN_PYTHON_SOURCES)
  endif()
endfunction()
