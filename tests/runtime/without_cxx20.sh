#!/usr/bin/env bash
# without_cxx20.sh COMPILER FLAGS...: compiles a generated header as C++17 and fails unless the first error says what to do.
set -euo pipefail
if output=$("$1" -std=c++17 -c "${@:2}" - -o /dev/null <<<'#include <elasticity.physgen.h>' 2>&1); then
  echo 'FAILED: it compiles' >&2
  exit 1
fi
first=$(grep -m1 error <<<"$output")
[[ $first == *'physgen needs C++20 (g++: -std=c++20, nvcc: -std=c++20)'* ]] || { echo "FAILED: the first error is $first" >&2; exit 1; }
