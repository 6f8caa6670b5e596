# physgen_generate(): makes accessor classes from schemas as a part of a build. Used by physgen's own tree and, through
# find_package(physgen), by every other project.
#
#   physgen_generate(TARGET name SCHEMAS a.h b.h [OUTPUT_DIR dir] [LAYOUT layout] [CHECKED_IN dir])
#   physgen_generate(TARGET name SCENES s.h t.h [LIBRARIES library...] [FLAGS flag...] [DEVICE] [EVERYTHING] [NO_FUSE]
#                    [OUTPUT_DIR dir] [CHECKED_IN dir])
#
# Makes the library target `name`. A program that links it finds the headers a.physgen.h and b.physgen.h, is compiled
# after they are written, and links physgen::runtime. physgen runs again when a schema, a header that a schema includes,
# or physgen itself has changed; a header whose text stays the same keeps its time, so that nothing that includes it is
# compiled again. A header in the build folder whose schema is no longer in the list is removed, so that no program goes
# on with it. Headers are written to OUTPUT_DIR (default: physgen/<name> in the current build folder). LAYOUT (aos,
# aos_padded, soa, aosoa, aosoa(W)) takes the place of all layouts that the schemas state. Without a physgen command (it
# needs LLVM), the headers in CHECKED_IN are used as they are, whose layouts cannot be changed.
#
# Of scenes it is the headers s.scene.h and s.program.h, t.scene.h and t.program.h, with digests and reports beside them. LIBRARIES are those whose headers the
# scenes include, and `name` links them, and programs are read with their folders and definitions, which must not depend on the
# language (COMPILE_LANGUAGE); FLAGS are further options of the compiler with which programs are read, such as
# -march=x86-64-v3.
# With DEVICE what programs do on CUDA is looked at, too: needs a toolkit, that of the project where it enables CUDA.
# With EVERYTHING there is s.everything.h, too, the same arrays with all fields. With NO_FUSE the steps of their programs
# stay apart.
# A scene is looked at again when its declaration or any header that it includes has changed.
include_guard(DIRECTORY)
cmake_policy(VERSION 3.25)

