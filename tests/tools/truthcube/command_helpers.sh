# shellcheck shell=bash
# The words in which tests of commands are written. Tests set rule and program before they source this.
fail() { printf '%s: %s\n' "$rule" "$*" >&2; cat out err >&2; exit 1; }
# Runs the command; its output is in the files out and err.
expect_exit() {
  local wanted=$1 got=0
  shift
  "$program" "$@" >out 2>err || got=$?
  ((got == wanted)) || fail "exit $got instead of $wanted: $*"
}
expect() { grep -qE -- "$2" "$1" || fail "not found in $1: $2"; }
expect_no() { ! grep -qE -- "$2" "$1" || fail "found in $1: $2"; }
expect_same() { cmp "$1" "$2" >&2 || fail "$1 and $2 differ"; }
expect_refused() { # pattern arguments...
  expect_exit 2 "${@:2}"
  expect err "$1"
  [[ ! -s out ]] || fail 'output in spite of an error'
}
number_of() { grep -oE "\"$1\": [-+.0-9e]+" "$2" | sed 's/.*: //'; }
