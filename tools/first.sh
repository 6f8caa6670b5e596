# shellcheck shell=bash disable=SC2154
# What a newcomer runs first: README's example in a minute, and a first table of measurements. tools/dev sources this file and
# calls try_example and run; its $root, $build and functions setup, build, jobs, has_gpu, say and fail are used here.

# Compiles by g++ alone, over the headers in generated/. Paths are relative to $root, so that it may have spaces.
flags_of_try='-std=c++20 -O2 -march=native -isystem /usr/include/eigen3 -isystem /usr/local/include/eigen3
  -Iruntime/include -Igenerated -Igenerated/examples -Ibuild/try'
# Compiles the sources whose objects are not newer than all that they could include, as many at once as there are cores.
compile_for_try() {
  local source object=''
  for source in "$@"; do
    object=build/try/${source//\//_}.o
    [[ -e $object && ! $(find -L README.md generated runtime tools/examples -newer "$object" -type f -print -quit) ]] ||
      printf '%s\0%s\0' "$source" "$object"
  done | xargs -0r -n 2 -P "$(jobs)" bash -c 'g++ $0 -c "$1" -o "$2" || exit 255' "$flags_of_try"
}

try_example() {
  (($# == 0)) || fail "try takes no arguments, not $*"
  local program
  say '1 of 3: packages: g++, and the headers of Eigen, xsimd and oneTBB'
  setup try
  say "2 of 3: compile README's example, a comparison of layouts and the runtime; half a minute on two cores"
  cd "$root"
  mkdir -p build/try
  awk -v folder=build/try -f tools/examples/blocks.awk README.md
  # The runtime as one source, since reading the headers that its files share is what takes time.
  printf '#include "../../%s"\n' runtime/src/*.cpp runtime/src/no_cuda/*.cpp >build/try/runtime.cpp
  compile_for_try build/try/runtime.cpp tools/examples/layouts.cpp build/try/pressure.cpp
  for program in build_try_pressure tools_examples_layouts; do
    g++ build/try/{"$program",build_try_runtime}.cpp.o -ltbb -o "build/try/${program##*_}"
  done
  say '3 of 3: run'
  build/try/pressure
  echo
  build/try/layouts
  cat <<'TEXT'

The example's files are build/try/stress.h and pressure.cpp, as README has them. To change the schema takes the command
physgen, which needs LLVM (tools/dev build).
Next: tools/dev run. It installs CMake, Ninja, CLI11, Boost and Google Benchmark, compiles for a minute and a half on two
cores, and prints how fast three kernels of finite elements are in each layout, on a GPU, too, where there is one: four
minutes on a fresh Debian.
TEXT
}

# Builds no more than is run: only what a first table needs, unless other rows are asked for; on a machine without a GPU no
# CUDA rows. The headers in generated/ do, unless a schema differs from the last commit.
run() {
  local program=physbench_first preset=first argument
  for argument in "$@"; do
    case $argument in
      errors | replay) program=physbench_errors; break ;;
      linear_solves) program=physbench_solves preset=release; break ;;
      --threads* | --objects* | --json* | --table | --benchmark_out* | [0-9]*) ;;
      *) program=physbench_cpu ;;
    esac
  done
  if [[ $(git -C "$root" status --porcelain -- schemas 2>/dev/null) ]]; then
    say 'schemas differ from the last commit: the generator is built, too'
    preset=release
  elif [[ -e $build/release/CMakeCache.txt ]]; then
    preset=release
  fi
  say '1 of 3: packages'
  setup "$preset"
  if ! has_gpu; then
    say 'no CUDA rows: this machine has no GPU (nvidia-smi -L lists none)'
  elif [[ $program != physbench_first && $program != physbench_solves ]]; then
    program=physbench
  fi
  say '2 of 3: compile; for a first table about a minute and a half on two cores'
  build "$preset" "$program"
  say '3 of 3: measure'
  "$build/$preset/bin/$program" "$@"
  if (($# == 0)); then
    cat <<'TEXT'

Each line is one kernel over one layout: `vs aos` says how many times as fast it is as over an array of structs, and
`/copy` compares it with a plain copy of its bytes, which is as fast as memory allows (1.00).
Next: declare an object of your own (README.md), compress the cube (tools/dev build release truthcube, then
build/release/bin/truthcube), measure a GPU (tools/dev gpu), or measure every kernel (tools/dev run --all).
TEXT
  fi
}
