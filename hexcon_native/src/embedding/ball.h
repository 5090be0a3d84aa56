/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Numbers known to within a radius: what is said of their signs is proved, whatever the rounding.
 */
#ifndef HEXCON_EMBEDDING_BALL_H
#define HEXCON_EMBEDDING_BALL_H

#include <math.h>

typedef struct ball {
  double mid, radius;
} ball;

/** Half an ulp of 1; what the sums below lose to rounding themselves; what an underflow loses. */
#define BALL_ROUNDING 0x1p-53
#define BALL_SLACK (1 + 0x1p-50)
#define BALL_UNDERFLOW 0x1p-1070

static inline ball ball_exact(double value) {
  return (ball){value, 0};
}

/** A difference of two doubles: rounded once. */
static inline ball ball_difference(double a, double b) {
  double mid = a - b;
  return (ball){mid, fabs(mid) * BALL_ROUNDING};
}

static inline ball ball_add(ball a, ball b) {
  double mid = a.mid + b.mid;
  return (ball){mid, (a.radius + b.radius + fabs(mid) * BALL_ROUNDING) * BALL_SLACK};
}

static inline ball ball_negated(ball a) {
  return (ball){-a.mid, a.radius};
}

static inline ball ball_subtract(ball a, ball b) {
  return ball_add(a, ball_negated(b));
}

static inline ball ball_multiply(ball a, ball b) {
  double mid = a.mid * b.mid;
  double spread = fabs(a.mid) * b.radius + a.radius * (fabs(b.mid) + b.radius);
  return (ball){mid, (spread + fabs(mid) * BALL_ROUNDING) * BALL_SLACK + BALL_UNDERFLOW};
}

/** Times a double, exact. */
static inline ball ball_scaled(ball a, double factor) {
  double mid = a.mid * factor;
  return (ball){mid, (a.radius * fabs(factor) + fabs(mid) * BALL_ROUNDING) * BALL_SLACK +
                         BALL_UNDERFLOW};
}

/** 1, -1, or 0 where the sign is not certain. */
static inline int ball_sign(ball a) {
  return (a.mid > a.radius) - (a.mid < -a.radius);
}

/** Not above, and not below, anything in it. */
static inline double ball_low(ball a) {
  return (a.mid - a.radius) - (fabs(a.mid) + a.radius) * (4 * BALL_ROUNDING);
}

static inline double ball_high(ball a) {
  return (a.mid + a.radius) + (fabs(a.mid) + a.radius) * (4 * BALL_ROUNDING);
}

static inline ball ball_dot(const ball a[3], const ball b[3]) {
  ball sum = ball_multiply(a[0], b[0]);
  sum = ball_add(sum, ball_multiply(a[1], b[1]));
  return ball_add(sum, ball_multiply(a[2], b[2]));
}

/** With a vector of doubles, exact. */
static inline ball ball_dot_exact(const double a[3], const ball b[3]) {
  ball sum = ball_scaled(b[0], a[0]);
  sum = ball_add(sum, ball_scaled(b[1], a[1]));
  return ball_add(sum, ball_scaled(b[2], a[2]));
}

static inline void ball_cross(const ball a[3], const ball b[3], ball out[3]) {
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = ball_subtract(ball_multiply(a[j], b[k]), ball_multiply(a[k], b[j]));
  }
}

static inline ball ball_determinant(const ball a[3], const ball b[3], const ball c[3]) {
  ball product[3];
  ball_cross(b, c, product);
  return ball_dot(a, product);
}

#endif
