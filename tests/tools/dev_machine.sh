# shellcheck shell=bash disable=SC2016,SC2154
# A machine for dev_test.sh, which sources this file: functions that run the copied script and say what it did, and commands
# in the place of the system's. $root is the copied tree, $work the folder around it, $calls the file of calls.
fail() {
  printf 'FAILED: %s\n--- output:\n%s\n--- calls:\n%s\n' "$*" "$(cat "$work/output")" "$(cat "$calls")" >&2
  exit 1
}
# fake NAME BODY: a command NAME that records its call, then runs BODY.
fake() { recorder "$work/bin/$1" "${2-}"; }
# program PATH: a program in the copied tree that records its call.
program() { recorder "$root/$1"; }
recorder() {
  mkdir -p "$(dirname "$1")"
  printf '#!/usr/bin/env bash\necho "%s $*" >>"$calls"\n%s\n' "${1##*/}" "${2-}" >"$1"
  chmod +x "$1"
}
# dev STATUS ARGUMENTS...: runs the script from another folder; fails when its exit status is not STATUS.
dev() {
  local expected=$1 status=0
  shift
  (cd / && "$root/tools/dev" "$@") >"$work/output" 2>&1 </dev/null || status=$?
  ((status == expected)) || fail "tools/dev $* gave exit status $status, expected $expected"
}
says() { grep -qF -- "$1" "$work/output" || fail "not said: $1"; }
called() { grep -q -- "$1" "$calls" || fail "not called: $1"; }
not_called() { ! grep -q -- "$1" "$calls" || fail "called: $1"; }

# A machine: installed packages are the lines of $work/installed, apt's those that match $apt_has.
every_package() {
  sed -E '/^(#|LLVM |RUN |MORE |$)/d; s/ .*//; s/LLVM/22/; s/^lib(gtest|benchmark)-dev$/&:amd64/' "$root/tools/packages.txt"
}
export apt_has='-22'
every_package >"$work/installed"
fake dpkg-query 'sed "s/.*/installed=& /" "$work/installed" | tr -d "\n"'
fake apt-get
fake apt-cache 'if [[ $2 =~ $apt_has ]]; then echo "  Candidate: 1:1.0"; else echo "  Candidate: (none)"; fi'
fake id 'echo 0'
fake sudo 'exit 1'
without() { every_package | grep -vE "$1" >"$work/installed"; }
# The build: cmake makes nothing, ctest fails with 8, and physbench is there. No nvcc and no GPU, unless a rule says so.
fake cmake 'mkdir -p build'
fake ctest 'exit 8'
fake nvidia-smi 'exit 9'
# Rules that need no nvcc cannot hide one in /usr/local/cuda: it is taken out of the copied script.
sed -i "s|/usr/local/cuda/bin/nvcc|$(printf %q "$work")/none/nvcc|" "$root/tools/dev"
PATH=$(tr : '\n' <<<"$PATH" | while read -r entry; do [[ -x $entry/nvcc ]] || printf '%s:' "$entry"; done)
touch "$work/output"
