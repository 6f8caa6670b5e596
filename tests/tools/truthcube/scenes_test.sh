#!/usr/bin/env bash
# Tests of truthcube --scene as its users run it: scenes_test.sh RULE PROGRAM FOLDER
set -euo pipefail
rule=$1 program=$2 folder=$3/$1
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
export OMP_NUM_THREADS=1
. "$here/command_helpers.sh"
small=(--cells 4 --threads 1)
motion=("${small[@]}" --compress 0.05 --duration 0.02 --frames 4)
same_numbers() { # keys, files
  for key in $1; do
    [[ $(number_of "$key" "$2") == "$(number_of "$key" "$3")" ]] || fail "another $key"
  done
}

case $rule in
  scenes_of_equilibria_are_what_their_flags_are)
    expect_exit 0 "${small[@]}" --compress 0.05 --out plain
    expect plain/run.json '"scene": "everything"'
    expect plain/run.json '"arrays": "everything"'
    stable=("${small[@]}" --compress 0.05 --material stable-neo-hookean --precision float)
    expect_exit 0 "${stable[@]}" --out flags
    expect_exit 0 "${small[@]}" --compress 0.05 --scene quasistatic --out named
    expect named/run.json '"arrays": "quasistatic"'
    same_numbers 'energy reaction residual' flags/run.json named/run.json
    cmp flags/beads.csv named/beads.csv || fail "pruned arrays have other results"
    expect_exit 0 "${stable[@]}" --volume tets --poisson 0.45 --out flags
    expect_exit 0 "${small[@]}" --compress 0.05 --scene quasistatic --volume tets --poisson 0.45 --out named
    same_numbers 'energy reaction residual' flags/run.json named/run.json
    cmp flags/beads.csv named/beads.csv || fail "pruned arrays have other results by tets"
    expect_exit 0 "${stable[@]}" --product matrix-free --preconditioner block-jacobi --out flags
    expect_exit 0 "${small[@]}" --compress 0.05 --scene matrix-free --out scene
    expect scene/run.json '"product": "matrix-free"'
    same_numbers 'energy reaction residual' flags/run.json scene/run.json
    cmp flags/beads.csv scene/beads.csv || fail "pruned arrays have other results"
    (($(number_of bytes scene/run.json) < $(number_of bytes flags/run.json))) || fail "nothing is pruned"
    expect_exit 0 "${small[@]}" --compress 0.05 --scene matrix-free --preconditioner none
    expect_exit 0 "${small[@]}" --compress 0.05 --material fixed-corotated --precision float --volume tets --out flags
    expect_exit 0 "${small[@]}" --compress 0.05 --scene fixed-corotated --out scene
    same_numbers 'energy reaction residual' flags/run.json scene/run.json
    cmp flags/beads.csv scene/beads.csv || fail "pruned arrays have other results" ;;
  every_scene_runs_on_arrays_of_its_own)
    expect_exit 0 "${motion[@]}" --scene implicit-dynamics --tolerance 1e-6 --out o
    expect o/run.json '"arrays": "implicit_dynamics"'
    expect o/run.json '"material": "stable-neo-hookean"'
    expect o/run.json '"precision": "float"'
    expect_no out 'arrays of the scene everything'
    # Schwarz blocks stand in the arrays of everything; neither they nor multigrid change more than rounding does.
    expect_exit 0 "${motion[@]}" --scene implicit-dynamics --tolerance 1e-6 --preconditioner schwarz --out p
    expect p/run.json '"arrays": "everything"'
    expect out 'note: this motion uses the arrays of the scene everything, because those of implicit-dynamics are only for'
    paste <(number_of kinetic_energy o/run.json) <(number_of kinetic_energy p/run.json) |
      awk '!(($1 / $2 - 1) ^ 2 < 1e-8) { print; bad = 1 } END { exit bad || NR != 4 }' >&2 || fail 'another motion'
    for scene in explicit-dynamics linear-elastic quasistatic; do
      arrays=${scene//-/_}
      [[ $scene == explicit-dynamics ]] && flags=("${motion[@]}") || flags=("${small[@]}" --compress 0.02)
      [[ $scene == linear-elastic ]] && arrays=linear_elastic_assembled
      expect_exit 0 "${flags[@]}" --scene $scene --out o
      expect o/run.json "\"arrays\": \"$arrays\""
    done
    # A matrix-free product finds the equilibrium of the assembled one, in each precision.
    for precision in half float double; do
      linear=("${small[@]}" --scene linear-elastic --precision $precision --compress 0.02)
      expect_exit 0 "${linear[@]}" --out o
      expect_exit 0 "${linear[@]}" --product matrix-free --preconditioner block-jacobi --out p
      expect p/run.json '"arrays": "linear_elastic"'
      awk -v a="$(number_of reaction o/run.json)" -v b="$(number_of reaction p/run.json)" \
        'BEGIN { exit !(a < 0 && (a / b - 1) ^ 2 < 1e-8) }' || fail "$precision: other reactions"
    done ;;
  flags_that_choose_otherwise_are_refused)
    expect_refused 'no scene matrix-fre; did you mean matrix-free[?]' --scene matrix-fre
    expect_refused 'matrix-free requires --product matrix-free; remove --' --scene matrix-free --product assembled
    expect_refused 'requires --preconditioner block-jacobi or none' --scene matrix-free --preconditioner multigrid
    expect_refused 'fixed-corotated requires --material fixed-corotated' --scene fixed-corotated --material neo-hookean
    expect_refused 'quasistatic requires --precision float; remove --' --scene quasistatic --precision double
    expect_refused 'quasistatic requires --volume patches' --scene quasistatic --volume nodes
    expect_refused 'matrix-free cannot take --historical, because only --scene everything has it' --scene matrix-free --historical
    expect_refused 'quasistatic cannot take --preconditioner schwarz' --scene quasistatic --preconditioner schwarz
    expect_refused 'implicit-dynamics requires --product assembled' --scene implicit-dynamics --product matrix-free
    expect_refused 'implicit-dynamics cannot take --stepping, because it steps in time; remove --stepping' --scene implicit-dynamics --stepping nested
    expect_refused 'implicit-dynamics cannot take --restart' --scene implicit-dynamics --out o --restart
    expect_refused 'explicit-dynamics cannot take --preconditioner, because .* solve no' --scene explicit-dynamics --preconditioner none
    expect_refused 'explicit-dynamics cannot take --tolerance' --scene explicit-dynamics --tolerance 1e-3
    expect_refused 'explicit-dynamics requires --plates held' --scene explicit-dynamics --plates contact
    expect_refused 'explicit-dynamics requires --volume tets' --scene explicit-dynamics --volume patches
    expect_refused 'moves the plate to one compression, and --compress has 2' --scene explicit-dynamics --compress 0.1 0.2
    expect_refused 'linear-elastic cannot take --material' --scene linear-elastic --material corotated
    expect_refused 'linear-elastic cannot take --historical' --scene linear-elastic --historical
    expect_refused 'linear-elastic requires --volume tets' --scene linear-elastic --volume nodes
    for flag in time-step duration density damping; do
      expect_refused "everything cannot take --$flag, because only --scene implicit-dynamics and" --$flag 1
    done
    expect_refused 'explicit-dynamics takes --fixed-order only with --device cuda: on the CPU' --scene explicit-dynamics --fixed-order
    expect_refused 'implicit-dynamics cannot take --fixed-order, because only --scene explicit' \
      --scene implicit-dynamics --fixed-order
    expect_refused 'everything cannot take --fixed-order' --fixed-order
    expect_refused '--density 0: the density' --scene implicit-dynamics --density 0
    expect_refused '--duration -1: the time' --scene implicit-dynamics --duration -1
    expect_refused '--damping -2: the damping' --scene explicit-dynamics --damping -2
    expect_refused '--time-step nan: the time step' --scene explicit-dynamics --time-step nan
    expect_refused 'frames: Value 0 not in range' --scene explicit-dynamics --frames 0 ;;
  a_dry_run_says_the_bytes_that_a_scene_takes)
    for scene in quasistatic matrix-free fixed-corotated linear-elastic implicit-dynamics; do
      flags=("${small[@]}" --scene $scene --precision float --compress 0.02)
      [[ $scene == implicit-dynamics ]] && flags+=(--duration 0.004 --frames 1)
      [[ $scene == linear-elastic ]] && flags+=(--product matrix-free --preconditioner block-jacobi)
      expect_exit 0 "${flags[@]}" --dry-run
      said=$(sed -nE 's/^solver: ([0-9]+) bytes, .*/\1/p' out)
      expect_exit 0 "${flags[@]}" --out $scene
      ((said == $(number_of bytes $scene/run.json))) || fail "$scene: other bytes"
    done
    for scene in implicit-dynamics explicit-dynamics linear-elastic; do
      for precision in half double; do
        flags=("${small[@]}" --scene $scene --precision $precision --compress 0.02)
        [[ $scene == linear-elastic ]] || flags+=(--duration 0.004 --frames 1)
        expect_exit 0 "${flags[@]}" --dry-run
        said=$(sed -nE 's/^solver: ([0-9]+) bytes, .*/\1/p' out)
        expect_exit 0 "${flags[@]}" --out $scene
        ((said == $(number_of bytes $scene/run.json))) || fail "$scene, $precision: other bytes"
      done
    done ;;
  a_motion_writes_its_states)
    for scene in implicit-dynamics explicit-dynamics; do
      expect_exit 0 "${motion[@]}" --scene $scene --damping 5 --out $scene
      expect out "^4 states of [0-9]+ time steps of [0-9.e-]+ s each$"
      (($(grep -cE '^ +0[.]0[0-9]+ +0[.][0-9]+ ' out) == 4)) || fail 'not a line for each state'
      for file in cube.vtkhdf beads.csv run.json; do [[ -s $scene/$file ]] || fail "no $file"; done
      [[ ! -e $scene/checkpoint.h5 ]] || fail 'a checkpoint that nothing goes on from'
      (($(wc -l <$scene/beads.csv) == 4 * 343 + 1)) || fail 'other rows of beads'
      expect $scene/run.json "\"scene\": \"$scene\""
      # Half-way to the middle the plate has moved by half, from then on by all; at last the body moves on.
      paste <(number_of time $scene/run.json) <(number_of compression $scene/run.json) \
        <(number_of kinetic_energy $scene/run.json) | awk 'function is(a, b) { return (a - b) ^ 2 < 1e-20 }
          !is($1, 0.005 * NR) || !is($2, NR == 1 ? 0.025 : 0.05) || !($3 > 1e-9) { print; bad = 1 }
          END { exit bad || NR != 4 }' >&2 || fail "$scene: other states"
    done
    # The schemes agree, the plate having moved by half, to what their time steps leave.
    expect_exit 0 "${motion[@]}" --scene implicit-dynamics --material neo-hookean --volume tets --time-step 1e-5 --out i
    expect_exit 0 "${motion[@]}" --scene explicit-dynamics --time-step 1e-5 --out e
    awk -v a="$(number_of kinetic_energy i/run.json | sed -n 1p)" -v b="$(number_of kinetic_energy e/run.json | sed -n 1p)" \
      'BEGIN { exit !((a / b - 1) ^ 2 < 1e-4) }' || fail 'other kinetic energies' ;;
  a_slow_motion_ends_at_the_equilibrium)
    expect_exit 0 "${small[@]}" --volume tets --compress 0.05 --out rest
    expect_exit 0 "${small[@]}" --volume tets --compress 0.05 --material neo-hookean --scene implicit-dynamics --duration 1000 --frames 2 --out slow
    awk -v a="$(number_of reaction rest/run.json)" -v b="$(number_of reaction slow/run.json | tail -1)" \
      'BEGIN { exit !((a / b - 1) ^ 2 < 1e-6) }' || fail 'another reaction' ;;
  steps_that_are_too_long_are_said)
    expect_exit 1 "${motion[@]}" --scene explicit-dynamics --time-step 1
    expect err '--time-step 1: explicit steps of this body at rest are stable up to about [0-9.e-]+ s'
    stable=$(sed -nE 's/.*about ([0-9.e-]+) s,.*/\1/p' err)
    # Stable at rest, and not where tets are half as high.
    expect_exit 3 "${small[@]}" --scene explicit-dynamics --compress 0.5 --duration 0.5 --frames 2 --time-step "$stable"
    expect err 'the motion is not finite at [0-9.]+ s, time step [0-9]+ of this state: tet [0-9]+ has a stress .* F = \['
    expect err 'A time step of .* Try --time-step [0-9.e-]+, or --scene implicit'
    # A look every few steps ends it long before the state is due.
    expect_exit 3 "${small[@]}" --scene explicit-dynamics --compress 0.9 --duration 20 --frames 1 --time-step "$stable"
    (($(sed -nE 's/.* time step ([0-9]+) of this state.*/\1/p' err) < 40000)) || fail 'all steps were taken'
    expect_exit 3 "${small[@]}" --scene implicit-dynamics --material neo-hookean --young 1e300 --precision double --compress 0.1
    expect err 'no equilibrium with inertia was found after 0 s.* There, tet [0-9]+ .*F = \[' ;;
  inverted_tets_of_a_motion_are_said)
    # Ten metres a second: faster than the body gives way.
    expect_exit 0 "${small[@]}" --scene implicit-dynamics --material neo-hookean --compress 0.9 --duration 0.02 --frames 4 \
      --out o
    mapfile -t J < <(number_of smallest_J o/run.json)
    inverted=0
    for number in "${J[@]}"; do [[ $number != -* ]] || inverted=$((inverted + 1)); done
    ((${#J[@]} == 4 && inverted > 0)) || fail 'no inverted tets'
    (($(grep -cE '^ .* +-[0-9.]+ +[0-9.]+  inverted$' out) == inverted)) || fail 'other states are marked'
    expect err "^truthcube: warning: $inverted of 4 states have inverted tets[.]$"
    (($(grep -cE '^truthcube: warning: at [0-9.]+ s, [0-9]+ tets? (is|are) inverted, (most of all )?tet [0-9]+: J -[0-9.]+, F = \[.*;.*;.*\][.] No real body .* Try a shorter --time-step' err) == 1)) ||
      fail 'it is not told once'
    expect_exit 0 "${motion[@]}" --scene implicit-dynamics
    expect_no out 'inverted'
    expect_no err 'inverted' ;;
  linear_elastic_equilibria_scale_with_the_load)
    expect_exit 0 "${small[@]}" --scene linear-elastic --precision double --tolerance 1e-12 --compress 0.05 0.1 --out o
    expect out 'note: linear elasticity takes the change of volume tet by tet'
    expect out 'solved in [0-9.]+ s: 1 linear solves and [0-9]+ PCG'
    number_of reaction o/run.json | awk 'NR == 1 { a = $1 } NR == 2 { exit !(a < 0 && ($1 / a - 2) ^ 2 < 1e-16) }' ||
      fail 'reactions do not scale'
    expect_exit 0 "${small[@]}" --scene linear-elastic --precision double --tolerance 1e-12 --compress 0.05 --out p
    expect_exit 0 "${small[@]}" --scene linear-elastic --precision double --tolerance 1e-12 --compress 0.05 0.1 --out p --restart
    expect out 'continuing after step 1'
    expect_same o/beads.csv p/beads.csv ;;
  an_interrupt_ends_a_motion_with_what_is_done)
    "$program" "${small[@]}" --scene explicit-dynamics --duration 1000 --frames 10000 --out o >out 2>err &
    pid=$!
    until [[ -s o/beads.csv && $(wc -l <o/beads.csv) -gt 400 ]]; do
      kill -0 $pid 2>/dev/null || fail 'it ended before the first state'
      sleep 0.05
    done
    kill -INT $pid
    got=0
    wait $pid || got=$?
    ((got == 130)) || fail "exit $got instead of 130"
    done=$(number_of time o/run.json | wc -l)
    expect out "interrupted; $done states are written"
    (($(wc -l <o/beads.csv) == 343 * done + 1)) || fail 'beads of other states than the record' ;;
  *) fail 'no such rule' ;;
esac
