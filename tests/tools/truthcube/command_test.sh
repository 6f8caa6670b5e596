#!/usr/bin/env bash
# Tests of the command truthcube as its users run it: command_test.sh RULE PROGRAM FOLDER [LAYOUT]
set -euo pipefail
rule=$1 program=$2 folder=$3/$1 built=${4:-schema} # the layout
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export OMP_NUM_THREADS=1

. "$here/command_helpers.sh"
# A box of N^3 cells and 0.08 m in Gmsh's format, version 2.2; tet number $2, if given, has two corners exchanged.
write_mesh() {
  awk -v n="$1" -v inverted="${2:-0}" 'BEGIN {
    print "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" (n + 1) ^ 3
    for (z = 0; z <= n; ++z) for (y = 0; y <= n; ++y) for (x = 0; x <= n; ++x)
      printf "%d %.17g %.17g %.17g\n", ++nodes, .08 * x / n, .08 * y / n, .08 * z / n
    print "$EndNodes\n$Elements\n" 6 * n ^ 3
    count = split("0137 0267 0457 0327 0517 0647", path, " ")
    for (z = 0; z < n; ++z) for (y = 0; y < n; ++y) for (x = 0; x < n; ++x) for (p = 1; p <= count; ++p) {
      for (c = 1; c <= 4; ++c) {
        k = substr(path[p], c, 1)
        corner[c] = 1 + x + k % 2 + (n + 1) * (y + int(k / 2) % 2 + (n + 1) * (z + int(k / 4)))
      }
      if (++tets == inverted) { swap = corner[1]; corner[1] = corner[2]; corner[2] = swap }
      print tets, 4, 2, 0, 1, corner[1], corner[2], corner[3], corner[4]
    }
    print "$EndElements"
  }'
}
small=(--cells 4 --threads 1)

