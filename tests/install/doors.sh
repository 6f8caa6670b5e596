#!/usr/bin/env bash
# doors.sh RULE FOLDER SOURCE GENERATOR: builds a project of the folder doors beside this file, below FOLDER, with the CMake
# generator GENERATOR, against the package in FOLDER/package, or with SOURCE as a subdirectory, and checks one rule of how
# projects get physgen.
set -euo pipefail
rule=$1 folder=$2 source=$3 generator=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work="$folder/door $rule" # with a space: paths are users' paths
package=$(dirname "$(find "$folder/package" -name physgenConfig.cmake)")
libraries=$(dirname "$(find "$folder/package" -name libphysgen_runtime_checked.a)")
mode=_checked # a build with PHYSGEN_CHECKED=ON has no other form
[[ ! -e $libraries/libphysgen_runtime.a ]] || mode=

fail() { echo "FAILED: $*" >&2; exit 1; }
configure() { # configure BUILD DOOR OPTION...
  cmake -S "$work/project" -B "$work/$1" -G "$generator" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "-Dphysgen_DIR=$package" \
    -DDOOR="$2" "${@:3}" >"$work/configure.txt" 2>&1
}
must_configure() { configure "$@" || { cat "$work/configure.txt"; fail "the project $2 cannot be configured"; }; }
build() { cmake --build "$work/$1" "${@:2}"; }
# Fails unless the last configure() printed the text $1, whatever the line breaks.
expect_said() { tr -s ' \n' ' ' <"$work/configure.txt" | grep -qF -- "$1" || fail "not said: $1: $(cat "$work/configure.txt")"; }

rm -rf "$work"
mkdir -p "$work"
cp -r "$here/doors" "$work/project"
cp -r "$here/project/schemas" "$work/project/schemas"
chmod -R u+w "$work/project"

case $rule in
  cuda_sources_need_nothing_but_the_package)
    must_configure build cuda
    # A CMake that knows that nvcc has C++20, as later ones do, gives the option itself.
    echo 'set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION -std=c++20)
