# physgen_give_cuda_cxx20(target): CUDA sources that link `target` are compiled as C++20, with one option -std=c++20 in all.
# CMake gives it where it knows that nvcc has C++20. CMake 3.25 does not, and passes over CUDA_STANDARD 20 in silence,
# unless a project has told it the option; so there the option comes from `target`, unless the project gives it to nvcc.
# It is for where it is called: the package of a library is used with another CMake, and calls this itself.
function(physgen_give_cuda_cxx20 target)
  if(cuda_std_20 IN_LIST CMAKE_CUDA_COMPILE_FEATURES AND CMAKE_CUDA20_EXTENSION_COMPILE_OPTION)
    set_property(TARGET ${target} APPEND PROPERTY INTERFACE_COMPILE_FEATURES $<BUILD_INTERFACE:cuda_std_20>)
  elseif(NOT CMAKE_CUDA_FLAGS MATCHES "-std[= ]")
    # CMake gives it where the target asks for 20, or for nothing: it then takes the standard of C++, which is 20 at least.
    set(given 0)
    set(standard $<TARGET_PROPERTY:CUDA_STANDARD>)
    set(extensions $<TARGET_PROPERTY:CUDA_EXTENSIONS>)
    if(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION)
      set(given $<OR:$<STREQUAL:${standard},>,$<STREQUAL:${standard},20>>)
    elseif(CMAKE_CUDA20_STANDARD_COMPILE_OPTION)
      set(given $<OR:$<STREQUAL:${standard}-${extensions},-OFF>,$<STREQUAL:${standard}-${extensions},20-OFF>>)
    endif()
    set_property(TARGET ${target} APPEND PROPERTY INTERFACE_COMPILE_OPTIONS
      $<BUILD_INTERFACE:$<$<AND:$<COMPILE_LANGUAGE:CUDA>,$<NOT:${given}>>:-std=c++20>>)
  endif()
endfunction()
