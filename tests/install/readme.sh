#!/usr/bin/env bash
# readme.sh README FOLDER GENERATOR: writes the example of README (each block of code after a line that begins with a
# file's name in backticks) below FOLDER, and builds and runs it with the CMake generator GENERATOR against the package
# in FOLDER/package.
set -euo pipefail
readme=$1 folder=$2 generator=$3
work="$folder/readme example"
rm -rf "$work"
mkdir -p "$work"
awk -v folder="$work" '
  /^`[A-Za-z_.]+`/ { split($0, parts, "`"); name = parts[2]; next }
  /^```/ { open = !open && name != ""; if (!open) name = ""; next }
  open { print >(folder "/" name) }
  !NF { if (!open) name = "" }' "$readme"
for file in stress.h CMakeLists.txt pressure.cpp; do
  [[ -s $work/$file ]] || { echo "FAILED: there is no $file in $readme" >&2; exit 1; }
done
# The two lines that every project begins with are left out of the README.
grep -q '^project(' "$work/CMakeLists.txt" ||
  sed -i '1i cmake_minimum_required(VERSION 3.20)\nproject(example LANGUAGES CXX)' "$work/CMakeLists.txt"
cmake -S "$work" -B "$work/build" -G "$generator" -DCMAKE_DISABLE_FIND_PACKAGE_CUDAToolkit=ON \
  -Dphysgen_DIR="$(dirname "$(find "$folder/package" -name physgenConfig.cmake)")"
cmake --build "$work/build"
"$work/build/pressure"
rm -rf "$work"
