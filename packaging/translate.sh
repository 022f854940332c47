#!/usr/bin/env bash
# Bring resources/i18n up to date with the texts of the program: `packaging/translate.sh`.
# Reads app/, and the sentences of hapticplayer/ that the window shows; adds new texts to
# the .ts files (to be translated there), drops old ones, and makes the .qm files that the
# program loads.
set -euo pipefail
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
cd -- "$root"
aside=$(mktemp -d)
trap 'rm -rf -- "$aside"' EXIT
.venv/bin/python packaging/engine_sentences.py "$aside/engine.py"
mapfile -t files < <(find app -name '*.py' | LC_ALL=C sort)
for code in de fr; do
  ts=resources/i18n/$code.ts
  .venv/bin/pyside6-lupdate -no-obsolete -locations none -source-language en \
    -target-language "$code" "${files[@]}" "$aside/engine.py" -ts "$ts"
  .venv/bin/pyside6-lrelease -silent "$ts" -qm "resources/i18n/$code.qm"
done
