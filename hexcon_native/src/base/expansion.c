/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "expansion.h"

#include <math.h>
#include <string.h>

/** Below this a product's rounding error may underflow, and the result is not exact. */
static const double smallest_exact_product = 0x1p-960;

/** a + b = sum + error, exactly. */
static double two_sum(double a, double b, double *error) {
  double sum = a + b, part = sum - a;
  *error = (a - (sum - part)) + (b - part);
  return sum;
}

/** As two_sum, for |a| >= |b|. */
static double fast_two_sum(double a, double b, double *error) {
  double sum = a + b;
  *error = b - (sum - a);
  return sum;
}

/** a b = product + error, exactly unless it underflows. */
static double two_product(double a, double b, double *error) {
  double product = a * b;
  *error = fma(a, b, -product);
  return product;
}

/** Keep the terms that are not zero, merged as far as they go (Shewchuk's COMPRESS). */
static expansion compress(const double *terms, int count, bool lost) {
  double merged[2 * EXPANSION_TERMS];
  expansion out = {.lost = lost};
  if (count == 0)
    return out;
  int bottom = count;
  double rest = terms[count - 1], error;
  for (int i = count - 2; i >= 0; i--) {
    double sum = fast_two_sum(rest, terms[i], &error);
    rest = sum;
    if (error != 0) {
      merged[--bottom] = sum;
      rest = error;
    }
  }
  merged[--bottom] = rest;
  double top = merged[bottom];
  for (int i = bottom + 1; i < count; i++) {
    double sum = fast_two_sum(merged[i], top, &error);
    top = sum;
    if (error != 0) {
      out.lost |= out.count == EXPANSION_TERMS;
      if (out.count < EXPANSION_TERMS)
        out.terms[out.count++] = error;
    }
  }
  out.lost |= out.count == EXPANSION_TERMS;
  if (top != 0 && out.count < EXPANSION_TERMS)
    out.terms[out.count++] = top;
  return out;
}

expansion expansion_difference(double a, double b) {
  double terms[2];
  terms[1] = two_sum(a, -b, &terms[0]);
  return compress(terms, 2, !isfinite(terms[1]));
}

/** Shewchuk's LINEAR-EXPANSION-SUM on terms merged by magnitude. */
expansion expansion_sum(const expansion *a, const expansion *b) {
  double ordered[2 * EXPANSION_TERMS], terms[2 * EXPANSION_TERMS];
  int i = 0, j = 0, total = a->count + b->count;
  for (int k = 0; k < total; k++)
    if (j == b->count || (i < a->count && fabs(a->terms[i]) < fabs(b->terms[j])))
      ordered[k] = a->terms[i++];
    else
      ordered[k] = b->terms[j++];
  int count = 0;
  double running = 0, error;
  for (int k = 0; k < total; k++) {
    running = two_sum(running, ordered[k], &error);
    if (error != 0)
      terms[count++] = error;
  }
  if (running != 0)
    terms[count++] = running;
  return compress(terms, count, a->lost || b->lost);
}

/** Shewchuk's SCALE-EXPANSION. */
static expansion scale(const expansion *a, double factor) {
  double terms[2 * EXPANSION_TERMS];
  int count = 0;
  bool lost = a->lost;
  double running = 0, error;
  for (int i = 0; i < a->count; i++) {
    double low, high = two_product(a->terms[i], factor, &low);
    lost |= fabs(high) < smallest_exact_product;
    double sum = i == 0 ? low : two_sum(running, low, &error);
    if (i > 0 && error != 0)
      terms[count++] = error;
    running = fast_two_sum(high, sum, &error);
    if (error != 0)
      terms[count++] = error;
  }
  if (running != 0)
    terms[count++] = running;
  return compress(terms, count, lost);
}

expansion expansion_product(const expansion *a, const expansion *b) {
  expansion product = {.lost = a->lost || b->lost};
  for (int i = 0; i < b->count; i++) {
    expansion part = scale(a, b->terms[i]);
    product = expansion_sum(&product, &part);
  }
  return product;
}

expansion expansion_scaled(const expansion *a, double power_of_two) {
  expansion out = *a;
  for (int i = 0; i < out.count; i++) {
    out.terms[i] *= power_of_two;
    out.lost |= fabs(out.terms[i]) < smallest_exact_product;
  }
  return out;
}

int expansion_sign(const expansion *a) {
  if (a->count == 0)
    return 0;
  return a->terms[a->count - 1] > 0 ? 1 : -1;
}
