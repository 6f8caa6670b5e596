# How this tree is compiled: language level, warnings, CUDA, sanitizers, and build folders that can be carried to other
# machines. Of this, only the sanitizers of a build with PHYSGEN_SANITIZE reach users of an installed physgen.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
get_property(multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT CMAKE_BUILD_TYPE AND NOT multi_config AND PROJECT_IS_TOP_LEVEL)
  set_property(CACHE CMAKE_BUILD_TYPE PROPERTY VALUE Release)
  set(CMAKE_BUILD_TYPE Release)
endif()

if(PHYSGEN_CUDA)
  if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
    set(CMAKE_CUDA_ARCHITECTURES 90)
  endif()
  set(CMAKE_CUDA_RUNTIME_LIBRARY Static)
  enable_language(CUDA)
  if(NOT DEFINED CMAKE_CUDA20_STANDARD_COMPILE_OPTION)  # CMake 3.25 does not know that nvcc 12 and later have C++20
    set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
    set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION -std=c++20)
    if(NOT PROJECT_IS_TOP_LEVEL)
      set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20 PARENT_SCOPE)
      set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION -std=c++20 PARENT_SCOPE)
    endif()
  endif()
  set(CMAKE_CUDA_STANDARD 20)
  set(CMAKE_CUDA_STANDARD_REQUIRED ON)
  set(CMAKE_CUDA_EXTENSIONS OFF)
  find_package(CUDAToolkit REQUIRED)
endif()

set(PHYSGEN_SANITIZERS "$<$<COMPILE_LANGUAGE:CXX>:-fsanitize=address,undefined;-fno-omit-frame-pointer>"
                       "$<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=-fsanitize=address>")
if(PHYSGEN_SANITIZE)  # exported as well: programs must be linked, and are better compiled, as their libraries are
  add_compile_options("${PHYSGEN_SANITIZERS}")
  add_link_options(-fsanitize=address,undefined)
endif()

# Compiles the sources of `target` with the warnings of this project as errors. nvcc's host code is its own output, so
# -Wpedantic says nothing useful there. GCC warns falsely of operands that its own AVX-512 intrinsics, and Eigen, leave
# uninitialized on purpose, and before version 13 of overlap inside std::string (its bug 105651).
function(physgen_add_warnings target)
  set(cxx -Wall -Wextra -Wpedantic -Wconversion -Werror)
  set(cuda -Wall,-Wextra,-Wconversion,-Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      list(APPEND cxx -Wno-restrict)
      string(APPEND cuda ",-Wno-restrict")
    endif()
    list(APPEND cxx -Wno-uninitialized -Wno-maybe-uninitialized)
    string(APPEND cuda ",-Wno-uninitialized,-Wno-maybe-uninitialized")
  endif()
  target_compile_options(${target} PRIVATE
    "$<$<COMPILE_LANGUAGE:CXX>:${cxx}>" "$<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=${cuda};-Werror=all-warnings>")
endfunction()

# Compiles everything added after this call, in the calling folder and below, for the processor `arch`.
macro(physgen_use_arch arch)
  if(NOT "${arch}" STREQUAL "")
    add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:-march=${arch}>"
                        "$<$<COMPILE_LANGUAGE:CUDA>:-Xcompiler=-march=${arch}>")
  endif()
endmacro()

# CUDA sources that are added after this call, in the calling folder and below: nvcc's -O is that of the host's code, which
# launches kernels there and computes little. The device's code stays as it is.
macro(physgen_optimize_cuda_host_less)
  string(REPLACE "-O3" "-O1" CMAKE_CUDA_FLAGS_RELEASE "${CMAKE_CUDA_FLAGS_RELEASE}")
endmacro()

# physgen_precompile(target <header>...) or physgen_precompile(target REUSE_FROM other)
# Compiles headers once for all C++ sources of `target`, or takes those of another with the same options, whose definitions
# `target` has as well. Sources with options of their own do without: GCC takes headers that were compiled at another -O,
# and then optimizes as they say. CMAKE_DISABLE_PRECOMPILE_HEADERS=ON compiles all as it is written. GCC forgets which
# precompiled headers are the system's, and its false warnings of them come back. -fpch-preprocess lets ccache look into
# them, which also needs CCACHE_SLOPPINESS=pch_defines,time_macros in the environment.
function(physgen_precompile target)
  if("${ARGV1}" STREQUAL "REUSE_FROM")
    target_precompile_headers(${target} ${ARGN})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_source_file_property(options ${source} COMPILE_OPTIONS)
    if(options)
      set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    target_compile_options(${target} PRIVATE
      "$<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess;-Wno-array-bounds;-Wno-nonnull;-Wno-stringop-overflow>")
  endif()
endfunction()

