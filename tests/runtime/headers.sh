#!/usr/bin/env bash
# headers.sh alone|together COMPILER ROOT FLAGS...: whether COMPILER accepts the public headers of the source tree ROOT
# without a warning: those of the runtime each by itself, or all of them, generated ones and those of fem in one source. Of
# CUDA, only what ordinary C++ can include, and that where CUDA_INCLUDE names the folder of the toolkit's headers.
# Together they are compiled behind <complex.h> and <sys/sysmacros.h>, whose macros must not change them. Those for Python
# need pybind11; a test compiles them as a module.
# A header that another one includes before anything else is compiled by itself there, and not a second time. Those that
# include Eigen, itself or by way of others, take it from one precompiled header where the compiler is g++: reading it is
# what takes time.
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
declare -A eigen
includes_eigen() { # includes_eigen HEADER: of the runtime, whether it does, itself or by way of others
  local text=$root/runtime/include/$1 other
  [[ -e $text ]] || return 1
  if [[ ! ${eigen[$1]-} ]]; then
    eigen[$1]=$(grep -q '^#include <Eigen/' "$text" && echo yes || echo no)
    for other in $(sed -nE 's/^#include <(physgen\/[^>]*)>.*$/\1/p' "$text"); do
      if includes_eigen "$other"; then eigen[$1]=yes; fi
    done
  fi
  [[ ${eigen[$1]} == yes ]]
}
first_included() { # first_included HEADER...: the header that each has before any other code, where it is one of the runtime
  local header
  for header in "$@"; do
    [[ ! -e $root/runtime/include/$header ]] ||
      sed -nE '/^(\/\/.*|#pragma .*|#undef I)?$/d; s/^#include <(physgen\/.*)>.*$/\1/p; q' "$root/runtime/include/$header"
  done
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
    failed='' precompiled=()
    if "$compiler" --version | grep -q 'Free Software Foundation'; then
      work=$(mktemp -d)
      trap 'rm -rf "$work"' EXIT
      echo '#include <Eigen/Core>' >"$work/eigen.h"
      compile -x c++-header "$work/eigen.h" -o "$work/eigen.h.gch"
      precompiled=(-include "$work/eigen.h" -Winvalid-pch)
    fi
    mapfile -t alone < <(comm -23 <(printf '%s\n' "${runtime[@]}" | sort) <(first_included "${runtime[@]}" | sort -u))
    for header in "${alone[@]}"; do
      more=()
      if includes_eigen "$header"; then more=("${precompiled[@]}"); fi
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
