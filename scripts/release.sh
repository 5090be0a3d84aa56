#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# HexCon-x.y.z.zip: a Mod folder that runs without a compiler, with the core for the systems of release/*-*.cmake.
# Native tests of each core run, where they can: here, in qemu-user, in Wine; what did not run stands in the release's notes.
# Usage: release.sh [FOLDER]   (where the zip and what it was made of are put)
set -eu
cd "$(dirname "$0")/.."
output=${1:-build/zip}
mkdir -p "$output"
output=$(cd "$output" && pwd)
python=$(scripts/find-python.sh)
systems="linux-x86_64 linux-aarch64 windows-x86_64"

# Python's headers, with a pyconfig.h that holds for each of the systems.
take_python_headers() {
  from=$("$python" -c 'import sysconfig; print(sysconfig.get_path("include"))')
  rm -rf "$output/python"
  mkdir -p "$output/python"
  cp -r "$from"/*.h "$from/cpython" "$output/python"
  cp scripts/release/pyconfig.h "$output/python"
}

# Below FOLDER/sysroot-windows: cmocka, from the sources of Debian's package, and what links with python3.dll.
make_windows_libraries() {
  there=$output/sysroot-windows
  mkdir -p "$there/lib" "$there/include"
  x86_64-w64-mingw32-dlltool -d scripts/release/python3.def -l "$there/lib/libpython3.a"
  [ ! -e "$there/lib/libcmocka.a" ] || return 0
  scripts/release/debian_sources.sh cmocka "$output/cmocka"
  HEXCON_SYSROOT=$there cmake -S "$output/cmocka" -B "$output/cmocka/build" -G Ninja -DWITH_STATIC_LIB=ON -DWITH_EXAMPLES=OFF \
    -DCMAKE_TOOLCHAIN_FILE="$PWD/scripts/release/windows-x86_64.cmake" >/dev/null
  ninja -C "$output/cmocka/build" --quiet cmocka-static
  cp "$output/cmocka/include/cmocka.h" "$there/include"
  cp "$output/cmocka/build/src/libcmocka-static.a" "$there/lib/libcmocka.a"
}

# SYSTEM, then what cmake is told besides.
build_core() {
  system=$1
  shift
  mkdir -p "$output/built/$system"
  cmake -S hexcon_native -B "$output/$system" -G Ninja -DHEXCON_WERROR=ON -DHEXCON_TESTS=ON \
    -DCMAKE_TOOLCHAIN_FILE="$PWD/scripts/release/$system.cmake" -DHEXCON_PYTHON_HEADERS="$output/python" \
    -DHEXCON_MODULE_FOLDER="$output/built/$system" "$@" >/dev/null
  ninja -C "$output/$system" --quiet
}

# SYSTEM, the program that runs its programs (empty: none is needed), and its name for the notes.
test_core() {
  if [ -n "$2" ] && ! command -v "$2" >/dev/null; then
    echo "not run: there is no $2" >"$output/$1/tested"
  else
    ctest --test-dir "$output/$1" --parallel 2 --output-on-failure >"$output/$1/tests.log" || { tail -60 "$output/$1/tests.log"; exit 1; }
    echo "$(sed -n 's/^.* tests failed out of \([0-9]*\)$/\1/p' "$output/$1/tests.log") native tests passed$3" >"$output/$1/tested"
  fi
  echo "release: $1: $(cat "$output/$1/tested")"
}

# For Wine: a folder of its own, no window, no talk.
export WINEPREFIX="$output/wine" WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml="
take_python_headers
for system in $systems; do
  case $system in
    linux-x86_64) debian=amd64 emulator="" words=" on this machine" ;;
    linux-aarch64) debian=arm64 emulator=qemu-aarch64 words=" in qemu-user" ;;
    windows-x86_64) debian="" emulator=wine words=" in Wine" ;;
  esac
  if [ -n "$debian" ]; then
    export HEXCON_SYSROOT="$output/sysroot-$debian"
    scripts/release/old_debian.sh "$debian" "$HEXCON_SYSROOT"
    build_core "$system"
  else
    export HEXCON_SYSROOT="$output/sysroot-windows"
    make_windows_libraries
    build_core "$system" -DHEXCON_PYTHON_LIBRARY="$HEXCON_SYSROOT/lib/libpython3.a"
  fi
  test_core "$system" "$emulator" "$words"
done
"$python" scripts/release/pack.py "$output"
