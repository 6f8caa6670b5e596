#!/usr/bin/env bash
# Tests of the group linear_solves of physbench as its users run it: linear_solves_test.sh RULE PROGRAM FOLDER
set -euo pipefail
rule=$1 program=$2 folder=$3/$1
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export OMP_NUM_THREADS=1
group=(linear_solves)

fail() { printf '%s: %s\n' "$rule" "$*" >&2; cat out err >&2; exit 1; }
# Runs the command; its output is in the files out and err.
expect_exit() {
  local wanted=$1 got=0
  shift
  "$program" "${group[@]}" "$@" >out 2>err || got=$?
  ((got == wanted)) || fail "exit $got instead of $wanted: $*"
}
expect() { grep -qE -- "$2" "$1" || fail "not found in $1: $2"; }
expect_no() { ! grep -qE -- "$2" "$1" || fail "found in $1: $2"; }
expect_refused() { # pattern arguments...
  expect_exit 2 "${@:2}"
  expect err "$1"
  [[ ! -s out ]] || fail 'output in spite of an error'
}
# Values of a key in rows.json, in the order of the rows: numbers, or a part of their names.
values_of() { grep -oE "\"$1\": (\"[^\"]*\"|[^,]+)" rows.json | sed -E 's/^[^:]*: //; s/"//g'; }
part_of_names() { values_of name | cut -d/ -f"$1"; }
expect_parts() { # number part...
  local found
  found=$(part_of_names "$1" | tr '\n' ' ')
  [[ $found == "${*:2} " ]] || fail "part $1 of the names is $found in place of ${*:2}"
}
expect_number() { # key number
  values_of "$1" | awk -v wanted="$2" '!($1 == wanted) { exit 1 } END { exit NR == 0 }' || fail "$1 is $(values_of "$1")"
}
small=(--repeat 1 --threads 1 --benchmark_min_time=0.001 --json=rows.json)

case $rule in
  help_lists_flags_and_methods)
    expect_exit 0 --help
    for flag in cells poisson volume compress method precision norm tolerance repeat device; do expect out "--$flag"; done
    expect out 'Flags of the group linear_solves'
    expect out 'multigrid, schwarz, block-jacobi, none, vendor' ;;
  unknown_names_are_refused_with_the_nearest)
    expect_refused 'no flag --cels; did you mean --cells[?]' --cels 4
    expect_refused 'no method multgrid; did you mean multigrid[?]' --method multgrid
    expect_refused 'This build has half, float, double' --precision float quad
    expect_refused 'did you mean euclidean[?]' --norm euclid
    expect_refused 'This build has tets, patches' --volume nodes ;;
  flags_of_the_group_are_refused_elsewhere)
    group=()
    expect_refused '--cells is a flag of the group linear_solves: write physbench linear_solves --cells' --cells 4 ;;
  values_out_of_range_are_refused)
    expect_refused 'cells: Value 0 not in range' --cells 0
    expect_refused 'the plates hold every node' --cells 4 1
    expect_refused 'cells 5: an odd number of cells has no coarser mesh' --cells 5
    expect_refused "Poisson's ratio must be above -1 and below 0.5" --poisson 0.45 0.5
    expect_refused "Poisson's ratio" --poisson nan
    expect_refused '--tolerance 0' --tolerance 0
    expect_refused '--compress 1' --compress 1
    expect_refused '--compress' --compress nan
    expect_refused 'repeat: Value 0 not in range' --repeat 0 ;;
  the_vendor_needs_cuda)
    expect_refused 'vendor is cuSPARSE' --method vendor --device cpu ;;
  a_row_for_each_cube_method_and_precision)
    expect_exit 0 "${small[@]}" --cells 2 4 --poisson 0.3 0.45 --volume tets --method multigrid block-jacobi \
      --precision half float
    expect_parts 5 48 48 48 48 48 48 384 384 384 384 384 384
    three=(tets_0.3_euclidean tets_0.3_euclidean tets_0.3_euclidean)
    six=("${three[@]}" "${three[@]/0.3/0.45}")
    expect_parts 6 "${six[@]}" "${six[@]}"
    half=(multigrid multigrid block-jacobi)  # which has nothing in half: once, in float
    expect_parts 2 "${half[@]}" "${half[@]}" "${half[@]}" "${half[@]}"
    precisions=(half float float)
    expect_parts 3 "${precisions[@]}" "${precisions[@]}" "${precisions[@]}" "${precisions[@]}"
    expect_exit 0 "${small[@]}" --cells 5 --method block-jacobi ;;
  the_residual_is_below_the_tolerance_for_every_method)
    expect_exit 0 "${small[@]}" --cells 8 --method multigrid schwarz block-jacobi none --precision double --tolerance 1e-6
    (($(values_of err_max | wc -l) == 4)) || fail 'not four rows'
    values_of err_max | awk '!($1 <= 1.001e-6 && $1 > 1e-9) { exit 1 }' || fail 'a residual is not as asked for'
    values_of iteration_count | awk '{ n[NR] = $1 } END { exit !(4 * n[1] < n[3] && 4 * n[1] < n[4] && n[2] < n[3]) }' ||
      fail 'multigrid does not take far fewer iterations than the others'
    expect_exit 0 "${small[@]}" --cells 8 --norm preconditioned euclidean --precision double
    norms=(patches_0.49_preconditioned patches_0.49_euclidean)
    expect_parts 6 "${norms[@]}" "${norms[@]}"
    expect_parts 2 multigrid multigrid block-jacobi block-jacobi ;;
  rows_have_all_numbers)
    expect_exit 0 "${small[@]}" --cells 4 --method multigrid --precision float --volume patches
    for key in cells compression tolerance iteration_count err_max median_ms assembly_ms setup_ms product_ms product_bytes \
      product_copy_ms iteration_bytes copy_ms; do
      expect rows.json "\"$key\": [0-9]"
    done
    expect_number poisson 0.49
    expect_parts 5 384
    expect rows.json '"label": "[0-9]+ iterations, assembly .* ms, set-up .* ms"'
    expect_exit 0 --objects=300 --repeat 1 --threads 1
    expect out 'linear_solve patches_0.49_euclidean +384 .*multigrid half .* iterations, assembly' ;;
  a_solve_that_does_not_converge_is_a_failure) # float cannot tell such a stiffness from an indefinite one
    expect_exit 1 "${small[@]}" --cells 6 --method block-jacobi --precision float --volume tets --poisson 0.4999999999 --tolerance 1e-14
    expect rows.json '"name": "linear_solve/block-jacobi/float/host/1296/tets_0.4999999999_euclidean"'
    expect rows.json '"error_message": ".*the solve has not converged: ' ;;
  a_compressed_cube_has_another_stiffness)
    expect_exit 0 "${small[@]}" --cells 8 --method block-jacobi multigrid --precision double
    rest=$(values_of iteration_count)
    expect_exit 0 "${small[@]}" --cells 8 --method block-jacobi multigrid --precision double --compress 0.15
    [[ $(values_of iteration_count) != "$rest" ]] || fail 'as many iterations as at rest'
    expect_number compression 0.15
    values_of err_max | awk '!($1 <= 1.001e-4) { exit 1 }' || fail 'a residual is not as asked for' ;;
  *)
    printf 'no such rule: %s\n' "$rule" >&2
    exit 2 ;;
esac
