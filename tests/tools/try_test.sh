#!/usr/bin/env bash
# try_test.sh ROOT FOLDER: runs `tools/dev try` of the tree ROOT on a copy of what it reads below FOLDER.
set -euo pipefail
root=$1 work="$2/first minute" # with a space: paths are users' paths
rm -rf "$work"
mkdir -p "$work/tools"
cp "$root"/tools/{dev,first.sh,packages.sh,packages.txt,tests.sh} "$work/tools"
ln -s "$root"/{README.md,generated,runtime} "$work"
ln -s "$root/tools/examples" "$work/tools/examples"
output=$("$work/tools/dev" try)
fail() { printf 'FAILED: %s\n%s\n' "$*" "$output" >&2; exit 1; }
grep -q '^the first object has 101325 Pa$' <<<"$output" || fail "README's example printed something else"
(($(grep -cE '^  (array of structs|struct of arrays|tiles of 16) +[0-9.]+ ms  [A-Z].*\.$' <<<"$output") == 6)) || fail 'there are not six lines of times'
grep -qE '^  array of structs +0\.s0 +0\.s1 +0\.s2 +0\.s3 +0\.s4 +0\.s5 +0\.p +1\.s0 ' <<<"$output" || fail 'the array of structs is drawn wrongly'
grep -qE '^  struct of arrays +0\.s0 +1\.s0 +2\.s0 ' <<<"$output" || fail 'the struct of arrays is drawn wrongly'
grep -qE '^  tiles of 2 +0\.s0 +1\.s0 +0\.s1 +1\.s1 ' <<<"$output" || fail 'tiles are drawn wrongly'
rm -rf "$work"
