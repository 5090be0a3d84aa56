# SPDX-License-Identifier: LGPL-2.1-or-later
# This machine's compiler with an old Debian's C library, so that the core loads on older systems too.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-linux-gnu-gcc)
set(CMAKE_C_COMPILER_TARGET x86_64-linux-gnu)
include(${CMAKE_CURRENT_LIST_DIR}/old_debian.cmake)
