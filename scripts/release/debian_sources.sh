#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# The sources of a package of Debian 12, unpacked. Usage: debian_sources.sh PACKAGE FOLDER
set -eu
package=$1
folder=$2
# shellcheck source=scripts/release/own_apt.sh
. "$(dirname "$0")/own_apt.sh"
rm -rf "$folder" "$folder.apt"
mkdir -p "$folder"
own_apt "$folder.apt" deb-src bookworm
ask_apt update
(cd "$apt_folder" && ask_apt source --download-only "$package")
tar -xf "$(find "$apt_folder" -name "${package}_*.orig.tar.*" ! -name "*.asc")" -C "$folder" --strip-components=1
rm -rf "$apt_folder"
