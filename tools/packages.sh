# shellcheck shell=bash disable=SC2154
# The Debian packages that building and checking physgen takes, and how they are installed. tools/dev sources this file
# behind $root, $build and its functions say, fail and have, which are used here.
packages=$root/tools/packages.txt
no_llvm_mark=$build/.no-llvm-in-archive  # remembers that the archive has no LLVM, so that later set-ups stay quick

# Prints the versions of LLVM that work, best first.
llvm_versions() {
  [[ -e $packages ]] || fail "there is no $packages, the list of packages: this needs a checkout of physgen"
  awk '$1 == "LLVM" { sub(/^LLVM +/, ""); print }' "$packages"
}
# Prints the lines of the list, "package reason": of LLVM in the version that is given; those above RUN, for `try`, and
# above MORE, for `first`; else all but LLVM's.
listed() {
  awk -v version="${1-}" '
    (version == "try" && $1 == "RUN") || (version == "first" && $1 == "MORE") { exit }
    /^#/ || !NF || $1 ~ /^(LLVM|RUN|MORE)$/ { next }
    sub(/LLVM/, version, $1) == (version ~ /[0-9]/)' "$packages"
}

# Prints those of its arguments that are not installed packages.
missing_packages() {
  local installed package
  installed=" $(dpkg-query -W -f '${db:Status-Status}=${binary:Package} ' "$@" 2>/dev/null || true)"
  installed=${installed//:+([a-z0-9])/}  # libgtest-dev:amd64
  for package in "$@"; do [[ $installed == *" installed=$package "* ]] || printf '%s ' "$package"; done
}

# Runs a command as root; without a terminal to ask for a password at, sudo must need none.
as_root() {
  if (($(id -u) == 0)); then
    env DEBIAN_FRONTEND=noninteractive "$@"
  elif have sudo && [[ -t 0 ]]; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    have sudo && sudo -n env DEBIAN_FRONTEND=noninteractive "$@"
  fi
}

# Renews apt's lists, for the packages named. That it fails is told and not final, the lists at hand may do; without apt
# or rights, what to do by hand is said instead.
update_package_lists() {
  local by_hand="install by hand: apt-get install --no-install-recommends $*"
  have apt-get || fail "there is no apt-get here; install these packages by hand: $*"
  as_root true || fail "packages need root or sudo; $by_hand"
  as_root apt-get -qq -o DPkg::Lock::Timeout=300 update >&2 || say 'apt-get update failed; going on with the old lists'
}

install_packages() {
  local log
  log=$(mktemp)
  as_root apt-get -qq -o DPkg::Lock::Timeout=300 install -y --no-install-recommends "$@" >"$log" 2>&1 || {
    cat "$log" >&2
    rm -f "$log"
    fail "apt-get could not install everything; by hand: apt-get install --no-install-recommends $*"
  }
  rm -f "$log"
}

# Prints the names in the first column of a table on standard input.
names() { awk '{ print $1 }'; }

# Installs what is missing. $1 = again: look for LLVM even if the archive had none the last time; try, first: only what
# `tools/dev try`, `tools/dev run` needs.
setup() {
  if ! have dpkg-query; then
    say 'not a Debian system: taking what tools/packages.txt lists as installed'
    return
  fi
  local versions version missing_llvm='' missing table
  versions=$(llvm_versions)
  if [[ ${1-} == try || ${1-} == first ]]; then
    versions=''
    table=$(listed "$1")
  else
    table=$(listed)
  fi
  for version in $versions; do
    # shellcheck disable=SC2046  # one word per package
    missing_llvm=$(missing_packages $(listed "$version" | names))
    [[ $missing_llvm ]] || break
  done
  # shellcheck disable=SC2046
  missing=$(missing_packages $(names <<<"$table"))
  if [[ ! $missing && ( ! $missing_llvm || ( ${1-} != again && -e $no_llvm_mark ) ) ]]; then
    [[ ! $missing_llvm ]] ||
      say 'no LLVM in the archive: no generator, headers from generated/ (tools/dev setup looks again)'
    return 0
  fi

  # shellcheck disable=SC2046,SC2086
  update_package_lists $missing ${missing_llvm:+$(listed "${versions%% *}" | names)}
  if [[ $missing_llvm ]]; then
    for version in $versions none; do
      [[ $version != none ]] || break
      [[ $(apt-cache policy "libclang-$version-dev" 2>/dev/null) =~ Candidate:\ [0-9] ]] && break
    done
    mkdir -p "$build"
    if [[ $version == none ]]; then
      say "the archive has no LLVM ${versions// /, }: going on without the generator, with the headers in generated/"
      touch "$no_llvm_mark"
    else
      rm -f "$no_llvm_mark"
      table+=$'\n'$(listed "$version")
      # shellcheck disable=SC2046
      missing+=$(missing_packages $(listed "$version" | names))
    fi
  fi
  [[ $missing ]] || return 0
  say 'installing:'
  local package reason
  while read -r package reason; do
    [[ " $missing" != *" $package "* ]] || printf '  %-20s %s\n' "$package" "$reason" >&2
  done <<<"$table"
  # shellcheck disable=SC2086
  install_packages $missing
}

# Prints the path of TOOL (clang-format, clang-tidy) of the best LLVM there is; installs one if there is none.
llvm_tool() {
  local versions version best
  versions=$(llvm_versions)
  for version in $versions; do ! have "$1-$version" || { command -v "$1-$version"; return; }; done
  best=$1-${versions%% *}
  say "installing $best"
  update_package_lists "$best"
  install_packages "$best"
  command -v "$best"
}
