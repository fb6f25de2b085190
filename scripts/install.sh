#!/usr/bin/env bash
# Installs what is missing of the given groups of packages.txt: scripts/install.sh build test
# Needs neither network nor root when nothing is missing. VERDIGRIS_INSTALL=0 leaves packages alone.
set -euo pipefail
list=$(dirname "${BASH_SOURCE[0]}")/packages.txt

[[ ${VERDIGRIS_INSTALL:-1} == 0 ]] && exit 0

fail() {
  printf '%s\n' "$@" >&2
  exit 1
}

wanted=()
while read -r group package _; do
  [[ " $* " == *" $group "* && " ${wanted[*]} " != *" $package "* ]] && wanted+=("$package")
done < "$list"

if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
  fail "No dpkg-query and apt-get here: this is not Debian or one of its kin." \
    "Install the equivalents of these packages, then call again with VERDIGRIS_INSTALL=0:" "  ${wanted[*]}"
fi

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2> /dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
((${#missing[@]} == 0)) && exit 0

by_hand="apt-get install --no-install-recommends ${missing[*]}"
root=()
if ((EUID != 0)); then
  command -v sudo > /dev/null || fail "Packages are missing, and there is no sudo. Ask an administrator for:" "  $by_hand"
  root=(sudo)
  [[ -t 0 ]] || root=(sudo -n) # nobody there to type a password
fi

echo "Installing ${#missing[@]} packages: ${missing[*]}"
apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300)
# A source that fails need not be one that is needed.
"${apt[@]}" update < /dev/null || echo "apt-get update failed; going on with the package lists that are there" >&2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! "${apt[@]}" install -y --no-install-recommends "${missing[@]}" < /dev/null > "$log" 2>&1; then
  tail -n 20 "$log" >&2
  fail "" "apt-get could not install the packages (its last lines are above)." \
    "Needed are Debian 12 or newer, its 'main' section, network and root. By hand:" "  $by_hand"
fi
