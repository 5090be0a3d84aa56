# SPDX-License-Identifier: LGPL-2.1-or-later
# shellcheck shell=sh
# To be sourced: apt with lists of its own, which fetches and checks packages of another Debian; nothing of this system is changed.
# own_apt FOLDER deb|deb-src SUITE, then ask_apt ARGUMENTS as of apt-get.

own_apt() {
  mkdir -p "$1/lists/partial" "$1/cache/archives/partial"
  apt_folder=$(cd "$1" && pwd)
  : >"$apt_folder/status"
  echo "$2 [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] ${HEXCON_MIRROR:-http://deb.debian.org/debian} $3 main" \
    >"$apt_folder/sources.list"
}

ask_apt() {
  apt-get -q -o Dir::Etc::sourcelist="$apt_folder/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State="$apt_folder" \
    -o Dir::State::lists="$apt_folder/lists" -o Dir::State::status="$apt_folder/status" -o Dir::Cache="$apt_folder/cache" \
    -o Acquire::Check-Valid-Until=false -o Acquire::Languages=none -o APT::Sandbox::User="$(id -un)" "$@"
}
