#!/bin/sh
# Install hapticplayer for this user without a network: `sh install.sh [FOLDER]`, by default
# ~/.local/lib/hapticplayer; `sh install.sh --remove [FOLDER]` takes it away again.
set -eu
here=$(cd -- "$(dirname -- "$0")" && pwd)
for python in python3 python3.13 python3.12 python3.11; do
  if command -v "$python" >/dev/null &&
    "$python" -c 'import sys; sys.exit(not (3, 11) <= sys.version_info < (3, 14))'; then
    exec "$python" -I "$here/install.py" "$@"
  fi
done
echo "install.sh: Python 3.11, 3.12 or 3.13 is missing; install it first" >&2
exit 1
