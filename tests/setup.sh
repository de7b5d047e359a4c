#!/bin/sh
# Installs what is missing on Debian and Ubuntu; elsewhere it names it.
#
#   sh tests/setup.sh PROGRAM=PACKAGE ... /FILE/OR/PATTERN=PACKAGE ...
set -eu

missing=
# shellcheck disable=SC2086  # $wanted may be a pattern, to be expanded
for pair in "$@"; do
    wanted=${pair%%=*}
    case $wanted in
    /*) ls -d $wanted >/dev/null 2>&1 || missing="$missing ${pair#*=}" ;;
    *) command -v "$wanted" >/dev/null 2>&1 || missing="$missing ${pair#*=}" ;;
    esac
done
[ -n "$missing" ] || exit 0

if ! command -v apt-get >/dev/null 2>&1; then
    echo "please install (names of Debian's packages):$missing" >&2
    exit 1
fi
if [ "$(id -u)" -eq 0 ]; then
    as_root=
elif command -v sudo >/dev/null 2>&1; then
    as_root=sudo
else
    echo "neither root nor sudo; as root: apt-get install --no-install-recommends$missing" >&2
    exit 1
fi

echo "installing:$missing"
$as_root apt-get -o DPkg::Lock::Timeout=300 -qq update
# shellcheck disable=SC2086  # a list of packages
$as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -o DPkg::Lock::Timeout=300 -qq -y --no-install-recommends install $missing >/dev/null
