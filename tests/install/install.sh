#!/usr/bin/env bash
# install.sh BUILD FOLDER: installs BUILD into FOLDER/package (everything) and FOLDER/package without physgen (as built
# without LLVM). Each is installed elsewhere first and moved: a package must not depend on where it lies. Also
# checks that uninstalling leaves nothing.
set -euo pipefail
build=$1 folder=$2
install() { cmake --install "$build" --component "$1" --prefix "$2" >/dev/null; }

cd "$folder"
rm -rf package 'package without physgen' first second
install runtime first
cp -a first second
install generator second
install solver second

# By components, so that the manifest of somebody's own installation from this build folder stays.
for component in runtime generator solver; do
  install "$component" "$folder/third"
  cmake -D MANIFEST="$build/install_manifest_$component.txt" -P "$build/package/uninstall.cmake" >/dev/null
done
left=$(find third -not -type d)
[[ ! $left ]] || { echo "uninstalling left these: $left" >&2; exit 1; }
left=$(find third -name 'physgen*' -o -path '*/doc/*')
[[ ! $left ]] || { echo "uninstalling left the folders $left" >&2; exit 1; }
rm -rf third

mv first 'package without physgen'
mv second package
for place in package 'package without physgen'; do
  [[ -x $place/bin/physgen-convert-mesh ]] || { echo "$place lacks the command that converts meshes" >&2; exit 1; }
done
