#!/usr/bin/env bash
# Make hapticplayer_VERSION_amd64.deb: `packaging/deb/build.sh [FOLDER]`, by default dist.
# One package for Debian 12 (Python 3.11) and 13 (Python 3.13): the application and its
# locked Python packages under /usr/lib/hapticplayer, which is an environment of Python.
# Needs ./run to have set up .venv. SOURCE_DATE_EPOCH is the time of all files in it.
set -euo pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
root=$(dirname -- "$(dirname -- "$here")")
out=${1:-$root/dist}
pythons=(3.11 3.13)
python=$root/.venv/bin/python3
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$root" log -1 --format=%ct)}
umask 022

work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
version=$(cd -- "$root" && "$python" -c 'import hapticplayer as h; print(h.__version__)')
maintainer="${DEBFULLNAME:-The hapticplayer authors} <${DEBEMAIL:-authors@hapticplayer.org}>"
tree=$work/tree
own=$tree/usr/lib/hapticplayer
doc=$tree/usr/share/doc/hapticplayer

say() { printf 'deb: %s\n' "$*" >&2; }

# A wheel for one Python goes to its site-packages, any other to what both look into.
unpack() {
  local wheel=$1 place=$own/lib/common tag
  case $(basename -- "$wheel") in
    *-abi3-* | *-none-*) ;;
    *-cp3*-cp3*) tag=${wheel##*-cp3}
      place=$own/lib/python3.${tag%%-*}/site-packages ;;
    *) say "no place for $wheel"; exit 1 ;;
  esac
  mkdir -p -- "$place"
  "$python" -m zipfile -e "$wheel" "$place"
}

application() {
  local wheel version
  mkdir -p -- "$own/bin" "$own/lib" "$tree/usr/bin"
  say "fetching the locked packages"
  "$root/packaging/wheels.sh" "$work/wheels" "${pythons[@]}"
  (cd -- "$root" && "$python" -m hatchling build --target wheel --directory "$work/wheels" >&2)
  for wheel in "$work"/wheels/*.whl; do unpack "$wheel"; done
  for version in "${pythons[@]}"; do
    # The administrator's own packages come last, and are none of this package.
    printf '/usr/lib/hapticplayer/lib/common\n/usr/local/lib/hapticplayer/python%s\n' \
      "$version" >"$own/lib/python$version/site-packages/hapticplayer.pth"
  done
  # Scripts and manual pages of libraries, their tests, and what only developers of Qt use.
  rm -rf -- "$own"/lib/*/*.data "$own"/lib/*/site-packages/*.data \
    "$own"/lib/common/PySide6/{Qt/{qml,metatypes,libexec},include,typesystems,glue,doc} \
    "$own"/lib/python*/site-packages/matplotlib/tests
  find "$own"/lib/python*/site-packages/scipy -name tests -prune -exec rm -rf -- {} +
  find "$own" -name '*.pyi' -delete
  find "$own" -name __pycache__ -prune -exec rm -rf -- {} +
  find "$own/lib" -type f -exec chmod 644 -- {} +
  printf 'home = /usr/bin\ninclude-system-site-packages = false\n' >"$own/pyvenv.cfg"
  ln -s /usr/bin/python3 "$own/bin/python3"
  printf '#!/bin/sh\nexec /usr/lib/hapticplayer/bin/python3 -P -m app "$@"\n' \
    >"$tree/usr/bin/hapticplayer"
  chmod 755 "$tree/usr/bin/hapticplayer"
}

integration() {
  local rules=$tree/usr/lib/udev/rules.d
  (cd -- "$root" && "$python" -m app desktop install --prefix "$tree/usr")
  "$python" "$here/releases.py" "$root/CHANGELOG.md" \
    "$tree"/usr/share/metainfo/*.metainfo.xml
  gzip -9n "$tree/usr/share/man/man1/hapticplayer.1"
  install -D -m 644 -t "$rules" "$root"/packaging/udev/*.rules
  install -D -m 644 "$here/limits.conf" "$tree/etc/security/limits.d/hapticplayer.conf"
  install -D -m 644 "$here/lintian-overrides" "$tree/usr/share/lintian/overrides/hapticplayer"
}

documents() {
  local day
  day=$(date -u -R -d "@$SOURCE_DATE_EPOCH")
  mkdir -p -- "$doc"
  printf 'hapticplayer (%s) unstable; urgency=medium\n\n  * %s\n\n -- %s  %s\n' \
    "$version" "See NEWS.md.gz for what users notice." "$maintainer" "$day" |
    gzip -9n >"$doc/changelog.gz"
  gzip -9nc "$root/CHANGELOG.md" >"$doc/NEWS.md.gz"
  "$python" "$here/copyright.py" "$root/LICENSE" "$own/lib" >"$doc/copyright"
}

# "lib:" of the list of system packages are what the program loads; others improve it.
names_of() {
  awk -v kind="$1" '/^[a-z]/ && $3 ~ /^(qt|window|wayland|sound|device)$/ {
    is_lib = $2 ~ /^lib:/
    if ((kind == "lib") == is_lib) printf ", %s", $1
  }' "$root/packaging/apt-packages.txt"
}

control() {
  mkdir -p -- "$tree/DEBIAN"
  cat >"$tree/DEBIAN/control" <<CONTROL
Package: hapticplayer
Version: $version
Architecture: amd64
Maintainer: $maintainer
Installed-Size: $(du -sk --apparent-size -- "$tree" | cut -f1)
Depends: python3 (>= 3.11), python3 (<< 3.14), python3 (<< 3.12) | python3 (>= 3.13), passwd, libc6 (>= 2.36), libstdc++6, zlib1g$(names_of lib)
Recommends: $(names_of other | cut -c3-)
Suggests: python3-pip
Section: video
Priority: optional
Description: play a video and feel the motion of whoever recorded it
 An action camera or a body-worn sensor records a ride together with its video.
 hapticplayer removes gravity from the recording, turns what is left into a
 force, and plays video, sound and force together through a haptic device.
 .
 A simulated device is built in. Members of the group hapticplayer get the
 real-time priority that makes the 1 kHz loop punctual.
CONTROL
  printf '/etc/security/limits.d/hapticplayer.conf\n' >"$tree/DEBIAN/conffiles"
  for script in postinst prerm postrm; do
    install -m 755 "$here/$script" "$tree/DEBIAN/$script"
  done
  (cd -- "$tree" && find usr -type f -print0 | sort -z | xargs -0 md5sum) >"$tree/DEBIAN/md5sums"
}

application
integration
documents
control
find "$tree" -newermt "@$SOURCE_DATE_EPOCH" -print0 |
  xargs -0 touch --no-dereference --date="@$SOURCE_DATE_EPOCH"
mkdir -p -- "$out"
say "packing $(du -sm -- "$tree" | cut -f1) MB"
dpkg-deb --root-owner-group -Zxz -z1 --build "$tree" "$out/hapticplayer_${version}_amd64.deb" >&2
say "made $out/hapticplayer_${version}_amd64.deb"
