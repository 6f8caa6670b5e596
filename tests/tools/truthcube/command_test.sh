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
small=(--cells 4 --threads 1)

case $rule in
  help_lists_flags_layouts_and_exit_codes)
    expect_exit 0 --help
    for flag in cells grading mesh refine material young poisson volume compress top plates plate-stiffness device precision layout preconditioner \
      product tolerance stepping historical out restart beads threads repeat timings dry-run set-up quiet scene time-step duration density damping fixed-order \
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
  empty_words_are_refused)
    for flag in out beads mesh poisson young damping compress cells; do
      expect_refused "--$flag: a word is empty, perhaps because a shell variable is not set" --$flag ''
      expect_refused "--$flag: a word is empty" --$flag=
    done
    expect_refused '--compress: a word is empty' --cells 4 --compress 0.1 '' ;;
  values_out_of_range_are_refused)
    expect_refused 'cells: Value 0 not in range' --cells 0
    expect_refused 'cells: Value -4 not in range' --cells -4
    expect_refused 'cells: Value 2.5 not in range 1 to 100000 of whole numbers' --cells 2.5
    expect_refused 'poisson = abc; give a number there' --poisson abc
    expect_refused '--cells 400: .* numbers up to [0-9]+, .* 2147483647; take --cells 274' --cells 400
    expect_refused "--poisson 0.5: Poisson's ratio must be above -1 and below 0.5" --poisson 0.5
    expect_refused "--poisson -1: Poisson's ratio must be above -1 and below 0.5" --poisson -1
    expect_refused "--poisson nan: Poisson's ratio must be above -1 and below 0.5" --poisson nan
    expect_exit 1 --cells 4 --young 1e30 --compress 0.1 --out o
    expect err "a Young's modulus of 1e[+]30 Pa over tets of 0.02 m is out of range for float: take double precision"
    expect_exit 0 --cells 4 --young 1e30 --compress 0.1 --precision double
    expect_refused "--young 0: Young's modulus must be positive" --young 0
    expect_refused '--compress .* between 0 and 1, .*; 1 is not such a number' --compress 1
    expect_refused '--compress .*; at 0 the body is at rest .*; begin with a larger number' --compress 0
    expect_refused '--compress .*; at 0 the body is at rest' --compress 0 0.05
    expect_refused '--compress .*; -0.1 is not such a number' --compress -0.1
    expect_refused '--compress .* 0.05 is not larger than 0.1' --compress 0.1 0.05
    expect_refused '--compress .*; nan is not such a number' --compress nan
    for bad in -0.1 0.51 nan inf; do
      expect_refused "--plate-tolerance $bad: .* number of mean edge lengths from 0 to 0.5; 1e-04 is common" \
        --mesh a.msh --plate-tolerance $bad
    done
    expect_refused 'plate-tolerance = much; give a number there' --mesh a.msh --plate-tolerance much
    expect_refused '--plate-stiffness 0: .* from 0.001 to 1e4' --plates contact --plate-stiffness 0
    for bad in 0 -1 0.99 nan inf; do
      expect_refused "--grading $bad: the grading is a number from 1 on, .* 1.5 is common" --grading $bad
    done
    expect_refused 'grading = steep; give a number there' --grading steep
    expect_refused '--grading 3: the widest of 32 cells along a side .* 45 times .*; --grading 2[.][0-9]+ fits' --cells 32 --grading 3
    expect_exit 0 --cells 32 --dry-run --grading "$(sed -nE 's/.*--grading ([0-9.]+) fits$/\1/p' err)"
    expect_refused '--tolerance 0: ' --tolerance 0 ;;
  flags_that_do_not_go_together_are_refused)
    expect_refused 'corotated.* no separate volume part to average; write --volume tets' --material corotated --volume patches
    expect_refused 'corotated.* no separate volume part to average; write --volume tets' --material corotated --volume nodes
    expect_refused 'restart continues the run in --out' --restart
    expect_refused 'excludes' --mesh a.msh --cells 4
    expect_refused 'refine is for a mesh' --refine 1
    expect_refused '--grading is for the cube: .*; remove --grading' --mesh a.msh --grading 1.5
    expect_refused 'plate-tolerance is for a mesh' --plate-tolerance 1e-3
    expect_refused 'plate-stiffness requires --plates contact; add it, or remove --plate-stiffness' --plate-stiffness 10
    expect_refused 'excludes' --historical --precision double
    expect_refused 'excludes' --historical --product assembled
    for flag in --dry-run --restart '--repeat 2' '--beads b.csv'; do
      # shellcheck disable=SC2086
      expect_refused "--set-up cannot take ${flag%% *}, because .*; remove ${flag%% *}\$" --set-up --out o $flag
    done
    expect_refused '--plates contact requires --product assembled' --plates contact --historical
    expect_refused '--volume nodes requires --product assembled' --volume nodes --historical
    expect_refused '--product matrix-free requires --preconditioner block-jacobi or none' --product matrix-free ;;
  materials_without_a_volume_part_run_by_tets)
    expect_exit 0 "${small[@]}" --material corotated --compress 0.02
    expect out "note: the energy of 'corotated' has no separate volume part to average: --volume tets"
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
    expect out 'note: an odd number of cells .* block Jacobi replaces multigrid; take 6 cells'
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
    expect_exit 0 --cells 8 --threads 1 --compress 0.4 0.45
    expect out 'free sides reach [0-9.]+ mm past the plates'
    expect_exit 0 --cells 8 --threads 1 --top frictionless --compress 0.05
    expect_no out 'free sides reach' ;;
  plates_with_contact_push_sides_back)
    expect_exit 0 --cells 8 --threads 1 --compress 0.45 --out held
    expect_exit 0 --cells 8 --threads 1 --compress 0.45 --plates contact --out contact
    expect out 'reach 0[.]0[0-9]+ mm past the plates; the lower one pushes them back with [0-9.]+ N, the upper one with [0-9.]+ N'
    awk -v a="$(number_of past_plates held/run.json)" -v b="$(number_of past_plates contact/run.json)" \
      'BEGIN { exit !(b > 0 && b < 1e-4 && b < a / 10) }' || fail 'past the plates'
    awk -v a="$(number_of reaction held/run.json)" -v b="$(number_of reaction contact/run.json)" \
      'BEGIN { exit !(b < a && b > 1.1 * a) }' || fail 'reaction'
    expect contact/run.json '"plates": "contact"'
    expect contact/run.json '"plate_stiffness": 100'
    expect held/run.json '"plates": "held"'
    expect_exit 0 --cells 8 --threads 1 --compress 0.45 --plates contact --plate-stiffness 1000 --out stiff
    awk -v a="$(number_of past_plates contact/run.json)" -v b="$(number_of past_plates stiff/run.json)" \
      'BEGIN { exit !(b < a / 2) }' || fail 'stiffness'
    expect_exit 0 --cells 8 --threads 1 --top frictionless --compress 0.5 --plates contact
    expect out 'past the plates; the lower one pushes them back with [0-9.]+ N, the upper one with 0 N'
    expect_exit 1 --cells 8 --threads 1 --compress 0.45 0.5 --out contact --restart
    expect err 'plates: .*contact.*, .*held'
    expect_exit 0 --cells 8 --threads 1 --compress 0.45 0.5 --plates contact --out contact --restart
    expect_exit 0 --cells 8 --threads 1 --compress 0.45 0.5 --plates contact --out whole
    for file in beads.csv checkpoint.h5; do expect_same whole/$file contact/$file; done ;;
  quiet_prints_nothing)
    for flags in "--quiet --out o" "-q --dry-run" "-q --restart --out o"; do
      # shellcheck disable=SC2086
      expect_exit 0 "${small[@]}" $flags
      [[ ! -s out && ! -s err ]] || fail "output of $flags"
    done ;;
  output_that_cannot_be_written_is_said)
    : >out
    for flags in --help "--dry-run" "${small[*]} --compress 0.02 --out o"; do
      got=0
      # shellcheck disable=SC2086
      "$program" $flags >/dev/full 2>err || got=$?
      ((got == 1)) || fail "exit $got of $flags"
      expect err '^truthcube: cannot write all of the standard output; is the disk full[?]$'
    done
    [[ $(wc -l <o/beads.csv) == 344 ]] || fail 'no files' ;;
  closed_standard_streams_do_not_become_files)
    mkdir o
    touch o/run.lock # the first file that a run opens, which it removes
    ln o/run.lock kept
    stdbuf -o0 "$program" "${small[@]}" --compress 0.02 --out o >&- 2>err || fail 'no success'
    : >out
    expect kept '^process [0-9]+'
    expect_no kept 'reaction|residual' ;;
  more_threads_than_processors_are_said_once)
    expect_exit 0 --cells 2 --threads 4000 --dry-run --quiet
    expect err '^truthcube: 4000 threads share the [0-9]+ processors? that this process may use .*more threads are no faster'
    (($(wc -l <err) == 1)) || fail 'said more than once'
    expect_exit 0 --cells 2 --threads 1 --dry-run
    [[ ! -s err ]] || fail 'a warning for one thread'
    expect_exit 0 --cells 2 --dry-run
    [[ ! -s err ]] || fail 'a warning for none'
    OMP_NUM_THREADS=1 taskset -c "$(taskset -cp $$ | sed -E 's/.*: ([0-9]+).*/\1/')" "$program" --cells 2 --threads 2 --dry-run >out 2>err
    expect err '2 threads share the 1 processor that this process may use' ;;
  the_command_in_the_record_can_be_typed_again)
    expect_exit 0 "${small[@]}" --compress 0.02 --out "it's a folder"
    expect "it's a folder/run.json" '"command": "truthcube --cells 4 --threads 1 --compress 0.02 --out '"'it'.{2}''s a folder'"'"' ;;
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
  memory_that_ends_in_the_set_up_is_said_with_its_stage)
    expect_exit 0 --cells 64 --threads 1 --volume tets --dry-run
    said=$(sed -nE 's/^solver: ([0-9]+) bytes.*/\1/p' out)
    # As much as the arrays and lists take, and so less than the process does.
    more=$(sed -nE 's/^set-up: ([0-9.]+) GB more.*/\1/p' out)
    ulimit -v "$(awk -v said="$said" -v more="$more" 'BEGIN { print int((said + (more + 0.02) * 1e9) / 1024) }')"
    expect_exit 1 --cells 64 --threads 1 --volume tets --out o
    expect err '^truthcube: the memory ended in its stage "[a-z ]+": .* [0-9]+ bytes'
    [[ -z $(ls -A o) ]] || fail 'files are left' ;;
  ctrl_c_ends_the_set_up)
    got=0
    timeout -k 1 -s INT 0.3 "$program" --cells 128 --volume tets --out o >out 2>err || got=$?
    ((got == 124)) || fail "exit $got" # 137 where it had to be killed
    ;;
  the_stages_of_the_set_up_are_in_the_record_and_add_up)
    expect_exit 0 "${small[@]}" --compress 0.02 --timings --out o
    expect out '^  rows of tets +[0-9.]+ +[0-9.]+ +[0-9.]+ +[0-9.]+$'
    expect out '^  a copy of memory reads and writes [0-9.]+ GB/s$'
    sed -n '/"setup_stages"/,/^  ]/p' o/run.json | awk -F': ' -v whole="$(number_of setup_seconds o/run.json)" '
      /"seconds"/ { sum += $2 } END { exit !(sum > 0.99 * whole && sum < 1.01 * whole) }' || fail 'stages are not the whole' ;;
  a_set_up_ends_before_the_first_newton_step)
    expect_exit 0 "${small[@]}" --set-up --out o
    expect out '^  rows of tets +[0-9.]+ +[0-9.]+ +[0-9.]+ +[0-9.]+$'
    expect out '^  a copy of memory reads and writes [0-9.]+ GB/s$'
    expect_no out 'compression|solved'
    expect o/run.json '"name": "arrays of levels"'
    expect o/run.json '"steps": \[\]'
    [[ $(ls o) == $'run.json\nrun.lock' || $(ls o) == run.json ]] || fail "files: $(ls o)"
    # What a run makes is what a set-up makes.
    expect_exit 0 "${small[@]}" --compress 0.02 --out run
    for key in bytes nodes tets; do
      [[ $(number_of $key run/run.json) == "$(number_of $key o/run.json)" ]] || fail "$key differ"
    done
    expect_exit 1 "${small[@]}" --set-up --out run
    expect err '--set-up: run has the files of a run, whose run.json would be replaced .*; choose another --out'
    expect run/run.json '"newton"'
    for scene in linear-elastic explicit-dynamics implicit-dynamics quasistatic; do
      expect_exit 0 --scene $scene --cells 4 --threads 1 --compress 0.02 --set-up
      expect_no out 'solved|states of'
    done ;;
  lists_that_come_and_go_are_in_huge_pages)
    grep -vq '\[never\]' /sys/kernel/mm/transparent_hugepage/enabled || { echo 'skipped: no huge pages'; exit 77; }
    # How often the system had to hand out a page: with a heap of small ones, of 4 KiB, 0.7 times for each that there is.
    python3 - "$program" --cells 32 --threads 1 --set-up --quiet <<'PYTHON' >out 2>err || { (($? == 77)) && cat out && exit 77; fail 'too many'; }
import mmap, resource, subprocess, sys
def system_has_some():  # memory that is in use everywhere has none in one piece
    begin, size = resource.getrusage(resource.RUSAGE_SELF).ru_minflt, 256 << 20
    with mmap.mmap(-1, size, mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS) as memory:
        memory.madvise(mmap.MADV_HUGEPAGE)
        memory[0:size:4096] = bytes(size // 4096)
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - begin < 0.1 * size / 4096
subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
if 4 * used.ru_minflt > 0.4 * used.ru_maxrss:
    if system_has_some(): sys.exit(f"{used.ru_minflt} times for {used.ru_maxrss} kB")
    print("skipped: the system has no huge pages left")
    sys.exit(77)
PYTHON
    ;;
  *) fail 'no such rule' ;;
esac
