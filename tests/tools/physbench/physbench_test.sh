#!/usr/bin/env bash
# Tests of physbench's command line: physbench_test.sh RULE PROGRAM FOLDER ALL_ROWS, where ALL_ROWS is ON of a program with all rows
set -euo pipefail
rule=$1 program=$2 folder=$3 all_rows=$4
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
expect_no() { ! grep -qE -- "$2" "$1" || fail "found: $2"; }
values() { sed 's/, "/,\n"/g; s/}\(,\?\)$/\n}\1/' "$json"; }  # a line each, as awk reads them
small=(--objects=1000 --threads=1 --benchmark_min_time=0.001)

case $rule in
  help_explains_own_and_passed_flags)
    expect_exit 0 --help
    for flag in errors replay --threads --objects --table --json --benchmark_filter; do expect "$out" "$flag"; done ;;
  unknown_flag_exits_with_2)
    expect_exit 2 --colour
    expect "$err" 'there is no flag --colour'
    expect_exit 2 --object=1000
    expect "$err" 'did you mean --objects[?]'
    expect_exit 2 --benchmark_colour=1 ;;
  wrong_value_exits_with_2)
    expect_exit 2 --threads=none
    expect "$err" "from 1 to .*'none'"
    expect_exit 2 --objects=0
    expect_exit 2 --objects ;;
  names_are_kernel_layout_storage_space_objects_set)
    expect_exit 0 --benchmark_list_tests --objects=1000
    expect "$out" '^dp_from_df/aosoa32/float/host/1000$'
    expect "$out" '^svd_3_sweeps/aosoa16/double/host/1000/near_rest$'
    ! grep -qvE '^[a-z_0-9]+/[a-z_0-9]+/(float|double)/(host|cuda)/[0-9]+(/(random|near_rest|hard))?$' "$out" ||
      fail 'another kind of name' ;;
  table_has_speed_ups_and_errors)
    expect_exit 0 "${small[@]}" --table --benchmark_filter='^stress_derivative/.*/host/[0-9]+$'
    expect "$out" '^CPU, float'
    expect "$out" '^CPU, double'
    expect "$out" 'aosoa16 .*x .*e-0[78]'
    expect "$out" '^threads +1,' ;;
  table_of_storage_schemes_compares_them_with_aos)
    expect_exit 0 storage "${small[@]}" --table --benchmark_filter='/host/'
    expect "$out" '^CPU, float'
    expect "$out" ' 128  aosoa16 quaternion_half +[0-9.]+ +[0-9.]+ +[0-9.]+ +[0-9.]+x '
    expect_no "$out" '^CPU, quaternion' ;;
  every_kernel_is_near_its_reference)
    expect_exit 0 "${small[@]}" --json="$json" --benchmark_filter='/host/[0-9]+$'
    awk -F'[:,] *' '
      $1 ~ /"name"/ { name = $2 }
      $1 ~ /"err_max"/ {
        allowed = name ~ /float/ ? 1e-3 : 2e-12  # add_force_differential nearly cancels
        ++rows
        if (!($2 <= allowed) || $2 == "NaN") { print name, $2; wrong = 1 }
      }
      END { exit wrong || rows < 50 }' <(values) >&2 || fail 'rows as above, or too few'
    ;;
  every_group_has_rows_near_their_reference)
    for group in storage:10:2e-2 conversions:12:1e-7 gathers:8:1e-3 forces:5:1e-2 reduce:4:1e-6 growth:6:1e-3; do
      IFS=: read -r name least allowed <<<"$group"
      filter='/host/'
      [[ $name != growth ]] || filter='/host/(1024|2048)$'
      [[ $name != reduce ]] || filter='/host/262144$'
      expect_exit 0 "$name" "${small[@]}" --json="$json" --benchmark_filter="$filter"
      awk -F'[:,] *' -v least="$least" -v allowed="$allowed" '
        $1 ~ /"name"/ { name = $2; ++rows }
        $1 ~ /"err_max"/ && (!($2 <= (name ~ /bfloat16/ ? 0.3 : allowed)) || $2 == "NaN") { print name, $2; wrong = 1 }
        END { if (rows < least) print rows, "rows"; exit wrong || rows < least }' <(values) >&2 || fail "group $name: rows as above"
    done ;;
  json_has_counters_and_machine)
    expect_exit 0 "${small[@]}" --json="$json" --benchmark_filter='^svd/aosoa16/float/host/1000$'
    for word in '"name": "svd/aosoa16/float/host/1000"' bytes_per_object GBps copy_fraction err_p50 err_p99 err_p9999 \
      err_max '"cpu"' '"threads"' '"compiler"' '"command"' '"date"'; do
      expect "$json" "$word"
    done ;;
  json_has_a_row_a_line)
    expect_exit 0 "${small[@]}" --json="$json" --benchmark_filter='^(svd|stress)/aosoa16/float/host/1000$'
    expect "$json" '^ *[{]"name": "stress/aosoa16/float/host/1000", .*"err_max": .*[}],?$'
    is_formed='import sys; sys.path.insert(0, sys.argv[1]); import result_lines; print(result_lines.is_formed(open(sys.argv[2]).read()))'
    [[ $(/usr/bin/python3 -B -c "$is_formed" "${BASH_SOURCE%/*}/../../../tools/report" "$json") == True ]] || fail 'other lines' ;;
  json_names_the_compiled_kernels_of_rows)
    expect_exit 0 "${small[@]}" --json="$json" --benchmark_filter='^svd/aosoa16/float/host/1000$'
    expect "$json" '"results_version": "[0-9]+"'
    expect "$json" '"kernels": "scene/host/svd [0-9a-f]{16}"[}]'
    expect_exit 0 errors "${small[@]}" --json="$json" --benchmark_filter='^svd/aosoa16/float/host/1000/hard$'
    expect "$json" '"kernels": "set/host/svd [0-9a-f]{16}"[}]'
    expect_exit 0 storage "${small[@]}" --json="$json" --benchmark_filter='^dp_from_df/aosoa16/float/host/1000$'
    expect "$json" '"kernels": "storage/host [0-9a-f]{16}, scene/host/dp_from_df [0-9a-f]{16}"[}]' ;;
  without_a_command_there_are_no_rows_of_sets)
    expect_exit 0 "${small[@]}"
    expect "$out" '^CPU, float$'
    expect_no "$out" 'random|near_rest|hard|Worst' ;;
  errors_prints_a_table_of_error_against_speed)
    expect_exit 0 errors "${small[@]}" --benchmark_filter='^(svd|singular_values)/.*/host/'
    expect "$out" '^CPU, float, 1000 objects: error against speed, errors in eps$'
    expect "$out" '^kernel .* bytes +set +ms +M/s +/LLC +/copy +p50 +p99 +p99.99 +max .*failures$'
    expect "$out" '^svd +eigen +120 +random '
    expect "$out" '^svd +aosoa16 +120 +random '
    expect "$out" '^singular_values +aosoa16 +96 +random .* - +- +0$'
    expect "$out" '^ +near_rest '
    expect "$out" '^ +hard '
    expect "$out" '^  physbench replay svd float 0x1'
    [[ -z $(awk 'length > 160 && !/replay|^command /' "$out") ]] || fail 'a line of more than 160 columns' ;;
  errors_on_every_set_are_within_what_kernels_promise)
    # 3 sweeps do not converge in double: that is why 4 are the usual number.
    expect_exit 0 errors "${small[@]}" --objects=2000 --json="$json" --benchmark_filter='/aosoa16/.*/host/'
    awk -F'[:,] *' '
      $1 ~ /"name"/ { name = $2 }
      $1 ~ /"(err_eps_max|orth_eps_max|failures)"/ && name !~ /svd_3_sweeps/ {
        allowed = $1 ~ /failures/ ? 0 : $1 ~ /orth/ ? 32 : name ~ /^"stress_derivative_/ ? 16 : \
                  name ~ /^"(stress_|dp_)/ ? 8 : name ~ /^"singular/ ? 16 : 24
        ++numbers
        if (!($2 <= allowed) || $2 == "NaN") { print name, $1, $2; wrong = 1 }
      }
      END { exit wrong || numbers < 160 }' <(values) >&2 || fail 'numbers as above, or too few'
    ;;
  json_of_a_set_has_errors_in_eps_and_the_worst_input)
    expect_exit 0 errors "${small[@]}" --json="$json" --benchmark_filter='^svd/aosoa16/float/host/1000/hard$'
    for word in err_eps_p50 err_eps_p99 err_eps_p9999 err_eps_max orth_eps_p50 orth_eps_max '"failures": 0' \
      '"samples": 1.0*e\+03' worst_index '"label": "physbench replay svd float [-0-9a-fx.p+ ]*"'; do
      expect "$json" "$word"
    done ;;
  replay_gives_the_error_of_the_row)
    for kernel in svd svd_quaternions polar_rotation stress_derivative_clamped dp_from_df; do
      for storage in float double; do
        expect_exit 0 errors "${small[@]}" --json="$json" \
          --benchmark_filter="^$kernel/aosoa16/$storage/host/1000/hard\$"
        printf -v wanted '%.4g' "$(grep -o '"err_eps_max": [^,}]*' "$json" | awk '{ print $2 }')"
        read -ra command <<<"$(sed -n 's/.*"label": "physbench \([^"]*\)".*/\1/p' "$json")"
        expect_exit 0 "${command[@]}"
        expect "$out" "^host, packs: error $wanted eps"
        expect "$out" '^reference$'
        expect "$out" '^host, one by one: error [0-9.]+ eps'
      done
    done ;;
  replay_of_nan_and_infinity_gives_nan)
    for bad in nan inf -inf; do
      for kernel in svd_5_sweeps svd_quaternions; do  # of svd itself, cuSOLVER's answer would be among the results
        expect_exit 0 replay "$kernel" double 1 0 0 0 "$bad" 0 0 0 1
        (($(grep -c '^  s  *nan nan nan$' "$out") >= 3)) || fail "s of $bad is a number"
        expect_no "$out" '^  [UVR] .*[0-9]'
      done
    done
    expect_exit 0 replay stress_derivative_absolute float nan 1 1
    (($(grep -c '^  x.* nan$' "$out") >= 3)) || fail 'x of nan is a number' ;;
  wrong_replay_exits_with_2)
    expect_exit 2 replay
    expect "$err" 'KERNEL is one of dp_from_df .*svd svd_3_sweeps'
    expect_exit 2 replay no_such_kernel float 1
    expect "$err" "there is no kernel 'no_such_kernel'"
    expect_exit 2 replay svd half 1
    expect "$err" "float or double, not 'half'"
    expect_exit 2 replay svd float 1 2 3
    expect "$err" 'takes 9 numbers, F by columns, not 3'
    expect_exit 2 replay stress_derivative float 1 1 one
    expect "$err" "'one' is not a number"
    expect_exit 2 replay stress_derivative float 1e60 1 1
    expect "$err" 'out of the range of float' ;;
  a_filter_that_matches_nothing_names_the_nearest_row)
    expect_exit 1 --benchmark_filter='^dp_from_df/aosoa16/flaot/host/1048576$'
    expect "$err" "no row of the group 'kernels' matches '.dp_from_df/aosoa16/flaot/host/1048576.'"
    expect "$err" 'the nearest name is dp_from_df/aosoa16/float/host/1048576;'
    expect_exit 1 --objects=1000 --benchmark_filter='^dp_from_df/aosoa16/float/host/1048576$'  # another size
    expect "$err" 'the nearest name is dp_from_df/aosoa16/float/host/1000;' ;;
  a_filter_of_rows_that_the_build_left_out_says_how_to_build_them)
    if [[ $all_rows == ON ]]; then
      expect_exit 0 "${small[@]}" --benchmark_filter='^elastic_force/aosoa16/double/host/1000$'
    else
      expect_exit 1 --objects=1000 --benchmark_filter='^elastic_force/.*/double/host/'
      expect "$err" 'matches elastic_force/.*/double/host/1000 and [0-9]+ more, which this program was built without'
      expect "$err" '-DPHYSGEN_BENCHMARK_ALL_ROWS=ON'
      expect_no "$err" 'no row of the group'
    fi
    expect_exit 1 --objects=1000 --benchmark_filter='^elastic_farce/.*/double/host/'
    expect "$err" "no row of the group 'kernels' matches" ;;
  an_unknown_group_names_the_nearest)
    expect_exit 2 storge
    expect "$err" "there is no group 'storge'; did you mean 'storage'[?]" ;;
  more_bytes_than_the_machine_has_are_said_before_allocating)
    ulimit -v 8000000  # KiB; of a machine, too
    expect_exit 1 --objects=60000000 --threads=1 --json="$json" --benchmark_filter='^tet_stiffness/aos/float/host'
    expect "$json" 'this row needs about [0-9.]+ GB of memory, and this machine has [0-9.]+ GB' ;;
  the_separate_force_chain_is_near_its_reference)
    expect_exit 0 "${small[@]}" --json="$json" --benchmark_filter='^force_chain_separate/.*/host/'
    wanted=2
    [[ $all_rows != ON ]] || wanted=4  # in double, too
    awk -F'[:,] *' -v wanted=$wanted '
      $1 ~ /"name"/ { name = $2 }
      $1 ~ /"err_max"/ { ++rows; if (!($2 <= (name ~ /float/ ? 1e-3 : 1e-12))) { print name, $2; wrong = 1 } }
      END { exit wrong || rows != wanted }' <(values) >&2 || fail "errors as above, or not $wanted rows" ;;
  *) fail 'no such rule' ;;
esac
