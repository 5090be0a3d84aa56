#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# clang-tidy over C files, as many at a time as there are processors, one a process: from the second file of a process on,
# its check of va_list takes va_start for nothing. Usage: tidy.sh BUILD_FOLDER FILE...
# What examples need to be built is not in the build folder: their flags are given here.
set -eu
folder=$1
shift
printf '%s\n' "$@" | grep -v '^examples/' | xargs -P "$(nproc)" -n 1 clang-tidy --quiet -p "$folder" 2>/dev/null
printf '%s\n' "$@" | { grep '^examples/' || true; } |
  xargs -I '{}' clang-tidy --quiet '{}' -- -std=c11 -Wall -Wextra -Ihexcon_native/include 2>/dev/null
