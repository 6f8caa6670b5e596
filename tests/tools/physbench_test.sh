#!/usr/bin/env bash
# Tests of physbench's command line: physbench_test.sh RULE PROGRAM FOLDER
set -euo pipefail
rule=$1 program=$2 folder=$3
mkdir -p "$folder"
out=$folder/physbench_$rule.out err=$folder/physbench_$rule.err json=$folder/physbench_$rule.json

fail() { printf '%s: %s\n' "$rule" "$*" >&2; cat "$out" "$err" >&2; exit 1; }
expect_exit() {
  local wanted=$1 got=0
  shift
  "$program" "$@" >"$out" 2>"$err" || got=$?
  ((got == wanted)) || fail "exit $got instead of $wanted: $*"
}
expect() { grep -qE -- "$2" "$1" || fail "not found: $2"; }
small=(--objects=1000 --threads=1 --benchmark_min_time=0.001)

case $rule in
  help_explains_own_and_passed_flags)
    expect_exit 0 --help
    for flag in --threads --objects --table --json --benchmark_filter; do expect "$out" "$flag"; done ;;
  unknown_flag_exits_with_2)
    expect_exit 2 --colour
    expect "$err" 'there is no flag --colour'
    expect_exit 2 --benchmark_colour=1 ;;
  wrong_value_exits_with_2)
    expect_exit 2 --threads=none
    expect "$err" "from 1 to .*'none'"
    expect_exit 2 --objects=0
    expect_exit 2 --objects ;;
  names_are_kernel_layout_storage_space_objects)
    expect_exit 0 --benchmark_list_tests --objects=1000
    expect "$out" '^dp_from_df/aosoa32/float/host/1000$'
    [[ -z $(grep -vE '^[a-z_]+/[a-z_0-9]+/(float|double)/(host|cuda)/[0-9]+$' "$out") ]] || fail 'another kind of name' ;;
  table_has_speed_ups_and_errors)
    expect_exit 0 "${small[@]}" --table --benchmark_filter='^stress_derivative/.*/host/'
    expect "$out" '^CPU, float'
    expect "$out" '^CPU, double'
    expect "$out" 'aosoa16 .*x .*e-0[78]'
    expect "$out" '^threads +1,' ;;
  every_kernel_is_near_its_reference)
    expect_exit 0 "${small[@]}" --json="$json" --benchmark_filter=/host/
    awk -F'[:,] *' '
      $1 ~ /"name"/ { name = $2 }
      $1 ~ /"err_max"/ {
        allowed = name ~ /float/ ? 1e-3 : 2e-12  # add_force_differential nearly cancels
        ++rows
        if (!($2 <= allowed) || $2 == "NaN") { print name, $2; wrong = 1 }
      }
      END { exit wrong || rows < 50 }' "$json" >&2 || fail 'rows as above, or too few'
    ;;
  json_has_counters_and_machine)
    expect_exit 0 "${small[@]}" --json="$json" --benchmark_filter='^svd/aosoa16/float/host/1000$'
    for word in '"name": "svd/aosoa16/float/host/1000"' bytes_per_object GBps copy_fraction err_p50 err_p99 err_max \
      '"cpu"' '"threads"' '"compiler"' '"command"' '"date"'; do
      expect "$json" "$word"
    done ;;
  a_filter_that_matches_nothing_exits_with_1)
    expect_exit 1 --benchmark_filter=no_such_kernel ;;
  *) fail 'no such rule' ;;
esac
