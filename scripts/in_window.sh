#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Run a script of tests/gui in FreeCAD's window under Xvfb, with a user's folder of its own, and print what it says.
# Usage: in_window.sh SCRIPT FOLDER   (where the script puts its pictures)
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
script=$(realpath "$1")
mkdir -p "$2"
folder=$(realpath "$2")
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir "$home/Mod"
rm -f "$folder/steps.log"
status=0
# FreeCAD's own output goes to a file: it is shown only if something went wrong
env -u PYTHONPATH FREECAD_USER_HOME="$home" HEXCON_TEST_OUT="$folder" QTWEBENGINE_DISABLE_SANDBOX=1 \
  xvfb-run -a -s "-screen 0 1400x900x24" "${FREECAD:-freecad}" "$script" -M "$root" \
  </dev/null >"$home/freecad.log" 2>&1 || status=$?
cat "$folder/steps.log" 2>/dev/null || status=1
rm -f "$folder/steps.log"
[ "$status" = 0 ] || { cat "$home/freecad.log" >&2; exit "$status"; }
