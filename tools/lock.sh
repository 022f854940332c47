#!/usr/bin/env bash
# Write both requirement locks from pyproject.toml; needs uv on the PATH.
# Versions that are locked stay; `tools/lock.sh --upgrade` takes the newest ones.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."

pins=$(mktemp)
trap 'rm -f -- "$pins"' EXIT

# hatchling builds the project, editables lets it do so in place.
# --no-header: the header would repeat the command line, with any index that it names.
compile() {
  printf '%s\n' hatchling editables |
    uv pip compile pyproject.toml - --quiet --universal --python-version 3.11 \
      --generate-hashes --no-header --no-annotate --no-config "$@"
}

compile --extra dev --extra vision --extra study --output-file packaging/requirements-dev.lock "$@"
# The runtime lock follows the other one, so that ./run and ./test agree on every version.
sed -n '/^[^ ]/s/ \\$//p' packaging/requirements-dev.lock >"$pins"
compile --extra study --constraint "$pins" --output-file packaging/requirements.lock "$@"
