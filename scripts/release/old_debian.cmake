# SPDX-License-Identifier: LGPL-2.1-or-later
# HEXCON_SYSROOT: the folder of old_debian.sh.
set(CMAKE_SYSROOT $ENV{HEXCON_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_LIBRARY_ARCHITECTURE ${CMAKE_SYSTEM_PROCESSOR}-linux-gnu)
# before the C library that a cross compiler brings
set(old_triplet ${CMAKE_SYSTEM_PROCESSOR}-linux-gnu)
set(CMAKE_C_FLAGS_INIT "-isystem =/usr/include/${old_triplet} -isystem =/usr/include -B$ENV{HEXCON_SYSROOT}/usr/lib/${old_triplet}")
foreach(kind EXE MODULE SHARED)
  set(CMAKE_${kind}_LINKER_FLAGS_INIT "-L=/lib/${old_triplet} -L=/usr/lib/${old_triplet}")
endforeach()
