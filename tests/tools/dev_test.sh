#!/usr/bin/env bash
# dev_test.sh RULE DEV FOLDER: checks one rule of the script DEV (tools/dev), copied below FOLDER with the files that it reads,
# packages.sh, packages.txt, tests.sh and first.sh. The system's commands that it would install and build with are replaced by ones that write
# how they were called to $calls.
# shellcheck disable=SC2016  # the bodies of the commands below are expanded when they run
set -euo pipefail
rule=$1 dev=$2 folder=$3
work="$folder/tools_dev $rule" # with a space: paths are users' paths
root="$work/physgen"
calls=$work/calls
rm -rf "$work"
mkdir -p "$root/tools" "$work/bin" "$work/home"
cp "$dev" "$(dirname "$dev")"/{packages.sh,packages.txt,tests.sh,first.sh} "$root/tools"
export PATH="$work/bin:$PATH" calls work
unset CUDACXX CUDA_HOME CUDAARCHS
touch "$calls"

# shellcheck source-path=SCRIPTDIR source=dev_machine.sh
source "$(dirname "$0")/dev_machine.sh"

case $rule in
  help_names_every_command)
    dev 0 help
    for name in setup build try run test fuzz gpu report format tidy times clean; do says "  $name "; done
    dev 0
    ;;
  unknown_command_exits_with_2)
    dev 2 tset
    says "there is no command 'tset'"
    ;;
  setup_calls_no_apt_when_nothing_is_missing)
    dev 0 setup
    not_called apt
    [[ ! -s $work/output ]] || fail 'it should be silent'
    ;;
  setup_installs_what_is_missing_and_says_why)
    without 'ninja|gtest'
    dev 0 setup
    called 'apt-get .*update'
    called 'apt-get .*install -y --no-install-recommends ninja-build libgtest-dev$'
    says 'runs the build'
    ;;
  setup_reads_packages_and_versions_from_their_list)
    printf '%s\n' '# c' 'LLVM 31 30' '' 'tar   packs' 'libclang-LLVM-dev reads' >"$root/tools/packages.txt"
    apt_has='-30' dev 0 setup
    says '  tar                  packs'
    called 'install .* tar libclang-30-dev$'
    rm "$root/tools/packages.txt"
    dev 2 setup
    says "there is no $root/tools/packages.txt"
    ;;
  setup_without_root_names_the_packages)
    without 'ninja|llvm-22'
    fake id 'echo 1000'
    dev 2 setup
    says 'ninja-build libclang-22-dev llvm-22-dev clang-22'
    not_called '^apt-get'
    ;;
  setup_goes_on_when_the_lists_cannot_be_renewed)
    without ninja
    fake apt-get '[[ $* != *update* ]]'
    dev 0 setup
    says 'apt-get update failed'
    called 'install .* ninja-build'
    ;;
  setup_fails_when_packages_cannot_be_installed)
    without ninja
    fake apt-get '[[ $* != *install* ]]'
    dev 2 setup
    says 'by hand: apt-get install --no-install-recommends ninja-build'
    ;;
  setup_takes_llvm_19_where_there_is_no_22)
    without 22
    apt_has='-19' dev 0 setup
    called 'install .* libclang-19-dev llvm-19-dev clang-19$'
    ;;
  setup_goes_on_without_llvm_and_is_quick_afterwards)
    without 22
    apt_has='none' dev 0 setup
    says 'the archive has no LLVM 22, 21, 20, 19: going on without the generator'
    not_called 'apt-get.*install'
    : >"$calls"
    program build/release/bin/physbench
    touch "$root/build/release/CMakeCache.txt"
    program build/release/bin/physbench_first
    dev 0 run
    not_called apt
    dev 0 setup
    called 'apt-get .*update'
    ;;
  test_runs_ctest_and_gives_its_exit_code)
    dev 8 test -L runtime
    says 'nvcc was not found'
    called "ctest --test-dir $root/build/release --output-on-failure -j [0-9]* -L runtime\$"
    called 'cmake --preset release -DPHYSGEN_BENCHMARK_ALL_ROWS=OFF -DPHYSGEN_CUDA=OFF$'
    fake cmake 'exit 1'
    : >"$calls"
    dev 1 test
    not_called ctest
    ;;
  test_covers_cuda_where_nvcc_is_found)
    fake nvcc
    dev 8 test
    called 'cmake --preset release -DPHYSGEN_BENCHMARK_ALL_ROWS=OFF -DPHYSGEN_CUDA=ON -DCMAKE_CUDA_ARCHITECTURES=90$'
    PHYSGEN_CUDA=OFF dev 8 test
    says 'neither compiled nor tested: PHYSGEN_CUDA=OFF'
    called 'cmake --preset release -DPHYSGEN_BENCHMARK_ALL_ROWS=OFF -DPHYSGEN_CUDA=OFF$'
    fake nvidia-smi 'if [[ $1 == -L ]]; then echo "GPU 0: a device"; else printf "8.6\n9.0\n"; fi'
    dev 8 test
    called 'cmake --preset release -DPHYSGEN_BENCHMARK_ALL_ROWS=ON -DPHYSGEN_CUDA=ON -DCMAKE_CUDA_ARCHITECTURES=86$'
    ;;
  test_names_how_many_were_skipped_and_not_each)
    fake ctest 'printf "100%% tests passed\n\nThe following tests did not run:\n\t  7 - A.b (Skipped)\n\t  8 - A.c (Skipped)\n"'
    dev 0 test
    says '100% tests passed'
    says '2 tests were skipped'
    ! grep -q 'A\.b' "$work/output" || fail 'a skipped test is named'
    ;;
  test_quick_builds_and_runs_a_selection)
    fake ctest
    for name in generator_test fem_mesh_test; do program "build/release/bin/$name"; done
    printf 'generator_test\nfem_mesh_test\n' >"$root/build/release/quick_tests.txt"
    dev 0 test --quick
    called 'cmake --build --preset release -j [0-9]* --target quick_tests$'
    called '^fem_mesh_test --gtest_brief=1$'
    called 'ctest --test-dir .* -R .*tools_dev'
    says 'all of the quick tests passed'
    recorder "$root/build/release/bin/fem_mesh_test" 'exit 1'
    dev 1 test --quick
    says 'failed: fem_mesh_test'
    dev 2 test --quick -L runtime
    says 'test --quick takes no other arguments'
    ;;
  run_hands_its_arguments_to_physbench)
    program build/first/bin/physbench_cpu
    dev 0 run storage --benchmark_filter=svd
    says 'this machine has no GPU'
    called 'physbench_cpu storage --benchmark_filter=svd$'
    dev 0 run --all
    called 'physbench_cpu --all$'
    recorder "$root/build/first/bin/physbench_first" 'exit 3'
    dev 3 run
    ;;
  run_builds_no_more_than_is_run)
    for name in physbench_first physbench_cpu physbench_errors physbench; do program build/first/bin/$name; done
    program build/release/bin/physbench_solves
    dev 0 run
    called 'cmake --preset first -DPHYSGEN_BENCHMARK_ALL_ROWS=OFF -DPHYSGEN_CUDA=OFF$'
    called 'cmake --build --preset first -j [0-9]* --target physbench_first$'
    says 'Each line is one kernel over one layout'
    dev 0 run --threads=1 --objects=1000
    called 'physbench_first --threads=1 --objects=1000$'
    for word in errors replay; do
      : >"$calls"
      dev 0 run $word
      called 'cmake --build --preset first -j [0-9]* --target physbench_errors$'
      called "physbench_errors $word\$"
    done
    dev 0 run linear_solves --cells 8
    called 'cmake --build --preset release -j [0-9]* --target physbench_solves$'
    called 'physbench_solves linear_solves --cells 8$'
    fake nvidia-smi 'if [[ $1 == -L ]]; then echo "GPU 0: a device"; else echo 9.0; fi'
    dev 0 run errors
    called 'cmake --build --preset first -j [0-9]* --target physbench$'
    called 'physbench errors$'
    dev 0 run
    says 'nvcc was not found'
    ;;
  run_installs_no_more_than_a_first_table_needs)
    : >"$work/installed"
    program build/first/bin/physbench_first
    fake cmake '[[ $1 == --build ]] || echo "-- The CXX compiler identification"'
    dev 0 run
    ! grep -q 'compiler identification' "$work/output" || fail 'CMake tells of its checks'
    called 'apt-get .*install .* g++ libeigen3-dev .*cmake ninja-build .*libbenchmark-dev$'
    ! grep 'apt-get' "$calls" | grep -qE 'clang|llvm|python3|hdf5|gtest' || fail 'more was installed'
    ;;
  try_needs_a_compiler_and_headers_alone)
    : >"$work/installed"
    mkdir -p "$root/tools/examples" "$root/runtime/src/no_cuda"
    cp "$(dirname "$dev")/examples/blocks.awk" "$root/tools/examples"
    cp "$(dirname "$dev")/../README.md" "$root"
    touch "$root/tools/examples/layouts.cpp" "$root/runtime/src"/{copy,no_cuda/device}.cpp
    # A compiler whose programs say how they are called.
    fake g++ 'printf "#!/bin/sh\\necho ran ${!#}\\n" >"${!#}"; chmod +x "${!#}"'
    dev 0 try
    called 'apt-get .*install .* g++ libeigen3-dev libxsimd-dev libtbb-dev$'
    not_called '^cmake'
    for source in layouts pressure runtime; do called "g++ .*-c .*$source.cpp "; done
    for source in copy no_cuda/device; do
      grep -qxF "#include \"../../runtime/src/$source.cpp\"" "$root/build/try/runtime.cpp" || fail "$source.cpp is left out"
    done
    says "ran build/try/pressure"
    says "ran build/try/layouts"
    says 'tools/dev run'
    cmp <(sed -n '/^struct PHYSGEN_OBJECT/,/^};/p' "$root/README.md") <(sed -n '/^struct PHYSGEN_OBJECT/,/^};/p' "$root/build/try/stress.h") ||
      fail 'the schema is not that of README'
    : >"$calls"
    dev 0 try
    not_called 'g++ .*-c '
    dev 2 try all
    says 'try takes no arguments'
    ;;
  run_takes_the_build_that_has_the_generator)
    program build/release/bin/physbench_first
    touch "$root/build/release/CMakeCache.txt"
    dev 0 run
    called 'cmake --build --preset release -j [0-9]* --target physbench_first$'
    rm -r "$root/build"
    program build/release/bin/physbench_first
    fake git 'echo " M schemas/x.h"'
    dev 0 run
    says 'schemas differ from the last commit'
    called 'cmake --preset release'
    ;;
  report_hands_its_files_to_the_script)
    fake python3
    sed -i "s|/usr/bin/python3|python3|" "$root/tools/dev"
    dev 0 report a.json -o /somewhere b.json
    called "python3 $root/tools/report/report.py a.json b.json -o /somewhere\$"
    dev 2 report -o
    says 'report: -o needs a folder'
    ;;
  fuzz_hands_its_arguments_to_the_script)
    program build/release/fuzz/run
    dev 0 fuzz --seed 7
    called 'run --minutes 10 --seed 7$'
    dev 0 fuzz --minutes 1 --seed 7
    called 'run --minutes 1 --seed 7$'
    rm "$root/build/release/fuzz/run"
    program build/release/programs/run
    dev 0 fuzz --programs --seed 8
    called 'run --minutes 10 --seed 8$'
    dev 2 fuzz
    says 'fuzz needs LLVM'
    ;;
  gpu_runs_carried_programs_at_another_path)
    rm "$root/tools"/{packages.*,tests.sh,first.sh} # as carried: tools/dev and what was built
    fake nvcc
    fake nvidia-smi 'echo "GPU 0: a device"'
    program build/cuda/bin/physbench
    program build/cuda/bin/runtime_gpu_test
    echo 'CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere' >"$root/build/cuda/CMakeCache.txt"
    dev 0 gpu --gtest_filter=A.b --benchmark_filter=svd
    says 'built elsewhere'
    not_called cmake
    called 'runtime_gpu_test --gtest_filter=A.b$'
    called 'physbench --benchmark_filter=svd$'
    printf '#!/bin/sh\nexit 3\n' >"$root/build/cuda/bin/runtime_gpu_test"
    dev 3 gpu
    called 'physbench --benchmark_filter=/cuda/\[0-9\]+\$$'
    for command in setup run test tidy; do
      dev 2 $command
      says "there is no $root/tools/packages.sh"
      says 'this needs a checkout'
    done
    ;;
  gpu_without_programs_or_device_exits_with_2)
    dev 2 gpu
    says 'no programs in'
    program build/cuda/bin/physbench
    dev 2 gpu
    says 'this machine has no GPU'
    ;;
  times_sums_targets_and_lists_the_slowest_files)
    dev 2 times
    says 'build the preset first'
    mkdir -p "$root/build/release"
    {
      echo '# ninja log v5'
      printf '0\t9000\t1\ttests/CMakeFiles/a_test.dir/one.cpp.o\tf\n' # built again below
      printf '500\t2750\t1\ttests/CMakeFiles/a_test.dir/one.cpp.o\tf\n'
      printf '0\t1500\t1\ttests/CMakeFiles/a_test.dir/two.cpp.o\tf\n'
      printf '0\t3000\t1\ttools/CMakeFiles/b.dir/three.cu.o\tf\n'
      printf '0\t100\t1\tbin/a_test\tf\n'
      for output in generated/s.digest CMakeFiles/physgen/scenes/s.stamp "$root/build/release/CMakeFiles/physgen/scenes/s.stamp" generated/s.scene.h; do
        printf '0\t2500\t1\t%s\ts\n' "$output" # one command
      done
    } >"$root/build/release/.ninja_log"
    dev 0 times
    says '     3.8  a_test'
    says '     2.5  scenes'
    says "     9.2  in all"
    [[ $(grep -c ' 2.5 ' "$work/output") == 2 ]] || fail 'a command with four outputs does not count once'
    [[ $(grep -A 1 'slowest' "$work/output" | tail -n 1) == '     3.0  tools/three.cu.o' ]] || fail 'the slowest file is not first'
    ;;
  *) fail "there is no rule $rule" ;;
esac
rm -rf "$work"
