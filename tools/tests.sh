# shellcheck shell=bash disable=SC2154
# How tests are run: all, a quick selection, and random inputs. tools/dev sources this file and calls run_tests and fuzz; its $root,
# $build and functions setup, build, jobs, say and fail are used here.

run_tests() {
  if [[ ${1-} == --quick ]]; then
    shift
    (($# == 0)) || fail "test --quick takes no other arguments, not $*"
    quick_tests
    return
  fi
  say '1 of 3: packages'
  setup
  say '2 of 3: compile everything'
  build release
  say "3 of 3: test; a line 'n/N Test' says how many of all are done"
  ctest --test-dir "$build/release" --output-on-failure -j "$(jobs)" "$@" | shorten_skipped
  return "${PIPESTATUS[0]}"
}

# Passes ctest's output on, but for the names of tests that were skipped, of which it gives the number.
shorten_skipped() {
  local line listing='' skipped=0  # not awk: Debian's reads a pipe in blocks, so that lines would come late
  while IFS= read -r line; do
    if [[ $line == 'The following tests did not run:'* ]]; then
      listing=1
    elif [[ $listing && ($line == *'(Skipped)' || $line == *'(Disabled)') ]]; then
      skipped=$((skipped + 1))
    elif [[ $listing && $line == *'('* ]]; then
      echo "did not run: $line"
    elif [[ ! $listing || ${line//[[:space:]]/} ]]; then
      listing=''
      printf '%s\n' "$line"
    fi
  done
  ((!skipped)) || echo "$skipped tests were skipped: they need a GPU, a library or a compiler that is not here"
}

# A selection that needs no more than the target quick_tests, whose programs of tests CMake lists in quick_tests.txt.
quick_names='^(tools_dev|pages|sources\.hang|report\.figures|physgen_generate\.[a-z_]*$|generated.*from_schemas|install\.(links|the_example_of_readme))'
quick_tests() {
  local program number=0 programs=() failed=()
  setup
  build release quick_tests
  mapfile -t programs <"$build/release/quick_tests.txt"
  for program in "${programs[@]}"; do
    say "$((++number)) of $((${#programs[@]} + 1)): $program"
    "$build/release/bin/$program" --gtest_brief=1 || failed+=("$program")
  done
  say "$((++number)) of $number: pages, scripts, wrong calls of CMake, the installation and README's example"
  ctest --test-dir "$build/release" --output-on-failure -j "$(jobs)" -R "$quick_names" || failed+=(ctest)
  ((!${#failed[@]})) || { say "failed: ${failed[*]}"; return 1; }
  say 'all of the quick tests passed; tools/dev test runs the others, too'
}

fuzz() {
  local duration=(--minutes 10) targets=(physgen_command) script=$build/release/fuzz/run
  [[ " $* " != *' --minutes'* ]] || duration=()
  if [[ ${1-} == --programs ]]; then
    targets+=(physgen_runtime) script=$build/release/programs/run
    shift
  fi
  setup
  build release "${targets[@]}"
  [[ -x $script ]] || fail 'fuzz needs LLVM for the generator and /usr/bin/python3'
  nice "$script" "${duration[@]}" "$@"
}
