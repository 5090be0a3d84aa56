#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# A release as a user has it: unpacked into the Mod folder of a user with nothing else, then by clicks from an empty document to
# displacements, in FreeCAD's window under Xvfb. Usage: try_release.sh ZIP FOLDER   (where the pictures are put)
set -eu
zip=$(realpath "$1")
mkdir -p "$2"
folder=$(realpath "$2")
script=$(realpath "$(dirname "$0")/../tests/gui/script_release.py")
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir "$home/Mod"
/usr/bin/python3 -m zipfile -e "$zip" "$home/Mod"
(cd "$home/Mod/HexCon" && sha256sum --quiet -c SHA256SUMS)
for compiler in gcc cc clang; do
  ! command -v "$compiler" >/dev/null || echo "try-release: there is a $compiler here; the release does not use it"
done
rm -f "$folder/steps.log"
status=0
env -u PYTHONPATH FREECAD_USER_HOME="$home" HEXCON_TEST_OUT="$folder" QTWEBENGINE_DISABLE_SANDBOX=1 \
  xvfb-run -a -s "-screen 0 1400x900x24" "${FREECAD:-freecad}" "$script" </dev/null >"$home/freecad.log" 2>&1 || status=$?
cat "$folder/steps.log" 2>/dev/null || status=1
grep -q "all steps passed" "$folder/steps.log" || status=1
[ "$status" = 0 ] || { cat "$home/freecad.log" >&2; exit "$status"; }
