#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Headers and C library (with cmocka, for the tests) of Debian 11, to compile against: what is linked with its glibc 2.31 runs
# on that and anything newer. Usage: old_debian.sh amd64|arm64 FOLDER
set -eu
architecture=$1
folder=$2
# shellcheck source=scripts/release/own_apt.sh
. "$(dirname "$0")/own_apt.sh"
packages="libc6 libc6-dev linux-libc-dev libcrypt-dev libcmocka-dev libcmocka0"
[ ! -e "$folder/whole" ] || exit 0
rm -rf "$folder"
mkdir -p "$folder/packages"
folder=$(cd "$folder" && pwd)
own_apt "$folder/apt" deb bullseye
ask_apt_of() {
  ask_apt -o APT::Architecture="$architecture" -o APT::Architectures="$architecture" "$@"
}
ask_apt_of update
# shellcheck disable=SC2086  # words, one a package
(cd "$folder/packages" && ask_apt_of download $packages)
for package in "$folder"/packages/*.deb; do
  dpkg-deb -x "$package" "$folder"
done
rm -rf "$folder/apt" "$folder/packages"
# links to /lib/... would lead out of the folder
find "$folder" -type l -lname '/*' | while read -r link; do
  ln -srf "$folder$(readlink "$link")" "$link"
done
touch "$folder/whole"
