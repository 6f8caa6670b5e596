#!/usr/bin/env bash
# Tests of what the command truthcube writes, restarts from and is interrupted in: output_test.sh RULE PROGRAM FOLDER [LAYOUT]
set -euo pipefail
rule=$1 program=$2 folder=$3/$1 built=${4:-schema} # the layout
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export OMP_NUM_THREADS=1

. "$here/command_helpers.sh"
small=(--cells 4 --threads 1)

case $rule in
  a_run_writes_beads_and_its_record)
    expect_exit 0 "${small[@]}" --compress 0.05 0.125 --out o/p
    for file in cube.vtkhdf beads.csv run.json checkpoint.h5; do [[ -s o/p/$file ]] || fail "no $file"; done
    [[ $(head -1 o/p/beads.csv) == compression,x,y,z,ux,uy,uz ]] || fail 'another header'
    awk -F, 'NR > 1 { if (NF != 7) bad = 1; ++rows[$1 + 0] }
      END { exit bad || NR != 687 || rows[0.05] != 343 || rows[0.125] != 343 }' o/p/beads.csv || fail 'other rows'
    # Above the base and below the moving plate, beads move down.
    awk -F, 'NR > 1 && !($7 < 0 && $7 > -0.08 * $1 * 1.2) { bad = 1; print } END { exit bad }' o/p/beads.csv >&2 ||
      fail 'beads as above'
    keys() { grep -oE "^ {$1}\"[A-Za-z_]+\"" o/p/run.json | tr -d ' "' | tr '\n' ' '; }
    [[ $(keys 2) == 'nodes tets bytes device layout command setup_seconds held setup_stages settings steps ' ]] || fail "keys $(keys 2)"
    step='compression newton_iterations pcg_iterations residual energy smallest_J reaction reaction_estimate error_estimate past_plates seconds warm_seconds time kinetic_energy newton '
    [[ $(keys 6 | sed "s,name seconds bytes_moved ,,g") == "nodes area nodes area $step$step" ]] || fail "keys of steps $(keys 6)"
    # A line for each Newton step that was printed, those of coarser meshes too.
    printed=$(grep -cE '^ +[0-9]+ +[0-9.e+-]+ +[0-9]+ ' out)
    (($(number_of coarser_by o/p/run.json | wc -l) == printed && printed > 2)) || fail "not $printed Newton steps"
    [[ $(number_of nodes o/p/run.json | head -1) == 125 && $(number_of tets o/p/run.json) == 384 ]] || fail 'other sizes'
    expect o/p/run.json '"device": "cpu"'
    expect o/p/run.json '"command": "truthcube --cells 4 .*--out o/p"' ;;
  repetitions_are_timed_and_change_nothing)
    expect_exit 0 "${small[@]}" --compress 0.05 0.125 --out once
    expect once/run.json '"warm_seconds": null'
    expect_exit 0 "${small[@]}" --compress 0.05 0.125 --repeat 2 --out twice
    expect out 'compression 0.125, repeated 2 times: [0-9.]+ s at best, [0-9.]+ s the first time'
    (($(number_of warm_seconds twice/run.json | grep -cE '^[0-9.e-]+$') == 2)) || fail 'not two warm times'
    cmp once/beads.csv twice/beads.csv || fail 'other beads'
    for key in residual energy reaction; do
      [[ $(number_of $key once/run.json) == "$(number_of $key twice/run.json)" ]] || fail "another $key"
    done ;;
  a_folder_that_cannot_be_written_is_said)
    touch file
    expect_exit 1 "${small[@]}" --out file
    expect err 'folder file'
    expect_exit 1 "${small[@]}" --out /proc/truthcube
    expect err 'cannot make the folder /proc/truthcube'
    expect_no out 'solved' ;;
  a_folder_that_another_run_writes_is_refused)
    mapfile -t steps < <(seq 0.001 0.001 0.3)
    "$program" --cells 8 --threads 1 --tolerance 1e-9 --compress "${steps[@]}" --out o >first 2>&1 &
    pid=$!
    until [[ -s o/checkpoint.h5 ]]; do
      kill -0 $pid 2>/dev/null || fail 'it ended before the first step'
      sleep 0.05
    done
    for more in "" --restart "--scene explicit-dynamics --compress 0.1"; do
      # shellcheck disable=SC2086
      expect_exit 1 "${small[@]}" --out o $more
      expect err "o: another run writes there, process $pid on .* wait until it has ended, or choose another --out"
    done
    expect_exit 0 "${small[@]}" --out o --dry-run
    kill -0 $pid || fail 'the first run ended'
    kill -INT $pid
    got=0
    wait $pid || got=$?
    ((got == 130)) || fail "exit $got instead of 130"
    (($(wc -l <o/beads.csv) == 343 * $(number_of compression o/run.json | wc -l) + 1)) || fail 'beads of other steps'
    for end in 0 3; do
      [[ ! -e o/run.lock ]] || fail 'a lock is left'
      expect_exit $end "${small[@]}" --compress 0.05 $( ((end == 0)) || echo 0.999999) --out o
    done
    [[ ! -e o/run.lock ]] || fail 'a lock is left' ;;
  a_file_that_may_not_grow_keeps_the_steps_before)
    flags=(--cells 8 --threads 1 --compress 0.01 0.02 0.03 0.04 0.05 0.06)
    expect_exit 0 "${flags[@]}" --out whole
    # Bytes that are asked for ahead of a step; then a limit that the file meets after some steps.
    (ulimit -f 1000; expect_exit 1 "${flags[@]}" --out o; expect err 'o/cube.vtkhdf: needs [0-9]+ bytes more')
    ahead=$(sed -nE 's/.*needs ([0-9]+) bytes more.*/\1/p' err)
    (ulimit -f $(((ahead + $(stat -c %s whole/cube.vtkhdf) - 200000) / 1024)); expect_exit 1 "${flags[@]}" --out o)
    done=$(number_of compression o/run.json | wc -l)
    ((done >= 1 && done < 6)) || fail "$done steps are written"
    (($(wc -l <o/beads.csv) == 343 * done + 1)) || fail 'beads of other steps than the record'
    expect_exit 0 "${flags[@]}" --out o --restart
    expect out "continuing after step $done"
    for file in beads.csv checkpoint.h5; do expect_same whole/$file o/$file; done ;;
  no_equilibrium_exits_with_3_and_keeps_the_last)
    expect_exit 3 "${small[@]}" --compress 0.05 0.999999 --out o
    expect err 'no equilibrium at a compression of 0[.]999999: .* the last equilibrium is at '
    expect err 'J -?[0-9.e-]+, F = \[.*;.*;.*\]'
    expect err 'Try more and smaller --compress steps, --stepping loads, --precision double, or more --cells[.]$'
    last=$(sed -nE 's/.*the last equilibrium is at ([0-9.]+)[.]$/\1/p' err)
    steps=$(number_of compression o/run.json | wc -l)
    (($(wc -l <o/beads.csv) == 343 * steps + 1)) || fail 'beads of other steps than the record'
    awk -v a="$last" -v b="$(number_of compression o/run.json | tail -1)" 'BEGIN { exit !(a - b < 1e-5 && b - a < 1e-5) }' ||
      fail "the last step written is not at $last" ;;
  where_there_is_no_equilibrium_what_is_not_yet_chosen_is_to_be_tried)
    expect_exit 3 "${small[@]}" --precision double --stepping loads --compress 0.999999
    expect err 'Try more and smaller --compress steps, or more --cells[.]$'
    expect_exit 3 "${small[@]}" --scene linear-elastic --poisson 0.49999999 --compress 0.5
    expect err 'after [0-9]+ linear solves,'
    expect err 'Try a --poisson farther from 0[.]5, --precision double, or more --cells[.]$' ;;
  inverted_tets_of_an_equilibrium_are_said)
    flags=("${small[@]}" --volume tets --material st-venant-kirchhoff)
    expect_exit 0 "${flags[@]}" --compress 0.6 --out o
    J=$(number_of smallest_J o/run.json | sed -n 1p)
    [[ $J == -* ]] || fail 'no inverted tets'
    said="^truthcube: warning: at a compression of 0[.]6, [0-9]+ tets are inverted, most of all tet [0-9]+: J ${J:0:4}.*, F = \[.*;.*;.*\]"
    expect err "$said[.] A real body has no such equilibrium[.] Try more and smaller --compress steps"
    expect_exit 0 "${flags[@]}" --compress 0.6 --quiet
    expect err "$said"
    expect_exit 0 "${flags[@]}" --compress 0.1
    expect_no err 'inverted' ;;
  a_solve_that_rounding_ends_above_the_tolerance_is_said)
    for quiet in "" --quiet; do
      # shellcheck disable=SC2086
      expect_exit 0 "${small[@]}" --compress 1e-15 $quiet
      expect err '^truthcube: warning: at a compression of 1e-15, rounding ended the solve at a residual of [0-9.]+e[-+][0-9]+, above the tolerance of [0-9.]+e-[0-9]+: .* Try a larger --compress or --tolerance[.]$'
    done
    expect_exit 0 "${small[@]}" --compress 0.05
    expect_no err 'warning' ;;
  what_is_not_finite_is_said_with_its_tet)
    expect_exit 3 "${small[@]}" --young 1e300 --precision double --compress 0.1 --out o
    expect err 'not finite'
    expect err 'tet [0-9]+ .*F = \['
    [[ $(wc -l <o/beads.csv) == 1 ]] || fail 'beads of no step' ;;
  a_restart_gives_the_same_bits)
    for precision in half double; do
      flags=(--cells 8 --threads 1 --precision $precision)
      expect_exit 0 "${flags[@]}" --compress 0.05 0.1 0.15 --out whole
      rm -rf parts
      expect_exit 0 "${flags[@]}" --compress 0.05 --out parts
      sleep 1.1 # no file may hold the time of day
      expect_exit 0 "${flags[@]}" --compress 0.05 0.1 --out parts --restart
      expect out 'continuing after step 1, at a compression of 0.05'
      expect_exit 0 "${flags[@]}" --compress 0.05 0.1 0.15 --out parts --restart
      for file in beads.csv checkpoint.h5; do expect_same whole/$file parts/$file; done
      for key in compression newton_iterations pcg_iterations residual energy smallest_J reaction; do
        [[ $(number_of $key whole/run.json) == "$(number_of $key parts/run.json)" ]] || fail "other $key"
      done
    done ;;
  a_finished_run_has_nothing_left)
    expect_exit 0 "${small[@]}" --compress 0.05 --out o
    cp -r o before
    expect_exit 0 "${small[@]}" --compress 0.05 --out o --restart
    expect out 'nothing is left to do: step 1, at a compression of 0.05'
    for file in beads.csv checkpoint.h5 cube.vtkhdf run.json; do expect_same o/$file before/$file; done
    expect_exit 1 "${small[@]}" --compress 0.03 --out o --restart
    expect err '--restart: o has steps up to a compression of [0-9.]+ but none at 0.03' ;;
  a_restart_never_begins_anew)
    expect_exit 1 "${small[@]}" --out absent --restart
    expect err 'absent/checkpoint.h5: this checkpoint does not exist'
    [[ ! -e absent ]] || fail 'a folder was made'
    expect_exit 0 "${small[@]}" --compress 0.05 --out o
    cp -r o before
    expect_exit 1 --cells 8 --out o --restart
    expect err 'other settings: cells: 4 in the checkpoint, 8 in this run'
    expect_exit 1 "${small[@]}" --poisson 0.45 --precision float --out o --restart
    expect err 'poisson: 0.49 .*, 0.45'
    expect err 'precision: .*half.*, .*float'
    for file in beads.csv checkpoint.h5 cube.vtkhdf run.json; do expect_same o/$file before/$file; done ;;
  a_restart_refuses_a_record_of_other_steps_than_the_checkpoint)
    expect_exit 0 "${small[@]}" --compress 0.05 0.1 --out o
    sed -i 's/"compression": 0.1,/"compression": 0.2,/' o/run.json
    cp -r o before
    expect_exit 1 "${small[@]}" --compress 0.05 0.1 0.15 --out o --restart
    expect err 'o/run.json has a compression of 0.20* in step 2, and the checkpoint beside it 0.10*: the files come from different runs; run again'
    for file in beads.csv checkpoint.h5 cube.vtkhdf run.json; do expect_same o/$file before/$file; done ;;
  a_new_run_drops_the_checkpoint_of_an_old_one)
    expect_exit 0 "${small[@]}" --compress 0.05 --out o
    expect_exit 3 "${small[@]}" --young 1e300 --precision double --compress 0.1 --out o
    [[ ! -e o/checkpoint.h5 ]] || fail 'a checkpoint of another run' ;;
  an_interrupt_ends_with_what_is_done)
    # Steps of a tenth of a per cent: far more than are done before the interrupt.
    mapfile -t steps < <(seq 0.001 0.001 0.3)
    flags=(--cells 8 --threads 1 --precision double --tolerance 1e-9)
    "$program" "${flags[@]}" --compress "${steps[@]}" --out o >out 2>err &
    pid=$!
    until [[ -s o/checkpoint.h5 ]]; do
      kill -0 $pid 2>/dev/null || fail 'it ended before the first step'
      sleep 0.05
    done
    kill -INT $pid
    got=0
    wait $pid || got=$?
    ((got == 130)) || fail "exit $got instead of 130"
    done=$(number_of compression o/run.json | wc -l)
    expect out "interrupted; $done steps are written"
    ((done < 300)) || fail 'all steps were done'
    (($(wc -l <o/beads.csv) == 343 * done + 1)) || fail 'beads of other steps than the record'
    expect_exit 0 "${flags[@]}" --compress "${steps[@]:0:done+2}" --out o --restart
    expect_exit 0 "${flags[@]}" --compress "${steps[@]:0:done+2}" --out whole
    for file in beads.csv checkpoint.h5; do expect_same whole/$file o/$file; done ;;
  measured_beads_are_compared)
    expect_exit 0 "${small[@]}" --compress 0.05 0.1 --out o
    expect_exit 0 "${small[@]}" --compress 0.05 0.1 --beads o/beads.csv
    [[ $(grep -c 'difference \[mm\] mean 0.0000, RMS 0.0000, 95 % below 0.0000, max 0.0000' out) == 2 ]] || fail 'differences'
    # 3 mm along x and 4 mm along y, at every bead
    awk -F, -v OFS=, 'NR > 1 { $5 += 0.003; $6 += 0.004 } 1' CONVFMT=%.17g OFMT=%.17g o/beads.csv >moved.csv
    expect_exit 0 "${small[@]}" --compress 0.1 --beads moved.csv
    expect out '343 beads of moved.csv: difference \[mm\] mean 5.0000, RMS 5.0000, 95 % below 5.0000, max 5.0000'
    expect_exit 0 "${small[@]}" --compress 0.02 --beads moved.csv
    expect out 'moved.csv has no beads at a compression of 0.02, only at 0[.]05, 0[.]1$'
    sed -i '3s/,[^,]*$/,wrong/' moved.csv
    expect_exit 1 "${small[@]}" --beads moved.csv
    expect err 'moved.csv:3: .*wrong'
    expect_exit 1 "${small[@]}" --beads absent.csv
    expect err 'absent.csv: cannot be read as a bead table: No such file'
    expect_exit 1 "${small[@]}" --beads .
    expect err 'cannot be read as a bead table: it is a folder'
    expect_no out 'solved' ;;
  a_graded_cube_is_nearer_to_the_beads_in_about_as_many_iterations)
    cube=(--cells 16 --threads 1 --compress 0.125)
    for grading in 1 1.5; do
      expect_exit 0 "${cube[@]}" --grading $grading --out o$grading --beads "$here/../../fem/solver/oracle/0.49_bonded_0.125.csv"
      expect o$grading/run.json "\"grading\": $grading"
      expect_no err inverted
      declare "rms${grading/./_}=$(sed -nE 's/.* RMS ([0-9.]+), 95.*/\1/p' out)"
      declare "pcg${grading/./_}=$(number_of pcg_iterations o$grading/run.json | sed -n 1p)"
    done
    # shellcheck disable=SC2154
    awk -v graded="$rms1_5" -v uniform="$rms1" 'BEGIN { exit !(graded < 0.04 && graded < 0.6 * uniform) }' || fail "$rms1_5 mm, $rms1 mm"
    # shellcheck disable=SC2154
    ((10 * pcg1_5 <= 15 * pcg1)) || fail "$pcg1_5 iterations, $pcg1"
    # What a finer mesh would give is nearer to the other code's reaction than the mesh's own.
    awk -v mesh="$(number_of reaction o1.5/run.json)" -v estimate="$(number_of reaction_estimate o1.5/run.json)" 'function from(x) {
      x += 11.087e-4 * 15e3; return x < 0 ? -x : x } BEGIN { exit !(from(estimate) < 0.4 * from(mesh)) }' || fail 'reactions' ;;
  flat_cells_take_at_most_1.5_times_the_iterations_of_uniform_ones)
    for cube in '16 0.49 1.5' '16 0.499 1.5' '16 0.49 1.8' '16 0.499 1.8' '32 0.49 1.5'; do
      read -r cells nu grading <<<"$cube"
      for g in 1 "$grading"; do
        expect_exit 0 --cells "$cells" --poisson "$nu" --grading "$g" --threads 1 --compress 0.1825
        iterations=$(sed -nE 's/.* and ([0-9]+) PCG iterations.*/\1/p' out)
        if [[ $g == 1 ]]; then uniform=$iterations; fi
      done
      ((2 * iterations <= 3 * uniform)) || fail "$cube: $iterations iterations, $uniform of uniform cells"
    done ;;
  the_grading_of_uniform_cells_changes_nothing)
    expect_exit 0 "${small[@]}" --compress 0.05 --out a
    expect_exit 0 "${small[@]}" --compress 0.05 --out b --grading 1
    expect_same a/beads.csv b/beads.csv
    expect_exit 1 "${small[@]}" --compress 0.05 0.1 --out a --grading 1.25 --restart
    expect err 'grading: 1[.]0 in the checkpoint, 1[.]25 in this run'
    expect_exit 0 "${small[@]}" --compress 0.05 --out a --grading 1.25
    expect_exit 0 "${small[@]}" --compress 0.05 0.1 --out a --grading 1.25 --restart
    expect out 'continuing after step 1' ;;
  cells_that_are_too_narrow_for_a_fold_are_said)
    flags=(--cells 16 --grading 2 --threads 1 --compress 0.3)
    expect_exit 0 "${flags[@]}"
    expect err 'tets are inverted, .* Try --plates contact, a smaller --grading, or more and smaller --compress steps[.]$'
    expect_exit 0 "${flags[@]}" --plates contact
    expect_no err inverted ;;
  *) fail 'no such rule' ;;
esac
