#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Build with warnings as errors, run the native tests, then the given tests; the last line tells what was tested, and how.
# Usage: test_here.sh TEST ...   (scripts/test_current.sh calls it where FreeCAD of today is)
set -eu
cd "$(dirname "$0")/.."
mkdir -p build
python=$(scripts/find-python.sh)
echo "FreeCAD $(freecadcmd --version </dev/null | sed -n 's/^FreeCAD \([^ ]*\).*/\1/p'), gcc $(gcc -dumpfullversion)," \
  "Python $("$python" -c 'import platform; print(platform.python_version())')" >build/versions
cmake -S hexcon_native -B build/tested -G Ninja -DHEXCON_WERROR=ON -DHEXCON_TESTS=ON -DPython3_EXECUTABLE="$python" >/dev/null
ninja -C build/tested --quiet
ctest --test-dir build/tested --parallel 2 --output-on-failure
status=0
PYTHONPATH=.:workbench timeout "${HEXCON_CURRENT_LIMIT:-0}" "$python" -m pytest -q -p no:cacheprovider -n 2 "$@" >build/tested.log 2>&1 || status=$?
cat build/tested.log
[ "$status" != 124 ] || echo "test-current: ended after $HEXCON_CURRENT_LIMIT seconds (HEXCON_CURRENT_LIMIT)"
echo "test-current: $(cat build/versions): $(tail -1 build/tested.log)"
exit $status
