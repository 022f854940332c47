#!/usr/bin/env bash
# Bring resources/i18n up to date with the texts of the program: `packaging/translate.sh`.
# Reads app/, adds new texts to the .ts files (to be translated there), drops old ones, and
# makes the .qm files that the program loads.
set -euo pipefail
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
cd -- "$root"
mapfile -t files < <(find app -name '*.py' | LC_ALL=C sort)
for code in de fr; do
  ts=resources/i18n/$code.ts
  .venv/bin/pyside6-lupdate -no-obsolete -locations none -source-language en \
    -target-language "$code" "${files[@]}" -ts "$ts"
  .venv/bin/pyside6-lrelease -silent "$ts" -qm "resources/i18n/$code.qm"
done