# physgen_join(target files)
# Compiles the C++ sources of `target` joined, so many files at once, since what takes time in each are the same headers. Names
# in unnamed namespaces must differ within a target. A source with options or definitions of its own stays alone;
# CMAKE_UNITY_BUILD=OFF compiles each source alone.
function(physgen_join target files)
  if(NOT DEFINED CMAKE_UNITY_BUILD OR CMAKE_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${files})
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "[.]cu$")  # newer CMake would join these as well, so many at once
    set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# physgen_join_named(target group <source>...)
# The same of these sources alone, which are compiled as one file; others of `target` stay alone or are in other groups.
function(physgen_join_named target group)
  if(NOT DEFINED CMAKE_UNITY_BUILD OR CMAKE_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
  endif()
endfunction()

# physgen_join_cuda(target <source>...)
# Compiles these CUDA sources of `target` as one file, which is written here, since CMake joins none: nvcc reads the headers of
# each file three times. They are named, so that joined files take about the same time. As with physgen_join, names in unnamed
# namespaces must differ, a source with options of its own stays alone, and CMAKE_UNITY_BUILD=OFF compiles each source alone.
function(physgen_join_cuda target)
  if(DEFINED CMAKE_UNITY_BUILD AND NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  set(text "// Written by physgen_join_cuda: sources of ${target} that are compiled as one.\n")
  foreach(source IN LISTS ARGN)
    get_source_file_property(options ${source} COMPILE_OPTIONS)
    if(options)
      message(FATAL_ERROR "physgen_join_cuda: ${source} has options of its own (${options}), which others must not get; leave it out of ${target}'s list")
    endif()
    if(NOT source IN_LIST sources)
      message(FATAL_ERROR "physgen_join_cuda: ${source} is no source of ${target}, or is joined twice; add it to the target or leave it out")
    endif()
    list(REMOVE_ITEM sources ${source})
    get_filename_component(path ${source} ABSOLUTE)
    string(APPEND text "#include \"${path}\"\n")
  endforeach()
  list(GET ARGN 0 first)
  get_filename_component(first ${first} NAME_WE)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/joined/${target}/${first}_and_others.cu)
  file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)  # written only where its text changes
  set_target_properties(${target} PROPERTIES SOURCES "${sources};${file}")
endfunction()

# Keeps the sources of `target`, which include Clang (1.9 GB of memory each), from filling the memory: at most one at a
# time for every 2 GiB. Ninja only.
function(physgen_limit_compile_jobs target)
  cmake_host_system_information(RESULT mebibytes QUERY TOTAL_PHYSICAL_MEMORY)
  math(EXPR jobs "${mebibytes} / 2048")
  if(jobs LESS 1)
    set(jobs 1)
  endif()
  set_property(GLOBAL APPEND PROPERTY JOB_POOLS clang_sources=${jobs})
  set_property(TARGET ${target} PROPERTY JOB_POOL_COMPILE clang_sources)
endfunction()

# Programs for a GPU often run on another machine than the one they were built on. What a bare machine may not have goes
# into the programs (GoogleTest and the CUDA runtime, both static) or into lib/ beside bin/, where they look first. The
# C++ runtime is brought along, not linked statically: libbenchmark.so would bring a second one into the same program.
if(PHYSGEN_CUDA)
  set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)
  list(APPEND CMAKE_BUILD_RPATH "$ORIGIN/../lib")
  add_link_options(-Wl,--disable-new-dtags)  # the path holds for libraries of libraries, too
  set(lib ${PROJECT_BINARY_DIR}/lib)
  file(MAKE_DIRECTORY ${lib})
  foreach(library libstdc++.so.6 libgcc_s.so.1)
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=${library}
      OUTPUT_VARIABLE file OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(IS_ABSOLUTE "${file}")
      file(REAL_PATH ${file} file)
      configure_file(${file} ${lib}/${library} COPYONLY)
    endif()
  endforeach()
  find_package(TBB REQUIRED COMPONENTS tbb)
  set(libraries TBB::tbb)
  if(PHYSGEN_BENCHMARKS)
    find_package(benchmark REQUIRED)
    list(APPEND libraries benchmark::benchmark)
  endif()
  foreach(library IN LISTS libraries)
    get_target_property(type ${library} TYPE)
    if(type STREQUAL "SHARED_LIBRARY")
      get_target_property(file ${library} LOCATION)
      execute_process(COMMAND ${CMAKE_OBJDUMP} -p ${file} OUTPUT_VARIABLE headers)
      string(REGEX MATCH "SONAME +([^\n]+)" soname "${headers}")
      configure_file(${file} ${lib}/${CMAKE_MATCH_1} COPYONLY)
    endif()
  endforeach()
endif()
