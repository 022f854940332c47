#!/usr/bin/env bash
# Fetch the locked wheels that the program runs with: `packaging/wheels.sh FOLDER [PYTHON...]`
# for Linux on x86-64 with glibc 2.36 (Debian 12) or newer, by hash; by default for
# Python 3.11 and 3.13. What only builds the program is left out.
set -euo pipefail
folder=${1:?a folder}
shift
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
build_only='hatchling|editables|pathspec|pluggy|tomlkit|trove-classifiers'

lock=$(mktemp)
trap 'rm -f -- "$lock"' EXIT
awk -v drop="^($build_only)==" '/^[^ ]/ { skip = $0 ~ drop } !skip' \
  "$root/packaging/requirements.lock" >"$lock"

platforms=(--platform linux_x86_64 --platform manylinux2014_x86_64)
for minor in $(seq 5 36); do platforms+=(--platform "manylinux_2_${minor}_x86_64"); done
for version in "${@:-3.11 3.13}"; do
  for python in $version; do
    "$root/.venv/bin/python3" -m pip download --quiet --disable-pip-version-check \
      --no-deps --only-binary :all: --require-hashes --dest "$folder" \
      --python-version "$python" "${platforms[@]}" --requirement "$lock"
  done
done
