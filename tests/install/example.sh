#!/usr/bin/env bash
# example.sh NAME FOLDER GENERATOR: copies the example NAME out of the package in FOLDER/package, builds it with the CMake
# generator GENERATOR by the command that its page has, and runs it. The page must have what the program prints, where it
# prints the same on every machine: the first words of each line.
set -euo pipefail
name=$1 folder=$2 generator=$3
from=$(find "$folder/package" -type d -path "*/examples/$name")
[[ $from ]] || { echo "FAILED: there is no example $name in $folder/package" >&2; exit 1; }
work="$folder/example $name"
rm -rf "$work"
cp -r "$from" "$work"
without_cuda=(-DCMAKE_DISABLE_FIND_PACKAGE_CUDAToolkit=ON)
[[ $name == softbody ]] && without_cuda=()  # its solver may have been built with CUDA
cmake -S "$work" -B "$work/build" -G "$generator" "${without_cuda[@]}" \
  -DPython_EXECUTABLE=/usr/bin/python3 -Dphysgen_DIR="$(dirname "$(find "$folder/package" -name physgenConfig.cmake)")"
cmake --build "$work/build"
program=("$work/build/$name")
if [[ -e $work/main.py ]]; then
  program=(env "PYTHONPATH=$work/build" /usr/bin/python3 "$work/main.py")
fi
if [[ -e $work/lobe.py ]]; then
  cd "$work"
  /usr/bin/python3 lobe.py 12 lobe.msh
  program+=(lobe.msh)
fi
"${program[@]}" | tee "$work/printed"
while read -r words; do
  grep -qF -- "$words" "$work/README.md" || { echo "FAILED: the page of $name lacks what it prints: $words" >&2; exit 1; }
done < <(sed 's/  .*//' "$work/printed")
for picture in $(grep -oP '!\[[^]]*\]\(\K[^)]+' "$work/README.md"); do
  [[ -s $work/$picture ]] || { echo "FAILED: the example $name has no picture $picture" >&2; exit 1; }
done
cd "$folder"
rm -rf "$work"
