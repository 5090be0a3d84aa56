/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A tetrahedral mesher written in Python, called by the core. */
#ifndef HEXCON_PYTHON_MESHER_CALL_H
#define HEXCON_PYTHON_MESHER_CALL_H

#include "run.h"

typedef struct mesher_call {
  run *r;             /* the call of the core that it serves; the GIL is released */
  PyObject *callable; /* borrowed: (points, point_count, triangles) -> None or (bytes of new
                         points, bytes of tetrahedra) */
  PyObject *points, *tetrahedra; /* what it handed out last */
} mesher_call;

/** A hexcon_tetrahedralise; user is the mesher_call. An exception cancels the core's call. */
bool call_mesher(void *user, const double *points, size_t point_count, const int32_t *triangles,
                 size_t triangle_count, hexcon_tetrahedra *out);
/** Drop what was handed out; the GIL is held. */
void mesher_call_release(mesher_call *call);

#endif
