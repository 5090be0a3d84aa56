# SPDX-License-Identifier: LGPL-2.1-or-later
# The cross compiler with an old Debian's C library; what it makes runs here in qemu-user.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L $ENV{HEXCON_SYSROOT})
include(${CMAKE_CURRENT_LIST_DIR}/old_debian.cmake)
