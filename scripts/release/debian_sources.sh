#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# The sources of a package of Debian 12, unpacked. Usage: debian_sources.sh PACKAGE FOLDER
# apt fetches and checks them, with lists of its own: nothing of this system is changed.
set -eu
package=$1
folder=$2
rm -rf "$folder" "$folder.apt"
mkdir -p "$folder" "$folder.apt/lists/partial" "$folder.apt/cache/archives/partial"
there=$(cd "$folder.apt" && pwd)
: >"$there/status"
echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] ${HEXCON_MIRROR:-http://deb.debian.org/debian} bookworm main" \
  >"$there/sources.list"
ask_apt() {
  apt-get -q -o Dir::Etc::sourcelist="$there/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State="$there" \
    -o Dir::State::lists="$there/lists" -o Dir::State::status="$there/status" -o Dir::Cache="$there/cache" \
    -o Acquire::Check-Valid-Until=false -o Acquire::Languages=none -o APT::Sandbox::User="$(id -un)" "$@"
}
ask_apt update
(cd "$there" && ask_apt source --download-only "$package")
tar -xf "$(find "$there" -name "${package}_*.orig.tar.*" ! -name "*.asc")" -C "$folder" --strip-components=1
rm -rf "$there"
