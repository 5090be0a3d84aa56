#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# The tests in FreeCAD of today: Debian forky in a folder of its own (chroot), made once and kept.
# Usage: test_current.sh [FOLDER]   (where that Debian is; made there if it is not: 2.5 GB, some ten minutes)
# HEXCON_CURRENT_TESTS: other tests than those chosen below.
# Needs root (or sudo), debootstrap, and the right to mount. Where one of them is missing it says so, and its status is 3; that
# of tests that fail is 1, of tests that take more than HEXCON_CURRENT_LIMIT (1500) seconds too.
set -eu
cd "$(dirname "$0")/.."
folder=${1:-${XDG_CACHE_HOME:-$HOME/.cache}/hexcon/forky}
mirror=${HEXCON_MIRROR:-http://deb.debian.org/debian}
packages="freecad freecad-python3 calculix-ccx python3-gmsh gcc libc6-dev make cmake ninja-build python3-dev python3-numpy
  python3-scipy python3-vtk9 python3-meshio python3-pytest python3-pytest-xdist python3-h5py xvfb xauth libcmocka-dev git imagemagick
  libgl1-mesa-dri libxtst6 pkg-config tetgen ca-certificates"
# What differs between systems: files, programs that are called, what libraries draw. The rest is of numpy and our own C.
chosen="tests/freecad tests/gui tests/python/test_files.py tests/python/test_solver_files.py tests/python/test_reading.py
  tests/python/test_files_of_gmsh.py tests/python/test_cgns_exodus.py tests/python/test_groups.py
  tests/python/test_cli.py tests/python/test_environment.py tests/python/test_fake_programs.py
  tests/python/test_core_api.py tests/python/test_pictures.py tests/python/test_examples_run.py
  tests/python/test_meshing.py tests/python/test_quads_process.py tests/python/test_signals.py"

fail() {
  echo "test-current: NOT TESTED in FreeCAD of today: $1" >&2
  exit 3
}

root=
[ "$(id -u)" = 0 ] || root=sudo
[ -z "$root" ] || command -v sudo >/dev/null || fail "a chroot needs root, and there is no sudo"
inside() {
  $root chroot "$folder" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive HEXCON_CURRENT_LIMIT="${HEXCON_CURRENT_LIMIT:-1500}" "$@"
}

mounted=
let_go() {
  for place in $mounted; do $root umount -l "$folder/$place"; done
}

# PLACE, then mount's arguments but for the folder; what is mounted already stays as it is.
mount_at() {
  place=$1
  shift
  ! mountpoint -q "$folder/$place" || return 0
  $root mkdir -p "$folder/$place"
  $root mount "$@" "$folder/$place" || fail "nothing may be mounted at $folder/$place"
  mounted="$place $mounted"
}

make_debian() {
  command -v debootstrap >/dev/null ||
    { $root apt-get update -q && $root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q debootstrap; } ||
    fail "debootstrap cannot be installed"
  # an older debootstrap does not know forky; all suites since sid are made alike
  [ -e /usr/share/debootstrap/scripts/forky ] || $root ln -s sid /usr/share/debootstrap/scripts/forky
  [ ! -e "$folder" ] || fail "$folder is there and holds no Debian that this script has made: name another folder"
  $root rm -rf "$folder.making" # of a run that was broken off
  $root mkdir -p "$folder.making"
  $root debootstrap --variant=minbase forky "$folder.making" "$mirror" ||
    fail "debootstrap could not make Debian forky from $mirror"
  echo 'Acquire::Check-Valid-Until "false";' | $root tee "$folder.making/etc/apt/apt.conf.d/99hexcon" >/dev/null
  $root touch "$folder.making/etc/hexcon-base"
  $root mv "$folder.making" "$folder"
}

install_packages() {
  inside apt-get update -q || fail "Debian forky's packages cannot be listed"
  # shellcheck disable=SC2086  # words, one a package
  inside apt-get install -y -q --no-install-recommends $packages || fail "Debian forky's packages cannot be installed"
  echo "$packages" | $root tee "$folder/etc/hexcon-packages" >/dev/null
}

copy_sources() {
  $root mkdir -p "$folder/hexcon"
  $root find "$folder/hexcon" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
  git ls-files --cached --others --exclude-standard | while read -r name; do [ ! -e "$name" ] || echo "$name"; done |
    tar -cf - -T - | $root tar -xf - -C "$folder/hexcon" --no-same-owner
}

[ -e "$folder/etc/hexcon-base" ] || make_debian
trap let_go EXIT
trap 'exit 1' INT TERM
mount_at proc -t proc proc
mount_at dev --bind /dev
mount_at dev/shm -t tmpfs tmpfs
[ "$(cat "$folder/etc/hexcon-packages" 2>/dev/null)" = "$packages" ] || install_packages
copy_sources
# shellcheck disable=SC2086  # words, one a file
inside /hexcon/scripts/test_here.sh ${HEXCON_CURRENT_TESTS:-$chosen} || { echo "test-current: FAILED in $(cat "$folder/hexcon/build/versions" 2>/dev/null)" >&2; exit 1; }
