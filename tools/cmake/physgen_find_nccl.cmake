# Finds NCCL's header beside CUDA, for programs on several GPUs: PHYSGEN_NCCL_INCLUDE, a folder, and PHYSGEN_NCCL_LIBRARY, where its
# library lies here. Programs load the library when they need it, and link nothing of it.
if(PHYSGEN_CUDA)
  find_path(PHYSGEN_NCCL_INCLUDE nccl.h HINTS ${CUDAToolkit_INCLUDE_DIRS})
  find_library(PHYSGEN_NCCL_LIBRARY NAMES libnccl.so.2 HINTS ${CUDAToolkit_LIBRARY_DIR} PATH_SUFFIXES lib lib64)
  mark_as_advanced(PHYSGEN_NCCL_INCLUDE PHYSGEN_NCCL_LIBRARY)
  if(NOT PHYSGEN_NCCL_LIBRARY)
    set(PHYSGEN_NCCL_LIBRARY "")
  endif()
endif()
