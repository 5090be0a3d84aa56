#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Headers and C library (with cmocka, for the tests) of Debian 11, to compile against: what is linked with its glibc 2.31 runs
# on that and anything newer. Usage: old_debian.sh amd64|arm64 FOLDER
# apt itself fetches and checks the packages, with lists of its own in FOLDER: nothing of this system is changed.
set -eu
architecture=$1
folder=$2
packages="libc6 libc6-dev linux-libc-dev libcrypt-dev libcmocka-dev libcmocka0"
[ ! -e "$folder/whole" ] || exit 0
rm -rf "$folder"
mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial" "$folder/packages"
folder=$(cd "$folder" && pwd)
: >"$folder/apt/status"
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] ${HEXCON_MIRROR:-http://deb.debian.org/debian} bullseye main" \
  >"$folder/apt/sources.list"
ask_apt() {
  apt-get -q -o Dir::Etc::sourcelist="$folder/apt/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State="$folder/apt" \
    -o Dir::State::lists="$folder/apt/lists" -o Dir::State::status="$folder/apt/status" -o Dir::Cache="$folder/apt/cache" \
    -o APT::Architecture="$architecture" -o APT::Architectures="$architecture" -o Acquire::Check-Valid-Until=false \
    -o Acquire::Languages=none -o APT::Sandbox::User="$(id -un)" "$@"
}
ask_apt update
# shellcheck disable=SC2086  # words, one a package
(cd "$folder/packages" && ask_apt download $packages)
for package in "$folder"/packages/*.deb; do
  dpkg-deb -x "$package" "$folder"
done
rm -rf "$folder/apt" "$folder/packages"
# links to /lib/... would lead out of the folder
find "$folder" -type l -lname '/*' | while read -r link; do
  ln -srf "$folder$(readlink "$link")" "$link"
done
touch "$folder/whole"
