#!/usr/bin/env bash
# Set up what is missing, for ./run and ./test: `packaging/setup.sh run|dev`.
# System packages through apt-get where that is allowed, the rest into .venv.
# Says what it does on stderr; exit status 0 means that .venv/bin/hapticplayer can start.
set -euo pipefail

kind=${1:?run or dev}
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
venv=$root/.venv
doctor=$root/hapticplayer/doctor.py
packages=$root/packaging/apt-packages.txt

say() { printf 'hapticplayer set-up: %s\n' "$*" >&2; }
die() { say "$@"; exit 1; }

lock_of() {
  case $1 in
    run) printf '%s' "$root/packaging/requirements.lock" ;;
    dev) printf '%s' "$root/packaging/requirements-dev.lock" ;;
    *) die "unknown set-up '$1'" ;;
  esac
}

# All that an environment follows from. The place is part of it, because the scripts in
# .venv name their interpreter by its absolute path.
fingerprint() {
  {
    printf '%s\n' "$root" "$(readlink -f -- "$venv/bin/python3")"
    cat -- "$root/pyproject.toml" "$packages" "$(lock_of "$1")"
  } | sha256sum
}

is_current() {
  [[ -x $venv/bin/hapticplayer && -x $venv/bin/python3 && -r $venv/stamp-$1 ]] &&
    [[ $(<"$venv/stamp-$1") == "$(fingerprint "$1")" ]]
}

# The environment must not be made with its own interpreter, which an active one offers.
find_python() {
  local search candidate
  search=:$PATH:
  search=${search//:"$venv/bin":/:}
  for candidate in python3 python3.14 python3.13 python3.12 python3.11; do
    python=$(PATH=$search command -v "$candidate") || continue
    if "$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))'; then
      return 0
    fi
  done
  return 1
}

missing() { "$python" -I "$doctor" --missing-apt "$1"; }

# The words before apt-get that give it the right to install, or failure.
find_right() {
  if ! command -v apt-get >/dev/null; then
    return 1
  elif ((EUID == 0)); then
    right=(env)
  elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
    right=(sudo -n env)
  elif command -v sudo >/dev/null && [[ -t 0 && -t 2 && -z ${CI-} ]]; then
    right=(sudo env)
  else
    return 1
  fi
}

apt() {
  "${right[@]}" DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=120 \
    -o Dpkg::Use-Pty=0 "$@" </dev/null 9>&-
}

# Install the packages named, and show apt's own words only when it fails. Nothing is
# removed for them: pulseaudio would take the place of a desktop's own sound server.
apt_install() {
  local log
  say "installing the system packages $*"
  log=$(mktemp)
  apt update >"$log" 2>&1 || say "apt-get update failed; trying with the lists that are here"
  if apt install --no-install-recommends --no-remove "$@" >>"$log" 2>&1; then
    rm -f -- "$log"
  else
    tail -n 20 -- "$log" >&2
    rm -f -- "$log"
    return 1
  fi
}

system_packages() {
  local base required optional
  if ! find_python; then
    base=$(awk '$3 == "base" { printf "%s ", $1 }' "$packages")
    # shellcheck disable=SC2086 # a list of names
    if find_right; then apt_install $base || true; fi
    find_python || die "Python 3.11 or newer is missing; as root:" \
      "apt-get install --no-install-recommends ${base% }"
  fi
  required=$(missing required)
  optional=$(missing optional)
  [[ -n $required$optional ]] || return 0

  # One package that cannot be had must not keep the others away.
  # shellcheck disable=SC2086 # lists of names
  if find_right && ! apt_install $required $optional && [[ -n $required && -n $optional ]]; then
    apt_install $required || true
  fi
  required=$(missing required)
  optional=$(missing optional)
  if [[ -n $required ]]; then
    die "required system packages are missing; as root:" \
      "apt-get install --no-install-recommends $required${optional:+ $optional}"
  elif [[ -n $optional ]]; then
    say "going on without what these system packages bring (see ./run doctor):" \
      "apt-get install --no-install-recommends $optional"
  fi
}

# What only tests compare with; those are skipped without it.
packages_for_checks() {
  local names name
  names=$(missing checks)
  [[ -n $names ]] || return 0
  # shellcheck disable=SC2086 # a list of names
  if find_right && ! apt_install $names; then
    for name in $names; do apt_install "$name" || true; done
  fi
  names=$(missing checks)
  if [[ -n $names ]]; then
    say "tests will be skipped for want of these system packages:" \
      "apt-get install --no-install-recommends $names"
  fi
}

# An environment from a place where the tree was before, or with an interpreter that has
# gone, cannot be mended; one that a killed run left behind is not worth trusting.
is_sound() {
  [[ -x $venv/bin/python3 && ! -e $venv/unfinished ]] &&
    head -n 3 "$venv/bin/pip" 2>/dev/null | grep -qF "$venv/bin/python" &&
    "$venv/bin/python3" -m pip --version >/dev/null 2>&1
}

pip_install() {
  "$venv/bin/python3" -m pip install --quiet --no-input --no-deps \
    --disable-pip-version-check --no-warn-script-location "$@" </dev/null >&2
}

environment() {
  if [[ ! -w $root || (-e $venv && ! -w $venv) ]]; then
    die "no right to write in $venv, which must be set up anew"
  fi
  if is_sound; then
    : >"$venv/unfinished"
    rm -f -- "$venv"/stamp-*
  else
    say "making the Python environment in $venv"
    rm -rf -- "$venv"
    mkdir -- "$venv"
    : >"$venv/unfinished"
    "$python" -m venv "$venv" >&2 || die "could not make $venv"
  fi
  say "installing the Python packages of $(basename -- "$(lock_of "$kind")")"
  pip_install --require-hashes --only-binary :all: --requirement "$(lock_of "$kind")" ||
    die "the Python packages could not be installed; is the package index of pip within reach?"
  pip_install --no-build-isolation --editable "$root" ||
    die "the program itself could not be installed"
}

# What ./test needs holds all that ./run needs.
stamp() {
  fingerprint run >"$venv/stamp-run"
  if [[ $kind == dev ]]; then
    fingerprint dev >"$venv/stamp-dev"
  fi
  rm -f -- "$venv/unfinished"
}

if is_current "$kind"; then
  exit 0
fi
# The descriptor is left open for pip: should this script be killed, the next one waits
# until the orphan has stopped writing.
exec 9<"$packages"
if ! flock --nonblock 9; then
  say "waiting for another set-up to end"
  flock 9
fi
if is_current "$kind"; then
  exit 0
fi
system_packages
if [[ $kind == dev ]]; then
  packages_for_checks
fi
environment
stamp
