/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "system_clock.h"

#ifdef _WIN32
#include <windows.h>

double system_clock(void) {
  FILETIME now; /* in tenths of microseconds */
  GetSystemTimeAsFileTime(&now);
  return 1e-7 * ((double)now.dwHighDateTime * 4294967296.0 + (double)now.dwLowDateTime);
}

#else
#include <time.h>

double system_clock(void) {
  struct timespec now;
  (void)timespec_get(&now, TIME_UTC);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
