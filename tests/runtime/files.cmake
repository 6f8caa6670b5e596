# Tests of arrays in files.

# Arrays as .npy files, and NumPy.
if(EXISTS /usr/bin/python3)
  execute_process(COMMAND /usr/bin/python3 -c "import numpy" RESULT_VARIABLE numpy ERROR_QUIET)
  if(numpy EQUAL 0)
    add_executable(npy_numbers npy_numbers.cpp)
    target_link_libraries(npy_numbers PRIVATE physgen_schemas GTest::gtest)
    target_include_directories(npy_numbers PRIVATE ${PROJECT_SOURCE_DIR}/tests/generator/golden)
    physgen_add_warnings(npy_numbers)
    add_test(NAME runtime.numpy_reads_and_writes_npy_files_of_arrays
      COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/npy_numbers_test.py $<TARGET_FILE:npy_numbers>)
    set_tests_properties(runtime.numpy_reads_and_writes_npy_files_of_arrays PROPERTIES LABELS runtime)
  endif()
endif()

# Arrays in files, where HDF5 is; and what h5py reads of them.
if(TARGET physgen::hdf5)
  physgen_add_test(runtime_saved_test LABEL runtime SOURCES saved_arrays_test.cpp saved_calls_test.cpp saved_files_test.cpp
    LIBRARIES physgen_schemas physgen::hdf5
    INCLUDES ${PROJECT_SOURCE_DIR}/tests/generator/golden ${PROJECT_SOURCE_DIR}/runtime/src ${PROJECT_SOURCE_DIR}/tools)
  target_include_directories(runtime_saved_test SYSTEM PRIVATE ${PHYSGEN_HDF5_INCLUDE})
  physgen_join(runtime_saved_test 2)
  add_executable(saved_rates saved_rates.cpp)  # a benchmark, which a test runs for the bits alone
  target_link_libraries(saved_rates PRIVATE physgen_schemas physgen::hdf5)
  physgen_add_warnings(saved_rates)
  add_test(NAME runtime.saved_arrays_of_many_blocks_come_back COMMAND saved_rates ${CMAKE_CURRENT_BINARY_DIR} 40 1)
  set_tests_properties(runtime.saved_arrays_of_many_blocks_come_back PROPERTIES LABELS runtime)
  if(EXISTS /usr/bin/python3)
    execute_process(COMMAND /usr/bin/python3 -c "import h5py" RESULT_VARIABLE h5py ERROR_QUIET)
    if(h5py EQUAL 0)
      add_executable(saved_numbers saved_numbers.cpp)
      target_link_libraries(saved_numbers PRIVATE physgen_schemas physgen::hdf5 GTest::gtest)
      target_include_directories(saved_numbers PRIVATE ${PROJECT_SOURCE_DIR}/tests/generator/golden)
      physgen_add_warnings(saved_numbers)
      add_test(NAME runtime.h5py_reads_saved_arrays
        COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/saved_numbers_test.py $<TARGET_FILE:saved_numbers>)
      set_tests_properties(runtime.h5py_reads_saved_arrays PROPERTIES LABELS runtime)
    endif()
  endif()
endif()
