#!/usr/bin/env bash
# packages.sh BUILD FOLDER: makes Debian's packages of BUILD, checks what they say and hold, and unpacks them into
# FOLDER/debian/package, against which an example is then built.
set -euo pipefail
build=$1 folder=$2/debian
fail() { echo "FAILED: $*" >&2; exit 1; }
rm -rf "$folder"
mkdir -p "$folder"
(cd "$build" && cpack -G DEB -B "$folder/made") >"$folder/cpack.txt" 2>&1 || fail "$(cat "$folder/cpack.txt")"
for package in libphysgen-dev physgen; do
  file=$(echo "$folder/made/${package}"_*.deb)
  [[ -f $file ]] || fail "there is no package $package"
  dpkg-deb -x "$file" "$folder/package"
done
version=$(dpkg-deb -f "$folder"/made/libphysgen-dev_*.deb Version)
needed=$(dpkg-deb -f "$folder"/made/libphysgen-dev_*.deb Depends)
for word in libeigen3-dev libxsimd-dev libtbb-dev cmake; do
  [[ " $needed" == *" $word"* ]] || fail "libphysgen-dev does not need $word, but $needed"
done
recommended=$(dpkg-deb -f "$folder"/made/libphysgen-dev_*.deb Recommends)
[[ $recommended == *"g++"*"make"* ]] || fail "libphysgen-dev recommends neither a compiler nor make, but $recommended"
needed=$(dpkg-deb -f "$folder"/made/physgen_*.deb Depends)
for word in "libphysgen-dev (= $version)" libclang-common- libclang-cpp libc6; do
  [[ " $needed" == *" $word"* ]] || fail "physgen does not need $word, but $needed"
done
outside=$(find "$folder/package" -type f -not -path "$folder/package/usr/*")
[[ ! $outside ]] || fail "these lie outside of /usr: $outside"
named=$(grep -rlF --include='*.cmake' --include='*.h' --include='*.md' -e "$build" "$folder/package") && fail "these name the build's folder: $named"
[[ $("$folder/package/usr/bin/physgen" --version) == *"$version"* ]] || fail "the command is not of version $version"
rm -r "$folder/made"
