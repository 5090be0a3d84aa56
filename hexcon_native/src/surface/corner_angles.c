/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "corner_angles.h"

#include <stdio.h>

#include "base/vector.h"
#include "geometry.h"
#include "numbering.h"

static const double pi = 3.14159265358979323846;
static const double degrees = 180 / 3.14159265358979323846;

/** Angles this near to 0 or 180 degrees are taken for it. */
static const double smallest_sine = 1e-10;

double surface_corner_angle(const surface *s, int32_t half_edge) {
  const double *here = s->points + 3 * (size_t)s->quads[half_edge];
  double next[3], previous[3], cross[3], normal[3];
  vector_subtract(s->points + 3 * (size_t)s->quads[half_edge_turn(half_edge, 1)], here, next);
  vector_subtract(s->points + 3 * (size_t)s->quads[half_edge_turn(half_edge, -1)], here, previous);
  vector_cross(next, previous, cross);
  surface_quad_normal(s, half_edge_quad(half_edge), normal);
  double angle = atan2(vector_length(cross), vector_dot(next, previous));
  return vector_dot(cross, normal) < 0 ? 2 * pi - angle : angle;
}

/** Whether the quad shares its next edge, too, with the quad beyond this one. */
static bool begins_double_edge(const surface *s, int32_t half_edge) {
  int32_t next = half_edge_turn(half_edge, 1);
  return half_edge_quad(s->twins[half_edge]) == half_edge_quad(s->twins[next]);
}

typedef struct fault_words {
  char text[256];
  size_t length, count;
} fault_words;

static void add_words(fault_words *words, const char *separator, int32_t quad, double angle) {
  if (words->count < 4) {
    int written =
        snprintf(words->text + words->length, sizeof words->text - words->length,
                 "%squad %d: %.4g degrees", words->count ? separator : "", (int)quad, angle);
    words->length += written > 0 ? (size_t)written : 0;
    if (words->length >= sizeof words->text)
      words->length = sizeof words->text - 1;
  }
  words->count++;
}

hexcon_status surface_check_fillable(hexcon_context *context, const surface *s, bool star_shaped) {
  fault_words corners = {.text = ""}, shared = {.text = ""};
  int32_t listed = -1; /* a quad with several faults is listed once */
  for (int32_t h = 0; h < (int32_t)(4 * s->quad_count); h++) {
    double angle = surface_corner_angle(s, h);
    bool unfillable = (angle >= pi && !star_shaped) || fabs(sin(angle)) <= smallest_sine;
    const int32_t quad = numbering_quad_name(s, half_edge_quad(h));
    bool doubled = begins_double_edge(s, h);
    if (unfillable)
      add_words(&corners, ", ", quad, angle * degrees);
    if (doubled)
      add_words(&shared, ", ", quad, surface_corner_angle(s, half_edge_turn(h, 1)) * degrees);
    if ((unfillable || doubled) && half_edge_quad(h) != listed) {
      listed = half_edge_quad(h);
      context_add_element(context, listed);
    }
  }
  if (corners.count)
    return context_fail(
        context, HEXCON_UNFILLABLE_QUAD,
        "%zu corners of quads are of 180 degrees or more, or of none (%s%s): no hex "
        "with a positive Jacobian can stand there; move their points or remesh",
        corners.count, corners.text, corners.count > 4 ? ", ..." : "");
  if (shared.count)
    return context_fail(context, HEXCON_UNFILLABLE_QUAD,
                        "%zu quads share two edges with a neighbour (%s%s at the point between): "
                        "the two corners there lie upon each other, so no hex with a positive "
                        "Jacobian can stand there; merge or split the two quads",
                        shared.count, shared.text, shared.count > 4 ? ", ..." : "");
  return HEXCON_OK;
}
