#!/usr/bin/env bash
# Make a release: `packaging/release.sh [--untested]`, from a clean tree whose commit holds
# the version (hapticplayer/__init__.py) and its section, with a date, as the newest one of
# CHANGELOG.md. Runs every check, builds everything into dist/VERSION and writes SHA256SUMS
# there; the tag is a person's to set. --untested leaves ./test out, to try the rest.
set -euo pipefail
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
cd -- "$root"
python=$root/.venv/bin/python3

die() { printf 'release: %s\n' "$*" >&2; exit 1; }
step() { printf -- '-- %s\n' "$*"; }

step 'tree and versions'
[[ -z $(git status --porcelain) ]] || die 'the tree has changes; commit them first'
packaging/setup.sh dev
version=$("$python" -c 'import hapticplayer; print(hapticplayer.__version__)')
newest=$(sed -n 's/^## //p' CHANGELOG.md | head -n 1)
[[ $newest =~ ^\[?"$version"\]?[^0-9].*20[0-9]{2}-[0-9]{2}-[0-9]{2} ]] ||
  die "the newest section of CHANGELOG.md is '$newest', not $version with a date"
if git rev-parse -q --verify "refs/tags/v$version" >/dev/null; then
  [[ $(git rev-list -n 1 "v$version") == $(git rev-parse HEAD) ]] ||
    die "the tag v$version is another commit; raise the version"
fi
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

if [[ ${1-} == --untested ]]; then
  step 'checks are left out'
else
  step 'checks'
  ./test || die 'a check failed'
  [[ -z $(git status --porcelain) ]] || die 'the checks changed the tree'
fi

out=dist/$version
rm -rf -- "$out"
mkdir -p -- "$out"
step 'wheel and sdist, twice'
again=$(mktemp -d)
trap 'rm -rf -- "$again"' EXIT
for place in "$out" "$again"; do "$python" -m hatchling build --directory "$place"; done
for file in "$out"/*; do
  cmp -- "$file" "$again/$(basename -- "$file")" || die 'the builds differ'
done
step 'Debian package'
packaging/deb/build.sh "$out"
step 'offline archive'
packaging/offline/build.sh "$out"
(cd -- "$out" && sha256sum -- *.whl *.tar.gz *.deb *.zip >SHA256SUMS)
step "made $out"
cat -- "$out/SHA256SUMS"
