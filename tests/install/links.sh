#!/usr/bin/env bash
# links.sh FOLDER: checks that every relative link of the pages installed in FOLDER/package leads to something in the
# package, and none out of it.
set -euo pipefail
package=$(realpath "$1/package")
links=0 dead=0

# A page without its blocks of code and words in backticks, in which brackets are C++.
# shellcheck disable=SC2016  # the backticks are the page's
prose() { sed '/^ *```/,/^ *```/d' "$1" | sed -z 's/`[^`]*`//g'; }
while read -r page; do
  while read -r link; do
    ((++links))
    target=$(realpath -m "$(dirname "$page")/${link%%#*}")
    [[ -e $target && $target == "$package"/* ]] || { echo "FAILED: ${page#"$package/"} links to $link" >&2; dead=1; }
  done < <(prose "$page" | grep -oP '\]\(\K[^)]+' | grep -v '^[a-z]*:\|^#')
done < <(find "$package" -name '*.md')
((links > 20)) || { echo "FAILED: only $links links were found in $package" >&2; exit 1; }
exit "$dead"
