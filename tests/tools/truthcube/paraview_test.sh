#!/usr/bin/env bash
# paraview_test.sh TRUTHCUBE SOFTBODY EXAMPLE PVPYTHON FOLDER: opens the files of the case of the example softbody, in the
# folder EXAMPLE, and those of its program in ParaView.
set -euo pipefail
truthcube=$1 softbody=$2 example=$3 pvpython=$4 folder=$5
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export OMP_NUM_THREADS=1
cp "$example/case.json" .
python3 "$example/lobe.py" 4 lobe.msh
"$truthcube" --case case.json --threads 1 --quiet --out lobe
"$softbody" lobe.msh
"$pvpython" "$here/paraview_test.py" lobe.xdmf lobe/cube.xdmf
