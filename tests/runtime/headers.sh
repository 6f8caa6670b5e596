#!/usr/bin/env bash
# headers.sh alone|together COMPILER ROOT FLAGS...: whether COMPILER accepts the public headers of the source tree ROOT
# without a warning: those of the runtime each by itself, or all of them, generated ones and those of fem in one source. Of
# CUDA, only what ordinary C++ can include, and that where CUDA_INCLUDE names the folder of the toolkit's headers.
# Together they are compiled behind <complex.h> and <sys/sysmacros.h>, whose macros must not change them. Those for Python
# need pybind11; a test compiles them as a module.
# What most headers include, themselves or by way of others, is what takes time, so it is precompiled. A header that another
# one includes before anything else is compiled by itself there, and not a second time; but where it comes behind what is
# precompiled, it must include that, too.
set -euo pipefail
how=$1 compiler=$2 root=$3 flags=("${@:4}")
headers() { # headers FOLDER PATTERN: as they are included
  (cd "$1" && find . -name '*.h' -path "$2" -not -path '*cuda*' -not -path './physgen/python/*' -not -path '*/reference/*' -printf '%P\n' | sort)
}
compile() { # compile FLAG... -x LANGUAGE FILE
  "$compiler" -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wno-unknown-pragmas -Werror \
    "-I$root/runtime/include" "-I$root/generated" "-I$root/generated/scenes" "-I$root/schemas" "-I$root/tools" "-I$root/tools/fem/solver" "${flags[@]}" "$@"
}
more=()
accepts() { # accepts HEADER...: twice, since a header may be included twice
  printf '#include <%s>\n' "$@" "$@" | compile -fsyntax-only "${more[@]}" -x c++ -
}
declare -A included precompiled
find_included() { # find_included HEADER: all that a header includes, itself or by way of others of the runtime
  local text=$root/runtime/include/$1 other more
  [[ -e $text && ! ${included[$1]-} ]] || return 0
  included[$1]=' '
  for other in $(sed -nE 's/^#include <([^>]*)>.*$/\1/p' "$text"); do
    find_included "$other"
    for more in "$other" ${included[$other]-}; do
      [[ ${included[$1]} == *" $more "* ]] || included[$1]+="$more "
    done
  done
}
first_included() { # first_included HEADER: the header of the runtime that it has before any other code
  sed -nE '/^(\/\/.*|#pragma .*|#undef I)?$/d; s/^#include <(physgen\/.*)>.*$/\1/p; q' "$root/runtime/include/$1"
}

mapfile -t runtime < <(headers "$root/runtime/include" '*')
mapfile -t others < <(headers "$root/generated" '*'; headers "$root/tools" './fem/*')
if [[ ${CUDA_INCLUDE-} ]]; then
  runtime+=(physgen/cuda/check.h)
  flags+=(-isystem "$CUDA_INCLUDE")
fi
((${#runtime[@]} > 30 && ${#others[@]} > 20)) || { echo "FAILED: hardly any header in $root" >&2; exit 1; }
case $how in
  alone)
    failed='' elsewhere=' '
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    suffix=pch
    ! "$compiler" --version | grep -q 'Free Software Foundation' || suffix=gch
    shared=(physgen/arrays/array.h physgen/detail/cursor.h physgen/fields/object_info.h Eigen/Core)  # each includes the next
    for header in "${shared[@]}"; do
      echo "#include <$header>" >"$work/${header//\//_}"
      compile -x c++-header "$work/${header//\//_}" -o "$work/${header//\//_}.$suffix"
    done
    for header in "${runtime[@]}"; do
      find_included "$header"
      for other in "${shared[@]}"; do
        [[ ${included[$header]} != *" $other "* ]] || { precompiled[$header]=$other; break; }
      done
    done
    for header in "${runtime[@]}"; do
      first=$(first_included "$header")
      if [[ ! ${precompiled[$header]-} || ${included[$first]-} == *" ${precompiled[$header]} "* ]]; then elsewhere+="$first "; fi
    done
    for header in "${runtime[@]}"; do
      [[ $elsewhere != *" $header "* ]] || continue
      more=()
      [[ ! ${precompiled[$header]-} ]] || more=(-include "$work/${precompiled[$header]//\//_}" -Winvalid-pch)
      accepts "$header" || failed+=" $header"
    done
    [[ ! $failed ]] || { echo "FAILED: these do not compile alone:$failed" >&2; exit 1; }
    ;;
  together)  # but for the vocabulary of schemas, which no program includes beside a generated header
    # As CMake compiles by default, and behind system headers that define macros of ordinary names: I, major, minor.
    flags+=(-std=gnu++20 -include complex.h -include sys/sysmacros.h)
    work=$(mktemp -d) # with the header that the build of tools/fem/solver writes
    trap 'rm -rf "$work"' EXIT
    (cd "$root/generated/scenes" && printf '#include <%s>\n' *.scene.h) >"$work/solved_scenes.h"
    flags+=("-I$work")
    programs=()
    for header in "${runtime[@]}"; do [[ $header == physgen/schema.h ]] || programs+=("$header"); done
    accepts "${programs[@]}" "${others[@]}"
    ;;
esac
