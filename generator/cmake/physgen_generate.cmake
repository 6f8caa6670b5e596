# Two functions that make a library target of generated headers as a part of a build. Used by physgen's own tree and,
# through find_package(physgen), by every other project.
#
#   physgen_generate(TARGET name SCHEMAS a.h b.h [PYTHON] [OUTPUT_DIR dir] [LAYOUT layout] [CHECKED_IN dir])
#   physgen_generate_scenes(TARGET name SCENES s.h t.h [LIBRARIES library...] [FLAGS flag...] [DEVICE] [EVERYTHING]
#                           [NO_FUSE] [OUTPUT_DIR dir] [CHECKED_IN dir])
#
# A program that links `name` finds its headers, is compiled after they are written, and links physgen::runtime. physgen
# runs again when a schema or scene, a header that it includes, or physgen itself has changed; a header whose text stays
# the same keeps its time, so that nothing that includes it is compiled again. A header in the build folder whose schema
# is no longer in the list is removed, so that no program goes on with it. Headers are written to OUTPUT_DIR (default:
# physgen/<name> in the current build folder). Without a physgen command (it needs LLVM), the headers in CHECKED_IN are
# used as they are.
#
# physgen_generate() writes a.physgen.h and b.physgen.h, accessor classes of the objects of schemas. LAYOUT (aos,
# aos_padded, soa, aosoa, aosoa(W)) takes the place of all layouts that the schemas state, which needs the command. With
# PYTHON it writes a.python.cpp and b.python.cpp, too, sources of Python modules: physgen_python() makes one of them.
#
# physgen_generate_scenes() writes s.scene.h and s.program.h, t.scene.h and t.program.h, with digests and reports beside them; of
# a scene that says what its index fields name s.halos.h and s.distributed.h, too, for several ranks. The library `name` links LIBRARIES, whose headers the scenes include. Programs are read with the folders and definitions of
# LIBRARIES, which must not depend on the language (COMPILE_LANGUAGE), and with the options FLAGS of the compiler, such
# as -march=x86-64-v3. The runtime's headers are read once for all scenes of the target, by `physgen precompile`.
# With DEVICE, physgen looks at what programs do on CUDA, too. It needs a toolkit: that of the project where it enables
# CUDA. With EVERYTHING there is s.everything.h, too: the same arrays with all fields. With NO_FUSE the steps of programs
# stay apart.
include_guard(DIRECTORY)
cmake_policy(VERSION 3.25)

