#!/usr/bin/env bash
# example_is_current.sh PHYSGEN ROOT FOLDER: fails when ROOT/generated/examples is not what PHYSGEN writes from README's schema, or the
# example stress has another one.
set -euo pipefail
physgen=$1 root=$2 work=$3/example_of_readme
rm -rf "$work"
mkdir -p "$work/written"
awk -v folder="$work" -f "$root/tools/examples/blocks.awk" "$root/README.md"
"$physgen" generate "$work/stress.h" -o "$work/written"
diff -ru "$root/generated/examples" "$work/written" || { echo "To renew it: tools/dev build release update-generated" >&2; exit 1; }
"$physgen" generate "$root/tools/examples/stress/stress.h" -o "$work/of_example"
diff -ru "$work/written" "$work/of_example" || { echo "tools/examples/stress/stress.h is not README's schema" >&2; exit 1; }
rm -rf "$work"
