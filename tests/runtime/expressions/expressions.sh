#!/usr/bin/env bash
# expressions.sh WORK_FOLDER COMPILER FLAGS...: compiles expressions.cpp and runs it; where the flags have sanitizers,
# they say what refers to a stack that is gone. -ffp-contract=off: both forms of an expression round alike.
# EIGEN_DONT_VECTORIZE: values are added as packs are, named matrices of one object by Eigen's own vectors in another order.
set -euo pipefail
work=$1 compiler=$2
shift 2
mkdir -p "$work"
program=$(mktemp "$work/expressions.XXXXXX")
trap 'rm -f "$program"' EXIT
"$compiler" -std=c++20 -ffp-contract=off -DEIGEN_DONT_VECTORIZE -Wno-unknown-pragmas "$@" -o "$program" "$(dirname "$0")/expressions.cpp"
ASAN_OPTIONS=detect_stack_use_after_return=1 "$program"