function(physgen_generate)
  if("SCENES" IN_LIST ARGV)
    message(FATAL_ERROR "physgen_generate: SCENES have a function of their own: write physgen_generate_scenes(TARGET ... "
      "SCENES ...) with the same arguments")
  endif()
  cmake_parse_arguments(PARSE_ARGV 0 arg "PYTHON" "TARGET;OUTPUT_DIR;LAYOUT;CHECKED_IN" "SCHEMAS")
  if(arg_LAYOUT AND NOT TARGET physgen::physgen)
    message(FATAL_ERROR "physgen_generate(${arg_TARGET}): there is no physgen command (physgen was built without "
      "LLVM), which LAYOUT ${arg_LAYOUT} needs")
  endif()
  _physgen_add_library(physgen_generate schema physgen.h SCHEMAS)
  if(NOT TARGET physgen::physgen)
    return()
  endif()

  # The stamp's time is when physgen has run: headers keep theirs when their text does not change, and Make would run
  # physgen for ever. The list of schemas is an input, because Make does not compare commands.
  set(state ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/physgen/${arg_TARGET})
  _physgen_remove_former(${state}.written "${headers}")
  file(CONFIGURE OUTPUT ${state}.schemas CONTENT "${sources}\n${arg_OUTPUT_DIR}\n${arg_LAYOUT}\n${arg_PYTHON}\n" @ONLY)
  set(options "")
  if(arg_LAYOUT)
    list(APPEND options --layout ${arg_LAYOUT})
  endif()
  if(arg_PYTHON)
    list(APPEND options --python)
  endif()
  file(RELATIVE_PATH shown ${CMAKE_BINARY_DIR} ${arg_OUTPUT_DIR})
  add_custom_command(
    OUTPUT ${state}.stamp
    BYPRODUCTS ${headers}
    COMMAND physgen::physgen generate ${sources} -o ${arg_OUTPUT_DIR} ${options} --depfile ${state}.d --stamp ${state}.stamp
    DEPENDS ${sources} ${state}.schemas physgen::physgen
    DEPFILE ${state}.d
    COMMENT "Generating ${names} in ${shown}"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(${arg_TARGET}_headers DEPENDS ${state}.stamp)
  add_dependencies(${arg_TARGET} ${arg_TARGET}_headers)
endfunction()

function(physgen_generate_scenes)
  cmake_parse_arguments(PARSE_ARGV 0 arg "DEVICE;EVERYTHING;NO_FUSE" "TARGET;OUTPUT_DIR;CHECKED_IN" "SCENES;LIBRARIES;FLAGS")
  _physgen_add_library(physgen_generate_scenes scene scene.h SCENES)
  target_link_libraries(${arg_TARGET} INTERFACE ${arg_LIBRARIES})
  foreach(scene IN LISTS sources)  # generated headers name them by folder and file
    cmake_path(GET scene PARENT_PATH folder)
    cmake_path(GET folder PARENT_PATH folder)
    target_include_directories(${arg_TARGET} INTERFACE ${folder})
  endforeach()
  if(TARGET physgen::physgen)
    _physgen_scenes(${arg_TARGET} "${sources}" "${arg_OUTPUT_DIR}" "${arg_LIBRARIES}" "${arg_FLAGS}"
      "${arg_DEVICE}" "${arg_EVERYTHING}" "${arg_NO_FUSE}")
  endif()
endfunction()

# The part that both functions share: checks the arguments arg_... and makes the library, which finds its headers. Sets
# `sources` to the schemas or scenes of the argument LIST, `names` and `headers` to what is written of them.
macro(_physgen_add_library function kind ending LIST)
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${function}: unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  elseif(NOT arg_TARGET)
    message(FATAL_ERROR "${function}: TARGET is missing: the name of the library to make and to link")
  elseif(NOT arg_${LIST})
    message(FATAL_ERROR "${function}(${arg_TARGET}): ${LIST} is missing: at least one ${kind}")
  elseif(TARGET ${arg_TARGET})
    message(FATAL_ERROR "${function}(${arg_TARGET}): a target of this name exists already")
  endif()
  if(NOT arg_OUTPUT_DIR)
    set(arg_OUTPUT_DIR physgen/${arg_TARGET})
  endif()
  cmake_path(ABSOLUTE_PATH arg_OUTPUT_DIR BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
  set(sources "")
  set(headers "")
  set(names "")
  foreach(source IN LISTS arg_${LIST})
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    if(NOT EXISTS "${source}" OR IS_DIRECTORY "${source}")
      message(FATAL_ERROR "${function}(${arg_TARGET}): the ${kind} ${source} does not exist")
    endif()
    cmake_path(GET source STEM LAST_ONLY stem)
    set(name ${stem}.${ending})
    if(name IN_LIST names)
      message(FATAL_ERROR "${function}(${arg_TARGET}): two ${kind}s would write ${name}; the second is ${source}")
    endif()
    list(APPEND names "${name}")
    list(APPEND sources "${source}")
    list(APPEND headers "${arg_OUTPUT_DIR}/${name}")
    if(arg_PYTHON)
      list(APPEND names "${stem}.python.cpp")
      list(APPEND headers "${arg_OUTPUT_DIR}/${stem}.python.cpp")
    endif()
  endforeach()

  add_library(${arg_TARGET} INTERFACE)
  target_link_libraries(${arg_TARGET} INTERFACE physgen::runtime)
  if(TARGET physgen::physgen)
    get_property(written GLOBAL PROPERTY PHYSGEN_WRITTEN_HEADERS)
    foreach(header IN LISTS headers)
      if(header IN_LIST written)
        message(FATAL_ERROR "${function}(${arg_TARGET}): another ${function}() writes ${header}; give this one its own "
          "OUTPUT_DIR")
      endif()
    endforeach()
    set_property(GLOBAL APPEND PROPERTY PHYSGEN_WRITTEN_HEADERS ${headers})
    target_include_directories(${arg_TARGET} INTERFACE ${arg_OUTPUT_DIR})
  else()
    _physgen_use_checked_in(${function} ${arg_TARGET} "${arg_CHECKED_IN}" "${names}" "${kind}")
  endif()
endmacro()

# Writes the headers of scenes, each by a command of its own: reading a program takes seconds. The runtime's headers are
# read once for all.
function(_physgen_scenes target scenes output_dir libraries flags device everything no_fuse)
  set(folders "$<TARGET_PROPERTY:${target},INTERFACE_INCLUDE_DIRECTORIES>")  # those of its libraries, too
  # Programs are compiled with them. physgen's own choose checks and CUDA, and no field.
  set(definitions "$<FILTER:$<TARGET_PROPERTY:${target},INTERFACE_COMPILE_DEFINITIONS>,EXCLUDE,^PHYSGEN_>")
  set(definitions "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},$<SEMICOLON>-D>>")
  set(state ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/physgen/${target})
  set(stamps "")
  set(all_written "")
  set(options "")
  set(environment "")
  set(precompiled ${state}.pch)
  if(device)
    list(APPEND options --device)
    list(APPEND precompiled ${state}.pch.device)
    if(CMAKE_CUDA_COMPILER)  # bin/nvcc of its toolkit
      cmake_path(GET CMAKE_CUDA_COMPILER PARENT_PATH toolkit)
      cmake_path(GET toolkit PARENT_PATH toolkit)
      if(EXISTS ${toolkit}/include/cuda_runtime.h)
        set(environment ${CMAKE_COMMAND} -E env CUDA_HOME=${toolkit})
      endif()
    endif()
  endif()
  set(flags_behind -- "-I$<JOIN:${folders},$<SEMICOLON>-I>" "${definitions}" ${flags})
  # An input, because Make does not compare commands. Written where the definitions are known, and only if it changes.
  file(GENERATE OUTPUT ${state}.$<CONFIG>.flags CONTENT "${flags}\n${options}\n${environment}\n${folders}\n${definitions}\n")
  add_custom_command(
    OUTPUT ${state}.pch.stamp
    BYPRODUCTS ${precompiled}
    COMMAND ${environment} $<TARGET_FILE:physgen::physgen> precompile -o ${state}.pch ${options} --depfile ${state}.pch.d
            --stamp ${state}.pch.stamp ${flags_behind}
    DEPENDS ${state}.$<CONFIG>.flags physgen::physgen
    DEPFILE ${state}.pch.d
    COMMENT "Reading the runtime's headers for the scenes of ${target}"
    COMMAND_EXPAND_LISTS VERBATIM)
  list(APPEND options --precompiled ${state}.pch)
  if(everything)
    list(APPEND options --everything)
  endif()
  if(no_fuse)
    list(APPEND options --no-fuse)
  endif()
  foreach(scene IN LISTS scenes)
    cmake_path(GET scene STEM LAST_ONLY name)
    set(inputs ${state}/${name}.$<CONFIG>.flags)
    file(GENERATE OUTPUT ${inputs}
      CONTENT "${scene}\n${output_dir}\n${flags}\n${options}\n${environment}\n${folders}\n${definitions}\n")
    set(written "")
    foreach(ending scene.h program.h digest need.txt need.json usage.json)
      list(APPEND written ${output_dir}/${name}.${ending})
    endforeach()
    if(everything)
      list(APPEND written ${output_dir}/${name}.everything.h)
    endif()
    add_custom_command(
      OUTPUT ${state}/${name}.stamp
      BYPRODUCTS ${written}
      COMMAND ${environment} $<TARGET_FILE:physgen::physgen> scene ${scene} -o ${output_dir} ${options} --depfile ${state}/${name}.d --stamp ${state}/${name}.stamp
              ${flags_behind}
      DEPENDS ${scene} ${inputs} ${state}.pch.stamp physgen::physgen
      DEPFILE ${state}/${name}.d
      COMMENT "Looking at what the scene ${name} needs"
      COMMAND_EXPAND_LISTS VERBATIM)
    list(APPEND stamps ${state}/${name}.stamp)
    list(APPEND all_written ${written})
  endforeach()
  _physgen_remove_former(${state}.written "${all_written}")
  add_custom_target(${target}_scenes DEPENDS ${stamps})
  foreach(library IN LISTS libraries)
    if(TARGET ${library})
      add_dependencies(${target}_scenes ${library})  # headers that it generates
    endif()
  endforeach()
  add_dependencies(${target} ${target}_scenes)
endfunction()

# Removes what the list in the file `record` names and `files` does not, and writes `files` there. Only files of the build
# folder are removed: in a source folder they may be checked in.
function(_physgen_remove_former record files)
  set(former "")
  if(EXISTS ${record})
    file(STRINGS ${record} former)
  endif()
  get_property(written GLOBAL PROPERTY PHYSGEN_WRITTEN_HEADERS)
  foreach(file IN LISTS former)
    cmake_path(IS_PREFIX CMAKE_BINARY_DIR "${file}" is_built)
    cmake_path(IS_PREFIX CMAKE_CURRENT_SOURCE_DIR "${file}" in_source)
    cmake_path(IS_PREFIX CMAKE_CURRENT_BINARY_DIR "${file}" in_binary)
    if(in_source AND (NOT in_binary OR CMAKE_CURRENT_SOURCE_DIR STREQUAL CMAKE_CURRENT_BINARY_DIR))
      set(is_built FALSE)  # a build in the source folder, or a source folder within that of the build
    endif()
    if(is_built AND NOT file IN_LIST files AND NOT file IN_LIST written)
      file(REMOVE "${file}")
    endif()
  endforeach()
  list(JOIN files "\n" lines)
  file(WRITE ${record} "${lines}\n")
endfunction()

# Makes `target` use the headers `names` of the folder `checked_in`, as they are.
function(_physgen_use_checked_in function target checked_in names kind)
  if(NOT checked_in)
    message(FATAL_ERROR "${function}(${target}): there is no physgen command to write ${names} with (physgen was "
      "built without LLVM), and no CHECKED_IN folder to take them from")
  endif()
  cmake_path(ABSOLUTE_PATH checked_in BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  set(command "generate SCHEMA")
  if(names MATCHES "[.]python[.]cpp")
    set(command "generate SCHEMA --python")
  endif()
  if(kind STREQUAL "scene")
    set(command "scene SCENE")
  endif()
  foreach(name IN LISTS names)
    if(NOT EXISTS "${checked_in}/${name}")
      message(FATAL_ERROR "${function}(${target}): there is no physgen command (physgen was built without LLVM), "
        "and ${checked_in} has no ${name}; write it on a machine with LLVM: physgen ${command} -o ${checked_in}")
    endif()
  endforeach()
  message(STATUS "${function}(${target}): no physgen command; using the checked-in headers of ${checked_in}")
  target_include_directories(${target} INTERFACE ${checked_in})
endfunction()
