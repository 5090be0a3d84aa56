/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** On which side of a plane, or of a line in the plane, a point lies: exactly. */
#ifndef HEXCON_EMBEDDING_ORIENTATION_H
#define HEXCON_EMBEDDING_ORIENTATION_H

/** In place of a sign: the numbers are too wide for exact arithmetic. */
enum { ORIENTATION_LOST = 2 };

/** The sign of det(b - a, c - a, d - a); 0: the four points lie in a plane; or ORIENTATION_LOST. */
int orientation_in_space(const double a[3], const double b[3], const double c[3],
                         const double d[3]);

/** The sign of det(b - a, c - a), seen along an axis: 1 is a left turn. */
int orientation_along(int axis, const double a[3], const double b[3], const double c[3]);

#endif
