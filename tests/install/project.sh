#!/usr/bin/env bash
# project.sh RULES FOLDER GENERATOR: copies the project beside this file below FOLDER, builds it with the CMake generator
# GENERATOR against the package in FOLDER/package, and checks rules of physgen_generate(), one after the other in one build
# folder, since configuring and compiling is what takes time. RULES: with_physgen or without_physgen.
set -euo pipefail
rules=$1 folder=$2 generator=$3
work="$folder/${generator##* } $rules" # with a space: paths are users' paths
package=$folder/package
headers=$work/build/physgen/spring_schemas

rule='' # the one that is checked
fail() { echo "FAILED: ${rule//_/ }: $*" >&2; exit 1; }
configure() {
  # Without the CUDA toolkit: a project that asks for no CUDA needs none, whatever the package has.
  cmake -S "$work/project" -B "$work/build" -G "$generator" -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_DISABLE_FIND_PACKAGE_CUDAToolkit=ON -Dphysgen_DIR="$(dirname "$(find "$package" -name physgenConfig.cmake)")"
}
build() { cmake --build "$work/build"; }
# The times of what a build writes: objects, programs, headers, stamps.
times() { (cd "$work/build" && find . \( -name '*.o' -o -name '*.physgen.h' -o -name '*.stamp' -o -name springs \) -printf '%p %T@\n' | sort); }
time_of() { find "$work/build" -name "$1" -printf '%T@\n'; }
# Fails when the last `times` in $before shows that file $1 was (not) written again.
expect() { # expect same|new FILE
  local now
  now=$(time_of "$2")
  [[ $now ]] || fail "there is no $2"
  if grep -qF " $now" <<<"$before"; then now=same; else now=new; fi
  [[ $now == "$1" ]] || fail "$2 is $now, expected: $1"
}

rm -rf "$work"
mkdir -p "$work"
cp -r "$(dirname "${BASH_SOURCE[0]}")/project" "$work/project"
chmod -R u+w "$work/project"
mkdir "$work/build"
configure_first() { configure >"$work/configure.txt" 2>&1 || { cat "$work/configure.txt"; fail 'the project cannot be configured'; }; }

builds_from_an_installed_package_and_computes() {
  configure_first
  build
  "$work/build/springs" || fail 'the program computes wrong numbers'
}
second_build_does_nothing() {
  build
  [[ $(times) == "$before" ]] || fail "a second build did something: $(diff <(times) <(echo "$before"))"
}
touched_included_header_reruns_physgen_and_recompiles_nothing() {
  touch "$work/project/schemas/dimensions.h"
  build
  expect new spring_schemas.stamp
  expect same springs.physgen.h
  expect same main.cpp.o
  before=$(times)
  build
  [[ $(times) == "$before" ]] || fail 'physgen runs again and again'
}
changed_list_of_schemas_reruns_physgen() {
  sed 's/springs/more/; s/Spring/More/' "$work/project/schemas/springs.h" >"$work/project/schemas/more.h"
  sed -i 's|schemas/springs.h|& schemas/more.h|' "$work/project/CMakeLists.txt"
  build
  expect new more.physgen.h
  expect same springs.physgen.h
  expect same main.cpp.o
}
broken_schema_fails_the_build_and_leaves_the_old_headers() {
  local attempt
  cp "$headers/springs.physgen.h" "$work/old.h"
  sed 's/double damping/double\& damping/' -i "$work/project/schemas/springs.h"
  for attempt in first second; do
    if build >"$work/output.txt" 2>&1; then fail "the $attempt build of a broken schema succeeded"; fi
    grep -q 'springs.h:[0-9]*:[0-9]*: error' "$work/output.txt" || fail "no error with file and line: $(cat "$work/output.txt")"
    cmp "$headers/springs.physgen.h" "$work/old.h" || fail 'the old header was changed'
  done
  sed 's/double& damping/double damping/' -i "$work/project/schemas/springs.h"
  build
  expect same springs.physgen.h
  expect same main.cpp.o
}
changed_included_header_recompiles() {
  sed -i 's/dimensions = 3/dimensions = 2/' "$work/project/schemas/dimensions.h"
  build
  expect new springs.physgen.h
  expect new main.cpp.o
}
package_without_physgen_uses_checked_in_headers() {
  "$package/bin/physgen" generate "$work/project/schemas/springs.h" -o "$work/project/generated"
  package="$folder/package without physgen"
  configure_first
  build
  grep -q 'using the checked-in headers' "$work/configure.txt" || fail 'configuring does not say which headers are used'
  "$work/build/springs" || fail 'the program computes wrong numbers'
  [[ ! -e $headers ]] || fail "$headers exists"
  rm "$work/project/generated/springs.physgen.h"
  if configure >"$work/configure.txt" 2>&1; then fail 'a missing checked-in header is not noticed'; fi
  tr -s ' \n' ' ' <"$work/configure.txt" | grep -q 'has no springs.physgen.h' || fail "unclear: $(cat "$work/configure.txt")"
}

case $rules in
  with_physgen)
    all=(builds_from_an_installed_package_and_computes second_build_does_nothing
      touched_included_header_reruns_physgen_and_recompiles_nothing changed_list_of_schemas_reruns_physgen
      broken_schema_fails_the_build_and_leaves_the_old_headers changed_included_header_recompiles)
    ;;
  without_physgen) all=(package_without_physgen_uses_checked_in_headers) ;;
  *) fail "there are no rules $rules" ;;
esac
for rule in "${all[@]}"; do
  echo "---- ${rule//_/ }"
  before=$(times)
  sleep 0.1 # file times from here on are later than those of what is there
  "$rule"
done
rm -rf "$work"
