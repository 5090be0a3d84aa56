#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Install what is missing, and only that. Usage: setup.sh run|test|lint|fuzz|release
# FREECADCMD set: that FreeCAD is used and Debian's is not installed.
set -eu
build="gcc libc6-dev make cmake ninja-build python3-dev python3-numpy"
run="$build python3-scipy gmsh python3-gmsh calculix-ccx python3-vtk9 python3-meshio xvfb xauth"
[ -n "${FREECADCMD:-}" ] || run="$run freecad"
fuzz="$build clang libclang-rt-dev"
case "$1" in
  run) packages=$run ;;
  fuzz) packages=$fuzz ;;
  test) packages="$run $fuzz libcmocka-dev python3-pytest python3-pytest-xdist python3-h5py tetgen imagemagick libxtst6 pkg-config" ;;
  lint) packages="$build python3-mypy libcmocka-dev clang-format clang-tidy cppcheck shellcheck"
        # Debian has no ruff; npm has it, as WebAssembly.
        command -v npm >/dev/null || packages="$packages nodejs npm" ;;
  release) packages="$build gcc-mingw-w64-x86-64-win32 gcc-aarch64-linux-gnu libcmocka-dev qemu-user wine wine64" ;;
  *) echo "setup: run, test, lint, fuzz or release, not $1" >&2; exit 2 ;;
esac
if ! command -v dpkg-query >/dev/null; then
  echo "setup: no Debian packages here; these must be present: $packages"
  exit 0
fi
missing=
for package in $packages; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0
echo "setup: installing$missing"
root=
[ "$(id -u)" = 0 ] || root="sudo"
export DEBIAN_FRONTEND=noninteractive
$root apt-get update -q
# shellcheck disable=SC2086  # words, one a package
$root apt-get install -y -q --no-install-recommends $missing