function(physgen_generate)
  cmake_parse_arguments(PARSE_ARGV 0 arg "DEVICE;EVERYTHING;NO_FUSE" "TARGET;OUTPUT_DIR;LAYOUT;CHECKED_IN" "SCHEMAS;SCENES;LIBRARIES;FLAGS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "physgen_generate: unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  elseif(NOT arg_TARGET)
    message(FATAL_ERROR "physgen_generate: TARGET is missing: the name of the library to make and to link")
  elseif(NOT arg_SCHEMAS AND NOT arg_SCENES)
    message(FATAL_ERROR "physgen_generate(${arg_TARGET}): SCHEMAS is missing: at least one schema header; or SCENES")
  elseif(arg_SCHEMAS AND arg_SCENES)
    message(FATAL_ERROR "physgen_generate(${arg_TARGET}): SCHEMAS and SCENES are two targets: scenes include the headers "
      "of schemas, which are written before")
  elseif(arg_SCENES AND arg_LAYOUT)
    message(FATAL_ERROR "physgen_generate(${arg_TARGET}): LAYOUT is for SCHEMAS; arrays of scenes have their layouts")
  elseif(arg_SCHEMAS AND (arg_LIBRARIES OR arg_FLAGS OR arg_DEVICE))
    message(FATAL_ERROR "physgen_generate(${arg_TARGET}): LIBRARIES, FLAGS and DEVICE are for SCENES")
  elseif(TARGET ${arg_TARGET})
    message(FATAL_ERROR "physgen_generate(${arg_TARGET}): there is a target of this name already")
  endif()
  if(NOT arg_OUTPUT_DIR)
    set(arg_OUTPUT_DIR physgen/${arg_TARGET})
  endif()
  cmake_path(ABSOLUTE_PATH arg_OUTPUT_DIR BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)

  set(schemas "")  # or scenes
  set(headers "")
  set(names "")
  set(kind schema)
  set(ending physgen.h)
  if(arg_SCENES)
    set(kind scene)
    set(ending scene.h)
  endif()
  foreach(schema IN LISTS arg_SCHEMAS arg_SCENES)
    cmake_path(ABSOLUTE_PATH schema BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    if(NOT EXISTS "${schema}" OR IS_DIRECTORY "${schema}")
      message(FATAL_ERROR "physgen_generate(${arg_TARGET}): the ${kind} ${schema} does not exist")
    endif()
    cmake_path(GET schema STEM LAST_ONLY stem)
    set(name ${stem}.${ending})
    if(name IN_LIST names)
      message(FATAL_ERROR "physgen_generate(${arg_TARGET}): two ${kind}s would write ${name}; the second is ${schema}")
    endif()
    list(APPEND names "${name}")
    list(APPEND schemas "${schema}")
    list(APPEND headers "${arg_OUTPUT_DIR}/${name}")
  endforeach()

  add_library(${arg_TARGET} INTERFACE)
  target_link_libraries(${arg_TARGET} INTERFACE physgen::runtime ${arg_LIBRARIES})
  if(arg_SCENES)  # generated headers name them by folder and file
    foreach(scene IN LISTS schemas)
      cmake_path(GET scene PARENT_PATH folder)
      cmake_path(GET folder PARENT_PATH folder)
      target_include_directories(${arg_TARGET} INTERFACE ${folder})
    endforeach()
  endif()

  if(NOT TARGET physgen::physgen)
    if(arg_LAYOUT)
      message(FATAL_ERROR "physgen_generate(${arg_TARGET}): there is no physgen command (physgen was built without "
        "LLVM), which LAYOUT ${arg_LAYOUT} needs")
    endif()
    _physgen_use_checked_in(${arg_TARGET} "${arg_CHECKED_IN}" "${names}" "${kind}")
    return()
  endif()

  get_property(written GLOBAL PROPERTY PHYSGEN_WRITTEN_HEADERS)
  foreach(header IN LISTS headers)
    if(header IN_LIST written)
      message(FATAL_ERROR "physgen_generate(${arg_TARGET}): another physgen_generate() writes ${header}; "
        "give this one its own OUTPUT_DIR")
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY PHYSGEN_WRITTEN_HEADERS ${headers})

  target_include_directories(${arg_TARGET} INTERFACE ${arg_OUTPUT_DIR})
  if(arg_SCENES)
    _physgen_scenes(${arg_TARGET} "${schemas}" "${arg_OUTPUT_DIR}" "${arg_LIBRARIES}" "${arg_FLAGS}"
      "${arg_DEVICE}" "${arg_EVERYTHING}" "${arg_NO_FUSE}")
    return()
  endif()

  # The stamp stands for "physgen has run", with a time of its own: headers keep theirs when their text does not change,
  # and Make would run physgen for ever. The list of schemas is an input, because Make does not compare commands.
  set(state ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/physgen/${arg_TARGET})
  _physgen_remove_former(${state}.written "${headers}")
  file(CONFIGURE OUTPUT ${state}.schemas CONTENT "${schemas}\n${arg_OUTPUT_DIR}\n${arg_LAYOUT}\n" @ONLY)
  set(layout "")
  if(arg_LAYOUT)
    set(layout --layout ${arg_LAYOUT})
  endif()
  file(RELATIVE_PATH shown ${CMAKE_BINARY_DIR} ${arg_OUTPUT_DIR})
  add_custom_command(
    OUTPUT ${state}.stamp
    BYPRODUCTS ${headers}
    COMMAND physgen::physgen generate ${schemas} -o ${arg_OUTPUT_DIR} ${layout} --depfile ${state}.d --stamp ${state}.stamp
    DEPENDS ${schemas} ${state}.schemas physgen::physgen
    DEPFILE ${state}.d
    COMMENT "Generating ${names} in ${shown}"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_custom_target(${arg_TARGET}_headers DEPENDS ${state}.stamp)
  add_dependencies(${arg_TARGET} ${arg_TARGET}_headers)
endfunction()

# Writes the headers of scenes, each by a command of its own: reading a program takes seconds.
function(_physgen_scenes target scenes output_dir libraries flags device everything no_fuse)
  set(folders "$<TARGET_PROPERTY:${target},INTERFACE_INCLUDE_DIRECTORIES>")  # those of its libraries, too
  # Programs are compiled with them. physgen's own choose checks and CUDA, and no field.
  set(definitions "$<FILTER:$<TARGET_PROPERTY:${target},INTERFACE_COMPILE_DEFINITIONS>,EXCLUDE,^PHYSGEN_>")
  set(definitions "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>")
  set(state ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/physgen/${target})
  set(stamps "")
  set(all_written "")
  set(options "")
  set(environment "")
  if(everything)
    list(APPEND options --everything)
  endif()
  if(device)
    list(APPEND options --device)
    if(CMAKE_CUDA_COMPILER)  # bin/nvcc of its toolkit
      cmake_path(GET CMAKE_CUDA_COMPILER PARENT_PATH toolkit)
      cmake_path(GET toolkit PARENT_PATH toolkit)
      if(EXISTS ${toolkit}/include/cuda_runtime.h)
        set(environment ${CMAKE_COMMAND} -E env CUDA_HOME=${toolkit})
      endif()
    endif()
  endif()
  if(no_fuse)
    list(APPEND options --no-fuse)
  endif()
  foreach(scene IN LISTS scenes)
    cmake_path(GET scene STEM LAST_ONLY name)
    # An input, because Make does not compare commands. Written where the definitions are known, and only if it changes.
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
              -- "-I$<JOIN:${folders},;-I>" "${definitions}" ${flags}
      DEPENDS ${scene} ${inputs} physgen::physgen
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
function(_physgen_use_checked_in target checked_in names kind)
  if(NOT checked_in)
    message(FATAL_ERROR "physgen_generate(${target}): there is no physgen command to write ${names} with (physgen was "
      "built without LLVM), and no CHECKED_IN folder to take them from")
  endif()
  cmake_path(ABSOLUTE_PATH checked_in BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  set(command "generate SCHEMA")
  if(kind STREQUAL "scene")
    set(command "scene SCENE")
  endif()
  foreach(name IN LISTS names)
    if(NOT EXISTS "${checked_in}/${name}")
      message(FATAL_ERROR "physgen_generate(${target}): there is no physgen command (physgen was built without LLVM), "
        "and ${checked_in} has no ${name}; write it on a machine with LLVM: physgen ${command} -o ${checked_in}")
    endif()
  endforeach()
  message(STATUS "physgen_generate(${target}): no physgen command; using the checked-in headers of ${checked_in}")
  target_include_directories(${target} INTERFACE ${checked_in})
endfunction()
