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
# what_headers_include SHARED...: of each header of the runtime, the first one of SHARED that it includes, itself or by way of
# others; and the header that it has before any other code, if that includes this one, too. `-` for none.
what_headers_include() {
  (cd "$root/runtime/include" && find physgen -name '*.h' -print0 | xargs -0 awk -v list="$*" '
    FNR == 1 { behind_code = 0; names[FILENAME] = first[FILENAME] = "-" }
    /^#include <[^>]*>/ {
      name = substr($0, 11, index($0, ">") - 11)
      direct[FILENAME] = direct[FILENAME] " " name
      if (!behind_code && name ~ /^physgen\//) first[FILENAME] = name
    }
    !/^(\/\/.*|#pragma .*|#undef I)?$/ { behind_code = 1 }
    function visit(header,    others, count, k) {
      count = split(direct[header], others, " ")
      for (k = 1; k <= count; ++k) if (!(others[k] in seen)) { seen[others[k]] = 1; visit(others[k]) }
    }
    END {
      shared = split(list, wanted, " ")
      for (header in names) {
        split("", seen)
        visit(header)
        found = "-"
        for (k = shared; k > 0; --k) if (wanted[k] in seen) found = wanted[k]
        split("", seen)
        visit(first[header])
        print header, found, found == "-" || found in seen ? first[header] : "-"
      }
    }')
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
    shared=(physgen/arrays/array.h physgen/detail/cursor.h physgen/fields/object_info.h Eigen/Core)  # most first
    for header in "${shared[@]}"; do
      echo "#include <$header>" >"$work/${header//\//_}"
      compile -x c++-header "$work/${header//\//_}" -o "$work/${header//\//_}.$suffix"
    done
    declare -A precompiled
    while read -r header included first; do
      precompiled[$header]=$included elsewhere+="$first "
    done < <(what_headers_include "${shared[@]}")
    for header in "${runtime[@]}"; do
      [[ $elsewhere != *" $header "* ]] || continue
      more=()
      [[ ${precompiled[$header]} == - ]] || more=(-include "$work/${precompiled[$header]//\//_}" -Winvalid-pch)
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
