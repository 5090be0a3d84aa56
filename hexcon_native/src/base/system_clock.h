/* SPDX-License-Identifier: LGPL-2.1-or-later */
/* The system's clock: C11's own is not there in MinGW-w64 before version 11. */
#ifndef HEXCON_BASE_SYSTEM_CLOCK_H
#define HEXCON_BASE_SYSTEM_CLOCK_H

/** Seconds since a moment that is the same for the whole process. */
double system_clock(void);

#endif