set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION -std=c++20)' >"$work/later.cmake"
    must_configure later cuda "-DCMAKE_USER_MAKE_RULES_OVERRIDE_CUDA=$work/later.cmake"
    must_configure flags cuda -DCMAKE_CUDA_FLAGS=-std=c++20
    must_configure subdirectory cuda_subdirectory "-DPHYSGEN=$source" -DPHYSGEN_GENERATOR=OFF
    for by in build later flags subdirectory; do
      given=$(grep '"command".*springs\.cu' "$work/$by/compile_commands.json" | grep -o -- '-std=[^ ]*' | tr '\n' ' ')
      [[ $given == '-std=c++20 ' ]] || fail "nvcc is given '$given' in the folder $by, expected: -std=c++20, once"
    done
    build build
    "$work/build/springs" || fail 'the program computes wrong numbers'
    ;;
  cuda_memory_needs_no_cuda_sources)
    must_configure build cuda_without_cuda_code
    build build
    "$work/build/memory" || fail 'the program has no CUDA in it'
    # The same program with the library that other projects get says what to do.
    "$CXX" ${SANITIZERS:+"$SANITIZERS"} "$work/build/CMakeFiles/memory.dir/memory.cpp.o" \
      "$libraries/libphysgen_runtime$mode.a" -ltbb -o "$work/without"
    if "$work/without" >"$work/output.txt" 2>&1; then fail 'there is CUDA without asking for it'; fi
    grep 'enable the language CUDA before find_package(physgen), or ask it for COMPONENTS cuda' "$work/output.txt" ||
      fail "unclear: $(cat "$work/output.txt")"
    ;;
  the_component_cuda_of_a_package_without_it_is_refused)
    cp -r "$folder/package" "$work/package"
    package=$(dirname "$(find "$work/package" -name physgenConfig.cmake)")
    rm -f "$package"/physgen_runtime_cuda*
    if configure build cuda_without_cuda_code; then fail 'the project is configured'; fi
    expect_said 'this physgen was built without CUDA: configure it with -DPHYSGEN_CUDA=ON'
    ;;
  the_component_solver_of_a_package_without_it_is_refused)
    package=$(dirname "$(find "$folder/package without physgen" -name physgenConfig.cmake)")
    if configure build solver; then fail 'the project is configured'; fi
    expect_said 'this physgen was installed without its solver'
    ;;
  fem_is_a_component_and_can_be_checked)
    # The program prints its mesh, and reads behind the end of an array, which only checks notice.
    if [[ ! $mode ]]; then
      must_configure build fem
      build build
      "$work/build/box" | grep -x '27 nodes, 98 edges' || fail 'the program is wrong'
      ! nm -C "$work/build/box" | grep ' cuda[A-Z]' || fail 'there is CUDA in a program that asks for none'
    fi
    must_configure checked fem -DPHYSGEN_CHECKED=ON
    build checked
    if "$work/checked/box" >"$work/output.txt" 2>&1; then fail 'the program is not checked'; fi
    grep -x '27 nodes, 98 edges' "$work/output.txt"
    grep 'NodePosition: object 27 of an array of 27' "$work/output.txt" || fail "unclear: $(cat "$work/output.txt")"
    ;;
  distributed_is_a_component_with_and_without_mpirun)
    must_configure build distributed
    build build
    export ASAN_OPTIONS=detect_leaks=0  # of MPI
    "$work/build/ranks" | grep -x '1 ranks, sum 0' || fail 'the program is wrong'
    if [[ ${MPIRUN-} ]]; then
      OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout 60 "$MPIRUN" --oversubscribe -n 3 "$work/build/ranks" |
        grep -x '3 ranks, sum 3' || fail 'three ranks do not find each other'
    fi
    ;;
  a_scene_runs_on_ranks_with_and_without_mpi)
    export ASAN_OPTIONS=detect_leaks=0  # of MPI
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    mkdir "$work/project/scenes"
    cp "$source/tests/generator/scenes/relax.h" "$work/project/scenes"
    must_configure build scene_of_ranks
    build build
    "$work/build/relax" >"$work/one.txt" || fail 'the program does not run by itself'
    grep -x 'digest [0-9a-f]* of 9000 nodes' "$work/one.txt" || fail "unclear: $(cat "$work/one.txt")"
    if [[ ${MPIRUN-} ]]; then
      timeout 60 "$MPIRUN" --oversubscribe -n 2 "$work/build/relax" >"$work/two.txt" 2>"$work/said.txt" || fail "$(cat "$work/said.txt")"
      cmp "$work/one.txt" "$work/two.txt" || fail 'two ranks have other bits than one'
      grep -x '1 of 2: 4[0-9]* owned, [1-9][0-9]* exchanges' "$work/said.txt" || fail "unclear: $(cat "$work/said.txt")"
    fi
    # What an installation of a build with -DPHYSGEN_MPI=OFF has in other files than this one; and as it has no physgen, the
    # headers that the first project wrote are checked in.
    cmake -S "$source" -B "$work/off" -G "$generator" -DCMAKE_BUILD_TYPE=Debug -DPHYSGEN_MPI=OFF -DPHYSGEN_GENERATOR=OFF \
      -DPHYSGEN_CUDA=OFF -DPHYSGEN_TESTS=OFF -DPHYSGEN_BENCHMARKS=OFF -DCMAKE_OPTIMIZE_DEPENDENCIES=ON \
      -DPHYSGEN_CHECKED="${mode:+ON}" -DPHYSGEN_SANITIZE="${SANITIZERS:+ON}" >"$work/configure.txt" 2>&1 || fail "$(cat "$work/configure.txt")"
    cmake --build "$work/off" --target "physgen_distributed$mode"
    cp -r "$folder/package without physgen" "$work/package"
    package=$(dirname "$(find "$work/package" -name physgenConfig.cmake)")
    cp "$work/off/package/physgenConfig.cmake" "$work/off/CMakeFiles/Export/"*/"physgen_distributed$mode.cmake" "$package"
    cp "$(find "$work/off" -name "libphysgen_distributed$mode.a")" "$(find "$work/package" -name "libphysgen_distributed$mode.a")"
    cp -r "$work/build/physgen/relax_scene" "$work/project/generated"
    must_configure without scene_of_ranks -DCMAKE_DISABLE_FIND_PACKAGE_MPI=ON
    build without
    ! nm -C "$work/without/relax" | grep ' MPI_' || fail 'there is MPI in a program of a build without it'
    "$work/without/relax" | cmp - "$work/one.txt" || fail 'the build without MPI has other bits'
    ;;
  fem_of_a_subdirectory_compiles)
    # Compiled only: the libraries are this build's own.
    must_configure build subdirectory "-DPHYSGEN=$source" -DPHYSGEN_GENERATOR=OFF
    [[ $generator != *Make* ]] || build build --target box/fast || true
    [[ $generator == *Make* ]] || build build --target CMakeFiles/box.dir/box.cpp.o
    [[ -e $work/build/CMakeFiles/box.dir/box.cpp.o ]] || fail 'the program was not compiled'
    ;;
  a_second_call_that_needs_more_is_refused)
    if configure build two_calls; then fail 'the project is configured'; fi
    expect_said "an earlier find_package(physgen) was for physgen::runtime without 'checked'"
    ;;
  objects_of_different_modes_do_not_link)
    cd "$work"
    echo '#include <physgen/config.h>
int main() {}' >main.cpp
    include=$(dirname "$(find "$folder/package" -path '*include/physgen' -type d)")
    # link FLAG LIBRARY: compiles without optimisation and with all of it; what is not needed must be kept all the same.
    link() {
      local level
      for level in -O0 -O3; do
        "$CXX" -std=c++20 "$level" -Wall -Wextra -Wpedantic -Werror ${1:+"$1"} ${SANITIZERS:+"$SANITIZERS"} "-I$include" main.cpp \
          "$libraries/lib$2.a" -o main >output.txt 2>&1 || return 1
      done
    }
    refused() { # refused FLAG LIBRARY SYMBOL
      if link "$1" "$2"; then fail "a program compiled with '$1' links with $2"; fi
      grep -q "undefined .*$3" output.txt || fail "unclear: $(cat output.txt)"
    }
    link -DPHYSGEN_CHECKED physgen_runtime_checked || fail "$(cat output.txt)"
    refused '' physgen_runtime_checked physgen_objects_were_compiled_without_PHYSGEN_CHECKED
    if [[ ! $mode ]]; then
      link '' physgen_runtime || fail "$(cat output.txt)"
      refused -DPHYSGEN_CHECKED physgen_runtime physgen_objects_were_compiled_with_PHYSGEN_CHECKED
    fi
    ;;
  *) fail "there is no rule $rule" ;;
esac
rm -rf "$work"
