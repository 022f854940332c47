#!/usr/bin/env bash
# Put the desktop entry, icon, MIME type and metadata where a desktop finds them:
# `install.sh [PREFIX]`, by default the user's own ~/.local. Nothing else is changed.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
root=$(dirname -- "$(dirname -- "$here")")
share=${1:-$HOME/.local}/share

put() { install -D -m 644 -- "$1" "$share/$2"; }

for entry in hapticplayer hapticplayer-open; do
  put "$here/$entry.desktop" "applications/$entry.desktop"
done
put "$here/org.hapticplayer.hapticplayer.metainfo.xml" \
  metainfo/org.hapticplayer.hapticplayer.metainfo.xml
put "$here/hapticplayer-mime.xml" mime/packages/hapticplayer.xml
put "$root/resources/icons/hapticplayer.svg" icons/hicolor/scalable/apps/hapticplayer.svg

# What a desktop keeps of these files; where the programs are missing it looks itself.
for command in "update-mime-database $share/mime" \
  "update-desktop-database $share/applications"; do
  # shellcheck disable=SC2086 # two words on purpose
  if command -v ${command%% *} >/dev/null; then ${command}; fi
done
