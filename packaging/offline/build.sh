#!/usr/bin/env bash
# Make hapticplayer-VERSION-offline.zip for a computer without a network:
# `packaging/offline/build.sh [FOLDER]`, by default dist. It holds the program's wheel, the
# lock and its wheels for Python 3.11 to 3.13, and install.sh, which needs Python and nothing
# else. Needs ./run to have set up .venv. SOURCE_DATE_EPOCH is the time of all files in it.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
root=$(dirname -- "$(dirname -- "$here")")
out=$(realpath -m -- "${1:-$root/dist}")
python=$root/.venv/bin/python3
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct)}
export TZ=UTC
umask 022

work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
version=$(cd -- "$root" && "$python" -c 'import hapticplayer as h; print(h.__version__)')
name=hapticplayer-$version-offline
top=$work/$name
mkdir -p -- "$top/wheels" "$out"
"$root/packaging/wheels.sh" "$top/wheels" 3.11 3.12 3.13
(cd -- "$root" && "$python" -m hatchling build --target wheel --directory "$top/wheels" >&2)
cp -- "$root/packaging/requirements.lock" "$root/packaging/apt-packages.txt" "$root/LICENSE" \
  "$here/install.sh" "$here/install.py" "$top/"
(cd -- "$top" && sha256sum -- wheels/*.whl >SHA256SUMS)
find "$top" -exec touch --date="@$SOURCE_DATE_EPOCH" {} +
rm -f -- "$out/$name.zip"
(cd -- "$work" && "$python" -m zipfile -c "$out/$name.zip" "$name")
printf 'offline: made %s\n' "$out/$name.zip" >&2
