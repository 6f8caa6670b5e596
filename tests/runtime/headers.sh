#!/usr/bin/env bash
# headers.sh alone|together COMPILER ROOT FLAGS...: whether COMPILER accepts the public headers of the source tree ROOT
# without a warning: those of the runtime each by itself, or all of them, generated ones and those of fem in one source. Of
# CUDA, only what ordinary C++ can include, and that where CUDA_INCLUDE names the folder of the toolkit's headers.
# A header that another one includes before anything else is compiled by itself there, and not a second time.
set -euo pipefail
how=$1 compiler=$2 root=$3 flags=("${@:4}")
headers() { # headers FOLDER PATTERN: as they are included
  (cd "$1" && find . -name '*.h' -path "$2" -not -path '*cuda*' -not -path '*/reference/*' -printf '%P\n' | sort)
}
accepts() { # accepts HEADER...: twice, since a header may be included twice
  printf '#include <%s>\n' "$@" "$@" |
    "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wno-unknown-pragmas -Werror \
      "-I$root/runtime/include" "-I$root/generated" "-I$root/generated/scenes" "-I$root/schemas" "-I$root/tools" "${flags[@]}" -x c++ -
}
first_included() { # first_included HEADER...: the header that each has before any other code, where it is one of the runtime
  local header
  for header in "$@"; do
    [[ ! -e $root/runtime/include/$header ]] ||
      sed -nE '/^(\/\/.*|#pragma once)?$/d; s/^#include <(physgen\/.*)>.*$/\1/p; q' "$root/runtime/include/$header"
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
    failed=
    mapfile -t alone < <(comm -23 <(printf '%s\n' "${runtime[@]}" | sort) <(first_included "${runtime[@]}" | sort -u))
    for header in "${alone[@]}"; do accepts "$header" || failed+=" $header"; done
    [[ ! $failed ]] || { echo "FAILED: these do not compile alone:$failed" >&2; exit 1; }
    ;;
  together) accepts "${runtime[@]}" "${others[@]}" ;;
esac
