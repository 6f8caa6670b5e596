#!/usr/bin/env bash
# builds.sh RULE FOLDER GENERATOR PHYSGEN MODULE: builds the project in builds/ in FOLDER with the CMake generator
# GENERATOR, and checks one rule of what physgen_generate(), which MODULE defines, writes anew. No compiler is needed.
set -euo pipefail
rule=$1 generator=$3 physgen=$4 module=$5
work="$2/${generator##* } $rule"  # with a space: paths are users' paths
source=$work/source build=$work/build command=$work/command

fail() { echo "FAILED: $*" >&2; exit 1; }
build() {
  [[ -e $build/CMakeCache.txt ]] || cmake -S "$source" -B "$build" -G "$generator" -D "PHYSGEN=$command" -D "MODULE=$module" >/dev/null
  cmake --build "$build" >/dev/null
}
calls() { printf '%s\nadd_custom_target(all_of_it ALL DEPENDS %s)\n' "$1" "$2" >"$source/call.cmake"; }
schema() { # schema FILE OBJECT
  printf '#include <physgen/schema.h>\n#include "value.h"\nnamespace m {\nusing namespace physgen::schema;
struct PHYSGEN_OBJECT() %s {\n  PHYSGEN(initial(VALUE)) Scalar x;\n};\n}\n' "$2" >"$source/$1"
}

rm -rf "$work"
mkdir -p "$work"
cp -r "$(dirname "${BASH_SOURCE[0]}")/builds" "$source"
chmod -R u+w "$source"
ln -s "$physgen" "$command"
echo '#define VALUE 1' >"$source/value.h"
schema a.h A
schema b.h B

case $rule in
  a_header_whose_schema_left_the_list_is_removed)
    calls 'physgen_generate(TARGET s SCHEMAS a.h b.h)' s_headers
    build
    [[ -e $build/physgen/s/b.physgen.h ]] || fail 'b.physgen.h was not written'
    mv "$source/b.h" "$source/c.h"
    calls 'physgen_generate(TARGET s SCHEMAS a.h c.h)' s_headers
    build
    [[ $(cd "$build/physgen/s" && echo *.h) == 'a.physgen.h c.physgen.h' ]] || fail "there are $(ls "$build/physgen/s")"
    ;;
  a_header_in_a_source_folder_stays_when_its_schema_leaves_the_list)
    for build in "$build" "$source"; do  # apart, and in the source folder itself
      calls "physgen_generate(TARGET s SCHEMAS a.h b.h OUTPUT_DIR \"$source/generated\")" s_headers
      build
      calls "physgen_generate(TARGET s SCHEMAS a.h OUTPUT_DIR \"$source/generated\")" s_headers
      build
      [[ -e $source/generated/b.physgen.h ]] || fail "a header that may be checked in was removed, built in $build"
    done
    ;;
  headers_that_an_older_checkout_left_in_the_build_folder_are_removed_and_named)
    # No record of what was written: an older checkout kept none, or kept it elsewhere.
    tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd -P)
    mkdir -p "$build/generated/examples"
    older=(moved.scene.h moved.program.h moved.need.json old.physgen.h)
    others=(notes.h a.physgen.h.orig examples/old.physgen.h)  # not physgen's, or in a folder that is not looked at
    for file in "${older[@]}" "${others[@]}"; do echo '// as an older checkout wrote it' >"$build/generated/$file"; done
    calls 'physgen_generate(TARGET s SCHEMAS a.h b.h OUTPUT_DIR ${CMAKE_BINARY_DIR}/generated)' s_headers
    printf 'include("%s")\nphysgen_remove_older_headers(${CMAKE_BINARY_DIR}/generated)\n' \
      "$tree/tools/cmake/physgen_older_build.cmake" >>"$source/call.cmake"
    said=$(cmake -S "$source" -B "$build" -G "$generator" -D "PHYSGEN=$command" -D "MODULE=$module" 2>&1)
    for file in "${older[@]}"; do
      [[ ! -e $build/generated/$file ]] || fail "$file stays, which nothing writes"
      [[ $said == *"$file"* ]] || fail "nothing says that $file was removed: $said"
    done
    build
    for file in "${others[@]}" a.physgen.h b.physgen.h; do
      [[ -e $build/generated/$file ]] || fail "$file is gone"
    done
    said=$(cmake "$build" 2>&1)
    [[ $said != *"an older checkout wrote"* ]] || fail "headers of today were removed: $said"
    [[ -e $build/generated/b.physgen.h ]] || fail 'configuring again removed b.physgen.h'
    ;;
  what_is_saved_while_physgen_runs_is_read_by_the_next_build)
    rm "$command"
    # Once, value.h is saved between reading and the end: when the header is written.
    cat >"$command" <<TEXT
#!/bin/sh
"$physgen" "\$@" || exit
[ -e "$work/once" ] && exit
touch "$work/once"
echo '#define VALUE 2' >"$source/value.h"
touch -d "\$(stat -c %z "$build/physgen/s/a.physgen.h")" "$source/value.h"
TEXT
    chmod +x "$command"
    calls 'physgen_generate(TARGET s SCHEMAS a.h)' s_headers
    build
    grep -q 'Initially 1' "$build/physgen/s/a.physgen.h" || fail 'the first build did not read value.h'
    build
    grep -q 'Initially 2' "$build/physgen/s/a.physgen.h" || fail 'the header is stale'
    before=$(find "$build" -name s.stamp -printf '%T@')
    build
    [[ $(find "$build" -name s.stamp -printf '%T@') == "$before" ]] || fail 'physgen runs again and again'
    ;;
  programs_of_scenes_are_read_with_the_definitions_of_their_libraries)
    rm "$command"
    # Writes its arguments, and the stamp.
    cat >"$command" <<TEXT
#!/bin/sh
printf '%s\n' "\$@" >>"$work/arguments"
for word; do
  case \$before in --stamp) : >"\$word" ;; --depfile) echo "\${word%.d}.stamp:" >"\$word" ;; esac
  before=\$word
done
TEXT
    chmod +x "$command"
    library='add_library(inner INTERFACE)\ntarget_compile_definitions(inner INTERFACE [[TEXT="a b"]] WIDTH=%s PHYSGEN_CHECKED)
add_library(kernels INTERFACE)\ntarget_link_libraries(kernels INTERFACE inner)\n'
    # shellcheck disable=SC2059
    calls "$(printf "$library" 4)
physgen_generate_scenes(TARGET s SCENES a.h LIBRARIES kernels FLAGS -march=native)" s_scenes
    build
    for word in -DWIDTH=4 '-DTEXT="a b"' -march=native; do
      grep -qxF -e "$word" "$work/arguments" || fail "no $word in $(cat "$work/arguments")"
    done
    ! grep -q PHYSGEN_CHECKED "$work/arguments" || fail 'checks are no part of what a program needs'
    # shellcheck disable=SC2059
    calls "$(printf "$library" 8)
physgen_generate_scenes(TARGET s SCENES a.h LIBRARIES kernels FLAGS -march=native)" s_scenes
    build
    grep -qxF -e -DWIDTH=8 "$work/arguments" || fail 'a changed definition changes nothing'
    ;;
  *) fail "there is no rule $rule" ;;
esac
