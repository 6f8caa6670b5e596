#!/usr/bin/env bash
# headers.sh alone|together COMPILER ROOT FLAGS...: whether COMPILER accepts the public headers of the source tree ROOT
# without a warning: those of the runtime each by itself, or all of them, generated ones and those of fem in one source. Of
# CUDA, only what ordinary C++ can include, and that where CUDA_INCLUDE names the folder of the toolkit's headers.
# Together they are compiled behind <complex.h> and <sys/sysmacros.h>, whose macros must not change them. Those for Python
# need pybind11; a test compiles them as a module.
# What most headers include, themselves or by way of others, is what takes time, so it is precompiled, where a header includes
# it; and headers are compiled in chains, in which each one includes the one before it: behind that one it has what it
# includes, and nothing else, as by itself.
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
# chains SHARED...: lines `WHAT HEADER...` that have each of the headers read from the input once. WHAT is the first one of
# SHARED that the headers of the line include, `-` for none; each header but the first includes the one before it. What stands
# under a condition does not count as included.
chains() {
  (cd "$root/runtime/include" && find physgen -name '*.h' -print0 | xargs -0 awk '
    FNR == 1 { conditions = 0 }
    /^# *if/ { ++conditions }
    /^# *endif/ { --conditions }
    /^#include <[^>]*>/ && !conditions { print FILENAME, substr($0, 11, index($0, ">") - 11) }') | awk -v list="$*" '
    function visit(header, all,    others, count, k) {
      count = split(direct[header], others, " ")
      for (k = 1; k <= count; ++k) if (!((all, others[k]) in has)) { has[all, others[k]] = 1; ++size[all]; visit(others[k], all) }
    }
    NR == FNR { direct[$1] = direct[$1] " " $2; next }
    { names[++n] = $1; size[$1] = 0; visit($1, $1) }
    END {
      shared = split(list, wanted, " ")
      for (i = 1; i <= n; ++i) {
        what[names[i]] = "-"
        for (k = shared; k > 0; --k) if ((names[i], wanted[k]) in has) what[names[i]] = wanted[k]
      }
      for (left = n; left > 0; ) {  # the header that includes most, then of what it includes that which includes most, and so on
        for (last = chain = ""; ; --left) {
          next_one = ""
          for (i = 1; i <= n; ++i) {
            header = names[i]
            if (!(header in done) && (last == "" || ((last, header) in has && what[header] == what[last])) &&
                (next_one == "" || size[header] > size[next_one])) next_one = header
          }
          if (next_one == "") break
          done[next_one] = 1; last = next_one; chain = " " next_one chain
        }
        print what[last] chain
      }
    }' - <(printf '%s\n' "${runtime[@]}")
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
    failed=''
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    suffix=pch
    ! "$compiler" --version | grep -q 'Free Software Foundation' || suffix=gch
    shared=(physgen/arrays/array.h physgen/detail/cursor.h physgen/fields/object_info.h Eigen/Core)  # most first
    for header in "${shared[@]}"; do
      echo "#include <$header>" >"$work/${header//\//_}"
      compile -x c++-header "$work/${header//\//_}" -o "$work/${header//\//_}.$suffix"
    done
    while read -ra chain; do
      more=()
      [[ ${chain[0]} == - ]] || more=(-include "$work/${chain[0]//\//_}" -Winvalid-pch)
      compiled+=("${chain[@]:1}")
      accepts "${chain[@]:1}" || failed+=" ${chain[*]:1}"
    done < <(chains "${shared[@]}")
    [[ ! $failed ]] || { echo "FAILED: of these, the ones of the messages above do not compile alone:$failed" >&2; exit 1; }
    ((${#compiled[@]} == ${#runtime[@]})) || { echo "FAILED: ${#compiled[@]} of ${#runtime[@]} headers were compiled" >&2; exit 1; }
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
