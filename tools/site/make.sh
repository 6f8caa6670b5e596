#!/usr/bin/env bash
# make.sh FOLDER: makes the site of documentation in FOLDER/html with Doxygen, from the pages of the tree and the headers that are
# installed, and checks its links.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)
mkdir -p "$1"
PHYSGEN_SITE=$(cd "$1" && pwd -P)
cd "$root"
PHYSGEN_VERSION=$(sed -n 's/^## \([0-9.]*\)$/\1/p;T;q' CHANGELOG.md)
# of_files ENDINGS FORMAT: prints what find's -printf FORMAT says of each file of the tree that has one of the endings, sorted,
# each text once, in one line.
of_files() { find . -name build -prune -o -name '.*' -not -name . -prune -o -regex ".*\.\($1\)" -printf "$2\n" | sort -u | tr '\n' ' '; }
PHYSGEN_PAGES=$(of_files md %P)
PHYSGEN_PICTURES=$(of_files 'png\|svg' %h)  # their folders
PHYSGEN_HEADERS='runtime/include/physgen tools/fem/kernels tools/fem/materials tools/fem/mesh tools/fem/numerics schemas/elasticity.h'
export PHYSGEN_SITE PHYSGEN_VERSION PHYSGEN_PAGES PHYSGEN_HEADERS PHYSGEN_PICTURES
rm -rf "$PHYSGEN_SITE/html"
copies=$(mktemp -d)
trap 'rm -rf "$copies"' EXIT
tools/site/filtered_copies.py "$copies"
(cd "$copies" && doxygen "$root/tools/site/Doxyfile")
tools/site/check_links.py "$PHYSGEN_SITE/html"