case $rule in
  help_lists_flags_layouts_and_exit_codes)
    expect_exit 0 --help
    for flag in cells mesh refine material young poisson volume compress top plates plate-stiffness device precision layout preconditioner \
      product tolerance stepping historical out restart beads threads repeat dry-run quiet scene time-step duration density damping \
      frames; do expect out "--$flag"; done
    expect out "layout \{$built\}"
    expect out "in the layout $built, with products assembled .* or matrix-free"
    expect out 'product \{assembled, matrix-free\}'
    expect out 'neo-hookean, st-venant-kirchhoff'
    expect out 'With --plates contact the plates are rigid'
    expect out 'stiffness per area, in E over the mean spacing'
    expect out '130 interrupted' ;;
  unknown_names_are_refused_with_the_nearest)
    expect_refused 'no flag --cels; did you mean --cells[?]' --cels 4
    expect_refused 'no flag --quite; did you mean --quiet[?]' --quite
    expect_refused 'no flag --xyz[.]' --xyz=1
    expect_refused "argument was not expected: 4" 4
    expect_refused 'no material neo-hokean; did you mean neo-hookean[?]' --material neo-hokean
    expect_refused 'This build has half, float, double' --precision quad
    expect_refused 'did you mean bonded[?]' --top bounded
    expect_refused 'no kind of plates contct; did you mean contact[?] This build has held, contact' --plates contct
    expect_refused 'no device gpu.* This build has cpu' --device gpu
    expect_refused 'This build has tets, patches, nodes' --volume cells
    expect_refused 'did you mean schwarz[?] This build has multigrid, schwarz, block-jacobi, none' --preconditioner schwartz ;;
  layouts_that_are_not_built_are_refused)
    for layout in schema aos aos_padded soa aosoa; do
      if [[ $layout == "$built" ]]; then
        expect_exit 0 --layout $layout "${small[@]}" --compress 0.02 --out o
        expect o/run.json "\"layout\": \"$layout\""
      else
        expect_refused "this one has $built; configure one with cmake -DPHYSGEN_LAYOUT=$layout" --layout $layout
      fi
    done
    expect_refused "no layout saos; did you mean aos[?] This build has $built" --layout saos ;;
  products_without_blocks_take_fewer_bytes_and_find_the_same_equilibrium)
    for kind in none block-jacobi; do
      for product in assembled matrix-free; do
        flags=("${small[@]}" --preconditioner $kind --product $product --precision double --tolerance 1e-9 --compress 0.05)
        expect_exit 0 "${flags[@]}" --dry-run
        [[ $product == assembled ]] || expect out '^ +0 +125 +384 +0 ' # edges
        said=$(sed -nE 's/^solver: ([0-9]+) bytes, .*/\1/p' out)
        expect_exit 0 "${flags[@]}" --out $product
        took=$(number_of bytes $product/run.json)
        ((said == took)) || fail "$product: $said bytes said, $took taken"
        expect $product/run.json "\"product\": \"$product\""
      done
      (($(number_of bytes matrix-free/run.json) < $(number_of bytes assembled/run.json))) || fail 'no fewer bytes'
      awk -v a="$(number_of energy assembled/run.json)" -v b="$(number_of energy matrix-free/run.json)" \
        'BEGIN { exit !(a > 0 && (a - b) ^ 2 < 1e-20 * a * a) }' || fail 'another energy'
    done ;;
  values_out_of_range_are_refused)
    expect_refused 'cells: Value 0 not in range' --cells 0
    expect_refused 'cells: Value -4 not in range' --cells -4
    expect_refused '--cells 400: .* numbers up to [0-9]+, .* 2147483647; --cells 274 fits' --cells 400
    expect_refused "--poisson 0.5: Poisson's ratio is" --poisson 0.5
    expect_refused "--poisson -1: Poisson's ratio is" --poisson -1
    expect_refused "--poisson nan: Poisson's ratio is" --poisson nan
    expect_refused "--young 0: Young's modulus is" --young 0
    expect_refused '--compress .* 1 does not fit behind 0' --compress 1
    expect_refused '--compress .* 0.05 does not fit behind 0.1' --compress 0.1 0.05
    expect_refused '--compress .* does not fit' --compress nan
    expect_refused '--plate-stiffness 0: .* from 0.001 to 1e4' --plates contact --plate-stiffness 0
    expect_refused '--tolerance 0: ' --tolerance 0 ;;
  flags_that_do_not_go_together_are_refused)
    expect_refused 'corotated.* no separate part of the volume: write --volume tets' --material corotated --volume patches
    expect_refused 'corotated.* no separate part of the volume: write --volume tets' --material corotated --volume nodes
    expect_refused 'restart continues what is in --out' --restart
    expect_refused 'excludes' --mesh a.msh --cells 4
    expect_refused 'refine is for a mesh' --refine 1
    expect_refused 'plate-stiffness is that of --plates contact' --plate-stiffness 10
    expect_refused 'excludes' --historical --precision double
    expect_refused 'excludes' --historical --product assembled
    expect_refused '--plates contact goes with --product assembled' --plates contact --historical
    expect_refused '--volume nodes goes with --product assembled' --volume nodes --historical
    expect_refused '--product matrix-free goes with --preconditioner block-jacobi or none' --product matrix-free ;;
  materials_without_a_volume_part_run_by_tets)
    expect_exit 0 "${small[@]}" --material corotated --compress 0.02
    expect out "note: the energy of 'corotated' has no separate part of the volume to be averaged: --volume tets"
    expect_exit 0 "${small[@]}" --material corotated --volume tets --compress 0.02
    expect_no out 'note:'
    expect out 'solved in' ;;
  schwarz_blocks_precondition_what_has_no_coarser_mesh)
    expect_exit 0 --cells 5 --threads 1 --compress 0.02 --preconditioner schwarz
    expect_no out 'note:'
    expect out 'solved in' ;;
  the_historical_mode_runs)
    expect_exit 0 "${small[@]}" --historical --compress 0.02 --out o
    expect o/run.json '"product": "matrix-free"'
    expect out 'solved in' ;;
  an_odd_number_of_cells_falls_back_and_says_so)
    expect_exit 0 --cells 5 --threads 1 --compress 0.02
    expect out 'note: an odd number of cells .* block Jacobi in place of multigrid; 6 cells'
    expect_exit 0 --cells 10 --threads 1 --compress 0.02
    expect out 'note: the coarsest mesh has 216 nodes' ;;
  a_body_without_free_nodes_is_refused)
    expect_exit 1 --cells 1
    expect err 'the plates hold every node'
    expect_exit 0 --cells 1 --top frictionless --compress 0.05
    expect_exit 0 --cells 2 --compress 0.05 ;;
  a_newton_step_is_a_line)
    expect_exit 0 "${small[@]}" --compress 0.05
    expect out '^ +step +residual +PCG +energy +smallest J +time$'
    expect out '^ +1 +[0-9.e+-]+ +[0-9]+ +[0-9.e+-]+ +0[.][0-9]+ +[0-9.]+ s'
    expect out 'bytes per node'
    expect out 'reaction -[0-9.]+ N' ;;
  sides_that_fold_past_the_plates_are_said)
    expect_exit 0 --cells 8 --threads 1 --compress 0.3 0.4
    expect out 'free sides reach [0-9.]+ mm past the plates'
    expect_exit 0 --cells 8 --threads 1 --top frictionless --compress 0.05
    expect_no out 'free sides reach' ;;
  plates_with_contact_push_sides_back)
    expect_exit 0 --cells 8 --threads 1 --compress 0.4 --out held
    expect_exit 0 --cells 8 --threads 1 --compress 0.4 --plates contact --out contact
    expect out 'free sides reach 0[.]0[0-9]+ mm past the plates; the upper one pushes them back with [0-9.]+ N'
    awk -v a="$(number_of past_plates held/run.json)" -v b="$(number_of past_plates contact/run.json)" \
      'BEGIN { exit !(b > 0 && b < 1e-4 && b < a / 10) }' || fail 'past the plates'
    awk -v a="$(number_of reaction held/run.json)" -v b="$(number_of reaction contact/run.json)" \
      'BEGIN { exit !(b < a && b > 1.1 * a) }' || fail 'reaction'
    expect contact/run.json '"plates": "contact"'
    expect contact/run.json '"plate_stiffness": 100'
    expect held/run.json '"plates": "held"'
    expect_exit 0 --cells 8 --threads 1 --compress 0.4 --plates contact --plate-stiffness 1000 --out stiff
    awk -v a="$(number_of past_plates contact/run.json)" -v b="$(number_of past_plates stiff/run.json)" \
      'BEGIN { exit !(b < a / 2) }' || fail 'stiffness'
    expect_exit 1 --cells 8 --threads 1 --compress 0.4 0.45 --out contact --restart
    expect err 'plates: .*contact.*, .*held'
    expect_exit 0 --cells 8 --threads 1 --compress 0.4 0.45 --plates contact --out contact --restart
    expect_exit 0 --cells 8 --threads 1 --compress 0.4 0.45 --plates contact --out whole
    for file in beads.csv checkpoint.h5; do expect_same whole/$file contact/$file; done ;;
  quiet_prints_nothing)
    for flags in "--quiet --out o" "-q --dry-run" "-q --restart --out o"; do
      # shellcheck disable=SC2086
      expect_exit 0 "${small[@]}" $flags
      [[ ! -s out && ! -s err ]] || fail "output of $flags"
    done ;;
  a_terminal_has_a_bar_during_set_up)
    script -qec "'$program' --cells 4 --threads 1 --compress 0.02" /dev/null >out 2>err || fail 'no success'
    expect out '#\.*\] set-up, 4 of 4: the solver'
    script -qec "'$program' --cells 4 --beads absent.csv" /dev/null >out 2>err || true
    expect out 'set-up, 3 of 4: files.*\[Ktruthcube: absent.csv'
    expect_exit 0 "${small[@]}" --compress 0.02
    expect_no out 'set-up, ' ;;
  a_dry_run_says_the_bytes_that_a_run_takes)
    for precision in half float double; do
      expect_exit 0 "${small[@]}" --precision $precision --dry-run
      expect out '^ +0 +125 +384 '
      said=$(sed -nE 's/^solver: ([0-9]+) bytes, .* per node and .* per tet.*/\1/p' out)
      expect_exit 0 "${small[@]}" --precision $precision --compress 0.01 --out o
      took=$(number_of bytes o/run.json)
      ((said == took)) || fail "$precision: $said bytes said, $took taken"
    done ;;
  a_dry_run_allocates_and_writes_nothing)
    expect_exit 0 --cells 272 --precision double --dry-run --out o # hundreds of gigabytes
    expect out '^ +0 +20346417 +120741888 '
    [[ ! -e o ]] || fail 'a folder was made' ;;
  too_little_memory_is_said_before_allocating)
    # Where the machine has more than a large cube takes, the process may have less.
    if (($(awk '/MemTotal/ { print int($2 / 1e6) }' /proc/meminfo) > 200)); then ulimit -v 200000000; fi
    expect_exit 1 --cells 272 --precision double --out o
    expect err 'a cube of 272\^3 cells takes [0-9.]+ GB \([0-9]{12} bytes\), and this machine has [0-9.]+ GB; fewer --cells'
    [[ ! -e o ]] || fail 'a folder was made' ;;
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
    [[ $(keys 2) == 'nodes tets bytes device layout command setup_seconds settings steps ' ]] || fail "keys $(keys 2)"
    step='compression newton_iterations pcg_iterations residual energy smallest_J reaction reaction_estimate error_estimate past_plates seconds warm_seconds time kinetic_energy newton '
    [[ $(keys 6) == "$step$step" ]] || fail "keys of steps $(keys 6)"
    # A line for each Newton step that was printed, those of coarser meshes too.
    printed=$(grep -cE '^ +[0-9]+ +[0-9.e+-]+ +[0-9]+ ' out)
    (($(number_of coarser_by o/p/run.json | wc -l) == printed && printed > 2)) || fail "not $printed Newton steps"
    [[ $(number_of nodes o/p/run.json) == 125 && $(number_of tets o/p/run.json) == 384 ]] || fail 'other sizes'
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
    # What is asked for ahead of a step; then a limit that the file meets after some steps.
    (ulimit -f 1000; expect_exit 1 "${flags[@]}" --out o; expect err 'o/cube.vtkhdf: needs [0-9]+ bytes more')
    ahead=$(sed -nE 's/.*needs ([0-9]+) bytes more.*/\1/p' err)
    (ulimit -f $(((ahead + $(stat -c %s whole/cube.vtkhdf) - 200000) / 1024)); expect_exit 1 "${flags[@]}" --out o)
    done=$(number_of compression o/run.json | wc -l)
    ((done >= 1 && done < 6)) || fail "$done steps are written"
    (($(wc -l <o/beads.csv) == 343 * done + 1)) || fail 'beads of other steps than the record'
    expect_exit 0 "${flags[@]}" --out o --restart
    expect out "continuing behind step $done"
    for file in beads.csv checkpoint.h5; do expect_same whole/$file o/$file; done ;;
  no_equilibrium_exits_with_3_and_keeps_the_last)
    expect_exit 3 "${small[@]}" --compress 0.05 0.999999 --out o
    expect err 'no equilibrium at a compression of 0[.]999999: .* the last equilibrium is at '
    expect err 'J -?[0-9.e-]+, F = \[.*;.*;.*\]'
    expect err 'Try more and smaller --compress steps'
    last=$(sed -nE 's/.*the last equilibrium is at ([0-9.]+)[.]$/\1/p' err)
    steps=$(number_of compression o/run.json | wc -l)
    (($(wc -l <o/beads.csv) == 343 * steps + 1)) || fail 'beads of other steps than the record'
    awk -v a="$last" -v b="$(number_of compression o/run.json | tail -1)" 'BEGIN { exit !(a - b < 1e-5 && b - a < 1e-5) }' ||
      fail "the last step written is not at $last" ;;
  inverted_tets_of_an_equilibrium_are_said)
    flags=("${small[@]}" --volume tets --material st-venant-kirchhoff)
    expect_exit 0 "${flags[@]}" --compress 0.6 --out o
    J=$(number_of smallest_J o/run.json | head -1)
    [[ $J == -* ]] || fail 'no inverted tets'
    expect out "[0-9]+ tets are inverted, most of all tet [0-9]+: J ${J:0:4}.*, F = \[.*;.*;.*\]"
    expect out 'none of a real body[.] Try more and smaller --compress steps'
    expect_exit 0 "${flags[@]}" --compress 0.1
    expect_no out 'inverted' ;;
  what_is_not_finite_is_said_with_its_tet)
    expect_exit 3 "${small[@]}" --young 1e300 --compress 0.1 --out o
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
      expect out 'continuing behind step 1, a compression of 0.05'
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
    expect out 'nothing is left: step 1, a compression of 0.05'
    for file in beads.csv checkpoint.h5 cube.vtkhdf run.json; do expect_same o/$file before/$file; done
    expect_exit 1 "${small[@]}" --compress 0.03 --out o --restart
    expect err '--restart: o has steps up to a compression of [0-9.]+ and none at 0.03' ;;
  a_restart_never_begins_anew)
    expect_exit 1 "${small[@]}" --out absent --restart
    expect err 'absent/checkpoint.h5: there is no checkpoint'
    [[ ! -e absent ]] || fail 'a folder was made'
    expect_exit 0 "${small[@]}" --compress 0.05 --out o
    cp -r o before
    expect_exit 1 --cells 8 --out o --restart
    expect err 'other settings: cells: 4 in the checkpoint, 8 in this run'
    expect_exit 1 "${small[@]}" --poisson 0.45 --precision float --out o --restart
    expect err 'poisson: 0.49 .*, 0.45'
    expect err 'precision: .*half.*, .*float'
    for file in beads.csv checkpoint.h5 cube.vtkhdf run.json; do expect_same o/$file before/$file; done ;;
  a_new_run_drops_the_checkpoint_of_an_old_one)
    expect_exit 0 "${small[@]}" --compress 0.05 --out o
    expect_exit 3 "${small[@]}" --young 1e300 --compress 0.1 --out o
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
    expect out 'moved.csv has no beads of a compression of 0.02'
    sed -i '3s/,[^,]*$/,wrong/' moved.csv
    expect_exit 1 "${small[@]}" --beads moved.csv
    expect err 'moved.csv:3: .*wrong'
    expect_exit 1 "${small[@]}" --beads absent.csv
    expect err 'absent.csv'
    expect_no out 'solved' ;;
  a_mesh_takes_the_place_of_the_cube)
    write_mesh 5 >m.msh
    expect_exit 0 --mesh m.msh --threads 1 --compress 0.05 --out o
    expect out '750 tets, 216 nodes, 2 levels'
    [[ -s o/cube.vtkhdf && ! -e o/beads.csv ]] || fail 'other files'
    expect_exit 0 --mesh m.msh --threads 1 --compress 0.05 --dry-run
    ((10 * $(sed -nE 's/^solver: ([0-9]+) bytes.*/\1/p' out) - 10 * $(number_of bytes o/run.json) == 0)) || fail 'other bytes'
    # The cube is that mesh: in both, tets give the same equilibrium.
    flags=(--threads 1 --volume tets --compress 0.05 --tolerance 1e-10 --precision double)
    expect_exit 0 --mesh m.msh "${flags[@]}" --out a
    expect_exit 0 --cells 5 "${flags[@]}" --out b
    awk -v a="$(number_of reaction a/run.json)" -v b="$(number_of reaction b/run.json)" \
      'BEGIN { exit !(a < 0 && (a - b) ^ 2 < 1e-14 * a * a) }' || fail 'another reaction' ;;
  a_mesh_by_itself_has_multigrid_over_a_background_grid)
    write_mesh 9 >m.msh
    expect_exit 0 --mesh m.msh --threads 1 --compress 0.05 --out a
    expect out 'note: multigrid over a background grid of 4 x 4 x 4 cells, and load steps: nested ones need .* --refine'
    expect out '4374 tets, 1000 nodes, 2 levels'
    expect a/run.json 'stepping.*loads'
    expect_exit 0 --mesh m.msh --threads 1 --compress 0.05 --preconditioner block-jacobi --out b
    expect_no out 'note'
    expect out '4374 tets, 1000 nodes, 1 levels'
    ((4 * $(number_of pcg_iterations a/run.json | head -1) < $(number_of pcg_iterations b/run.json | head -1))) ||
      fail 'many iterations'
    for flags in "" "--volume tets --precision double" "--refine 1 --precision float"; do
      # shellcheck disable=SC2086
      expect_exit 0 --mesh m.msh --threads 1 --compress 0.01 --out o $flags
      # shellcheck disable=SC2086
      expect_exit 0 --mesh m.msh --threads 1 --compress 0.01 --dry-run $flags
      said=$(sed -nE 's/^solver: ([0-9]+) bytes.*/\1/p' out)
      took=$(number_of bytes o/run.json)
      ((said == took)) || fail "$flags: $said bytes said, $took taken"
    done ;;
  a_refined_mesh_has_multigrid)
    write_mesh 2 >m.msh
    expect_exit 0 --mesh m.msh --refine 2 --threads 1 --compress 0.05
    expect out '3072 tets, 729 nodes, 3 levels'
    expect_no out 'block Jacobi' ;;
  a_mesh_that_is_not_sound_is_refused_with_places)
    write_mesh 2 7 >m.msh
    expect_exit 1 --mesh m.msh
    expect err 'm.msh cannot be used'
    expect err 'negative volume [(]element 7[)]'
    expect_exit 1 --mesh absent.msh
    expect err 'absent.msh'
    echo 'no mesh' >text.msh
    expect_exit 1 --mesh text.msh
    expect err 'text.msh' ;;
  *) fail 'no such rule' ;;
esac
