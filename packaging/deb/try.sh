#!/usr/bin/env bash
# Try the package in a bare system: `packaging/deb/try.sh ROOT FILE.deb`, as root.
# ROOT is the folder of a Debian that mmdebstrap has made (--variant=minbase), on which
# nothing was installed yet; what the trial needs is put there first. Steps: install, doctor, the
# demo without a screen, man page, a packed ride by its MIME type on a virtual screen,
# removal without a trace, lintian. Ends with 1 at the first step that fails.
set -euo pipefail
root=$(readlink -f -- "$1")
deb=$(readlink -f -- "$2")

step() { printf -- '-- %s: %s\n' "$(basename -- "$root")" "$*"; }
inside() {
  chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@"
}
apt() { inside apt-get -qq -o Dpkg::Use-Pty=0 "$@" >/dev/null; }
clean() {
  for place in dev/shm dev sys proc; do
    if mountpoint -q "$root/$place"; then umount -l "$root/$place"; fi
  done
}
trap clean EXIT
for place in proc sys dev; do
  mountpoint -q "$root/$place" || mount --rbind --make-rslave "/$place" "$root/$place"
done
cp -- /etc/resolv.conf "$root/etc/resolv.conf"
install -D -m 644 -- "$deb" "$root/srv/hapticplayer.deb"

# Every file that a package could leave; caches that apt, ldconfig and others keep, and the
# backups of groupadd, are theirs.
files() {
  inside find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /srv -o -path /tmp \
    -o -path /root -o -path /run -o -path /var/cache -o -path /var/log -o -path /var/lib/apt \
    -o -path /var/lib/dpkg -o -path /usr/share/mime -o -path /var/lib/systemd \
    -o -path /etc/group- -o -path /etc/gshadow- \) -prune -o -print | sort
}

step "what the trial needs"
apt update
apt install --no-install-recommends lintian xvfb x11-utils xdg-utils shared-mime-info \
  desktop-file-utils libfile-mimeinfo-perl man-db xauth
files >"$root/srv/before"

step "install"
apt install --no-install-recommends /srv/hapticplayer.deb
inside hapticplayer --version

step "doctor"
inside hapticplayer doctor

step "the demo without a screen"
# A machine that stalls while it plays trips the force, which makes the status 1.
inside hapticplayer || inside hapticplayer || inside hapticplayer

step "man page"
inside man --pager=cat hapticplayer | grep -m1 'hapticplayer play'

step "a packed ride by its MIME type"
demo=/usr/lib/hapticplayer/lib/common/resources/demo.mkv
inside cp "$demo" /srv/ride
inside cp "$demo" /srv/ride.mkv
for file in /srv/ride /srv/ride.mkv; do
  kind=$(inside xdg-mime query filetype "$file")
  entry=$(inside xdg-mime query default "$kind")
  printf '%s is %s, opened by %s\n' "$file" "$kind" "$entry"
  [[ $entry == hapticplayer.desktop ]] || exit 1
done
inside xvfb-run -a bash -c '
  setsid xdg-open /srv/ride & opener=$!
  for _ in $(seq 60); do
    sleep 1
    if xwininfo -root -tree | grep -q "bicycle"; then found=yes; break; fi
  done
  xwininfo -root -tree | grep -i "hapticplayer" | head -n 3
  kill -TERM -- "-$opener" || true
  [ "$found" = yes ]'

step "removal"
apt purge hapticplayer
apt autoremove --purge
files >"$root/srv/after"
if ! diff "$root/srv/before" "$root/srv/after"; then
  step "the package left or took files"
  exit 1
fi
if inside getent group hapticplayer || grep -rl hapticplayer "$root/usr/share/mime"; then
  step "the package left a trace"
  exit 1
fi
step "lintian"
inside lintian --allow-root --fail-on error /srv/hapticplayer.deb >"$root/srv/lintian" || {
  grep '^E:' "$root/srv/lintian"
  exit 1
}
printf '%s warnings\n' "$(grep -c '^W:' "$root/srv/lintian")"
step "all steps passed"
