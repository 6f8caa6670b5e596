#!/usr/bin/env bash
# readme.sh PAGE FOLDER GENERATOR PROGRAM FILE...: writes the example of a page of documentation below FOLDER, builds it with
# the CMake generator GENERATOR against the package in FOLDER/package, and runs PROGRAM. FILE...: what must be among the
# files.
set -euo pipefail
readme=$1 folder=$2 generator=$3 program=$4 files=("${@:5}")
work="$folder/example of $(basename "$readme")${CXX:+ with $(basename "$CXX")}"
rm -rf "$work"
mkdir -p "$work"
awk -v folder="$work" -f "$(dirname "$0")/../../tools/examples/blocks.awk" "$readme"
for file in "${files[@]}"; do
  [[ -s $work/$file ]] || { echo "FAILED: there is no $file in $readme" >&2; exit 1; }
done
cmake -S "$work" -B "$work/build" -G "$generator" -DCMAKE_DISABLE_FIND_PACKAGE_CUDAToolkit=ON -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS=-march=native \
  -Dphysgen_DIR="$(dirname "$(find "$folder/package" -name physgenConfig.cmake)")"
cmake --build "$work/build"
"$work/build/$program"
rm -rf "$work"
