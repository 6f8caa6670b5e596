#!/usr/bin/env bash
# Tests of the command linear_solves as its users run it: linear_solves_test.sh RULE PROGRAM FOLDER
set -euo pipefail
rule=$1 program=$2 folder=$3/$1
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export OMP_NUM_THREADS=1

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
expect_refused() { # pattern arguments...
  expect_exit 2 "${@:2}"
  expect err "$1"
  [[ ! -s out ]] || fail 'output in spite of an error'
}
# Values of a key in rows.json, in the order of the rows.
values_of() { grep -oE "\"$1\": (\"[^\"]*\"|[^,]+)" rows.json | sed -E 's/^[^:]*: //; s/"//g'; }
expect_values() { # key value...
  local found
  found=$(values_of "$1" | tr '\n' ' ')
  [[ $found == "${*:2} " ]] || fail "$1 is $found in place of ${*:2}"
}
small=(--repeat 1 --threads 1 --output rows.json)

case $rule in
  help_lists_flags_methods_and_exit_codes)
    expect_exit 0 --help
    for flag in cells poisson volume compress method precision norm tolerance repeat copies device output threads; do
      expect out "--$flag"
    done
    expect out 'multigrid, schwarz, block-jacobi, none, vendor'
    expect out '3 a solve has not converged' ;;
  unknown_names_are_refused_with_the_nearest)
    expect_refused 'no flag --cels; did you mean --cells[?]' --cels 4
    expect_refused 'no method multgrid; did you mean multigrid[?]' --method multgrid
    expect_refused 'This build has half, float, double' --precision float quad
    expect_refused 'did you mean euclidean[?]' --norm euclid
    expect_refused 'This build has tets, patches' --volume nodes ;;
  values_out_of_range_are_refused)
    expect_refused 'cells: Value 0 not in range' --cells 0
    expect_refused 'the plates hold every node' --cells 4 1
    expect_refused 'cells 5: an odd number of cells has no coarser mesh' --cells 5
    expect_refused "Poisson's ratio is above -1 and below 0.5" --poisson 0.45 0.5
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
    expect_values cells 2 2 2 2 2 2 4 4 4 4 4 4
    expect_values poisson 0.3 0.3 0.3 0.45 0.45 0.45 0.3 0.3 0.3 0.45 0.45 0.45
    half=(multigrid multigrid block-jacobi)  # which has nothing in half: once, in float
    expect_values method "${half[@]}" "${half[@]}" "${half[@]}" "${half[@]}"
    precisions=(half float float)
    expect_values precision "${precisions[@]}" "${precisions[@]}" "${precisions[@]}" "${precisions[@]}"
    (($(wc -l <out) == 13)) || fail 'not a line for each row and one for the head'
    expect_exit 0 --cells 5 --method block-jacobi --repeat 1 --threads 1 ;;
  the_residual_is_below_the_tolerance_for_every_method)
    expect_exit 0 "${small[@]}" --cells 8 --method multigrid schwarz block-jacobi none --precision double --tolerance 1e-6
    (($(values_of residual | wc -l) == 4)) || fail 'not four rows'
    values_of residual | awk '!($1 <= 1.001e-6 && $1 > 1e-9) { exit 1 }' || fail 'a residual is not as asked for'
    values_of iterations | awk '{ n[NR] = $1 } END { exit !(4 * n[1] < n[3] && 4 * n[1] < n[4] && n[2] < n[3]) }' ||
      fail 'multigrid does not take far fewer iterations than the others'
    expect_exit 0 "${small[@]}" --cells 8 --norm preconditioned euclidean --precision double
    expect_values norm preconditioned euclidean preconditioned euclidean
    expect_values method multigrid multigrid block-jacobi block-jacobi ;;
  rows_have_all_fields)
    expect_exit 0 "${small[@]}" --cells 4 --method multigrid --precision float --volume patches --copies
    for field in cells nodes tets poisson volume compression method precision norm tolerance status iterations \
      residual assembly_seconds setup_seconds solve_seconds seconds_per_iteration product_seconds product_bytes \
      product_copy_seconds iteration_bytes iteration_copy_seconds device command; do
      expect rows.json "\"$field\": [^n]"
    done
    expect_values nodes 125
    expect_values tets 384
    expect_values status converged
    expect_values command "linear_solves ${small[*]} --cells 4 --method multigrid --precision float --volume patches --copies"
    expect_exit 0 "${small[@]}" --cells 4 --method multigrid
    expect rows.json '"product_copy_seconds": null' ;;
  a_compressed_cube_has_another_stiffness)
    expect_exit 0 "${small[@]}" --cells 8 --method block-jacobi multigrid --precision double
    rest=$(values_of iterations)
    expect_exit 0 "${small[@]}" --cells 8 --method block-jacobi multigrid --precision double --compress 0.15
    [[ $(values_of iterations) != "$rest" ]] || fail 'as many iterations as at rest'
    expect_values compression 0.15 0.15
    values_of residual | awk '!($1 <= 1.001e-4) { exit 1 }' || fail 'a residual is not as asked for' ;;
  a_file_that_cannot_be_written_is_said)
    expect_exit 1 --cells 2 --repeat 1 --threads 1 --output absent/rows.json
    expect err 'absent/rows.json' ;;
  *)
    printf 'no such rule: %s\n' "$rule" >&2
    exit 2 ;;
esac
