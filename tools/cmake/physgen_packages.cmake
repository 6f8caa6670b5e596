# Packages of Debian, which cpack writes in a build folder (`tools/dev package`): libphysgen-dev has headers, libraries, pages and
# CMake's files, physgen the command that writes classes from schemas. They go into /usr, and hold nothing of this machine's
# processor: what is installed is compiled without -march.
set(CPACK_PACKAGE_NAME physgen)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_CONTACT "the developers of physgen")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES OFF)  # static libraries, and a command whose messages name places
set(CPACK_THREADS 0)
set(CPACK_COMPONENTS_ALL runtime)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libphysgen-dev)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libxsimd-dev (>= 8.1), libtbb-dev, cmake (>= 3.25)")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "g++ (>= 4:12) | c++-compiler, make | ninja-build")  # apt installs them, too
# For the components hdf5 and distributed, and for modules of Python.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "libhdf5-dev, libopenmpi-dev, pybind11-dev, python3-dev, python3-numpy")
if(PHYSGEN_HAVE_CLANG)
  list(APPEND CPACK_COMPONENTS_ALL generator)
  set(CPACK_DEBIAN_GENERATOR_PACKAGE_NAME physgen)
  # The headers of Clang itself are read with every schema.
  set(CPACK_DEBIAN_GENERATOR_PACKAGE_DEPENDS
    "libphysgen-dev (= ${PROJECT_VERSION}), libclang-common-${LLVM_VERSION_MAJOR}-dev")
  set(CPACK_DEBIAN_GENERATOR_PACKAGE_SHLIBDEPS ON)
endif()
include(CPack)
