#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Print the interpreter that matches FreeCAD's own Python: the first python3 on PATH may be
# another one, without numpy and VTK. PYTHON, if set, is taken as it is.
set -eu
if [ -n "${PYTHON:-}" ]; then
  echo "$PYTHON"
  exit 0
fi
here=$(dirname "$0")
found=$("${FREECADCMD:-freecadcmd}" "$here/report_python.py" </dev/null 2>/dev/null |
  sed -n 's/^FREECAD_PYTHON=//p') || found=
for candidate in "$found" /usr/bin/python3; do
  if [ -n "$candidate" ] && [ -x "$candidate" ] && "$candidate" -c 'import numpy' 2>/dev/null; then
    echo "$candidate"
    exit 0
  fi
done
echo "find-python: no interpreter with numpy that matches FreeCAD's; set PYTHON" >&2
exit 1
