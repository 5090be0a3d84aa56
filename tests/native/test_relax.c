/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Relaxation: boundary points slide on what they lie on, exactly; it repairs, and never makes a
 * mesh worse. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"

static const double right_angle = 1.5707963267948966;

/* ------------------------------------------------------------------------------------- bodies */

enum { CARRIERS = 26 };

/** A grid of hexes in some coordinates u, v, w, and a carrier for each of its 6 faces, 12 edges and
 * 8 corners: side 0, 1 or 2 along each axis; (1, 1, 1) is the inside. */
typedef struct body {
  test_mesh mesh;
  int32_t *of_point;
  hexcon_carrier pieces[CARRIERS];
  int32_t starts[CARRIERS + 1];
  hexcon_sliding sliding;
} body;

typedef void (*body_map)(const double u[3], double point[3]);
/** The carrier of points with these sides, one or two of which are no 1; false: they stay. */
typedef bool (*body_carrier)(const int sides[3], hexcon_carrier *out);

static body make_body(int n, body_map map, body_carrier carrier) {
  body b = {.mesh = make_box(n, n, n)};
  int32_t number[27], count = 0;
  for (int s = 0; s < 27; s++) {
    const int sides[3] = {s % 3, s / 3 % 3, s / 9};
    int outer = (sides[0] != 1) + (sides[1] != 1) + (sides[2] != 1);
    number[s] = outer == 0 ? HEXCON_FREE : HEXCON_STAYS;
    if (outer == 1 || outer == 2) {
      memset(&b.pieces[count], 0, sizeof b.pieces[count]);
      if (carrier(sides, &b.pieces[count]))
        number[s] = count++;
    }
  }
  for (int i = 0; i <= CARRIERS; i++)
    b.starts[i] = i;
  b.of_point = malloc(b.mesh.point_count * sizeof *b.of_point);
  assert_non_null(b.of_point);
  for (size_t v = 0; v < b.mesh.point_count; v++) {
    double *p = b.mesh.points + 3 * v, u[3];
    int key = 0;
    for (int k = 2; k >= 0; k--) {
      key = 3 * key + (p[k] == 0 ? 0 : p[k] == n ? 2 : 1);
      u[k] = p[k] / n;
    }
    b.of_point[v] = number[key];
    map(u, p);
  }
  b.sliding = (hexcon_sliding){.carrier_of_point = b.of_point,
                               .carrier_count = (size_t)count,
                               .starts = b.starts,
                               .pieces = b.pieces};
  return b;
}

static void body_free(body *b) {
  test_mesh_free(&b->mesh);
  free(b->of_point);
}

/** `sliding` points into the body itself. */
static const hexcon_sliding *sliding_of(body *b) {
  b->sliding.starts = b->starts;
  b->sliding.pieces = b->pieces;
  return &b->sliding;
}

static void scramble(body *b, uint64_t *random, double amount) {
  for (size_t v = 0; v < b->mesh.point_count; v++)
    for (size_t k = 0; k < 3 && b->of_point[v] != HEXCON_STAYS; k++)
      b->mesh.points[3 * v + k] += random_between(random, -amount, amount);
}

/* The cube of edge 1: planes and lines. */

static void cube_map(const double u[3], double point[3]) {
  memcpy(point, u, 3 * sizeof *u);
}

static bool cube_carrier(const int sides[3], hexcon_carrier *c) {
  int outer = 0;
  for (int k = 0; k < 3; k++) {
    c->origin[k] = sides[k] / 2.0;
    outer += sides[k] != 1;
  }
  c->kind = outer == 1 ? HEXCON_CARRIER_PLANE : HEXCON_CARRIER_LINE;
  for (int k = 0; k < 3; k++)
    c->axis[k] = (sides[k] != 1) == (outer == 1) ? -3 : 0;
  return true;
}

/* A quarter of a pipe with radii 1 and 2: cylinders, planes, circles and lines. */

static void pipe_map(const double u[3], double point[3]) {
  double radius = 1 + u[0], angle = right_angle * u[1];
  point[0] = radius * cos(angle);
  point[1] = radius * sin(angle);
  point[2] = u[2];
}

static bool pipe_carrier(const int sides[3], hexcon_carrier *c) {
  double radius = 1 + sides[0] / 2.0;
  bool on_radius = sides[0] != 1, on_angle = sides[1] != 1, on_height = sides[2] != 1;
  c->axis[2] = 2;
  c->origin[2] = on_height ? sides[2] / 2.0 : 7;
  if (on_radius && on_angle) { /* along the pipe */
    c->kind = HEXCON_CARRIER_LINE;
    c->origin[sides[1] / 2] = radius;
  } else if (on_angle) { /* across the wall */
    c->kind = on_height ? HEXCON_CARRIER_LINE : HEXCON_CARRIER_PLANE;
    c->axis[2] = 0;
    c->axis[on_height ? sides[1] / 2 : 1 - sides[1] / 2] = 1;
  } else if (on_radius) {
    c->kind = on_height ? HEXCON_CARRIER_CIRCLE : HEXCON_CARRIER_CYLINDER;
    c->sizes[0] = radius;
  } else {
    c->kind = HEXCON_CARRIER_PLANE;
  }
  return true;
}

/* An eighth of a shell between spheres, without its pole: spheres, planes and cones; edges stay. */

static void shell_map(const double u[3], double point[3]) {
  double radius = 2 + u[0], angle = right_angle * u[1], polar = 1.5 - u[2];
  point[0] = radius * sin(polar) * cos(angle);
  point[1] = radius * sin(polar) * sin(angle);
  point[2] = radius * cos(polar);
}

static bool shell_carrier(const int sides[3], hexcon_carrier *c) {
  if ((sides[0] != 1) + (sides[1] != 1) + (sides[2] != 1) == 2)
    return false;
  c->kind = sides[0] != 1   ? HEXCON_CARRIER_SPHERE
            : sides[1] != 1 ? HEXCON_CARRIER_PLANE
                            : HEXCON_CARRIER_CONE;
  c->sizes[0] = sides[0] != 1 ? 2 + sides[0] / 2.0 : 1.5 - sides[2] / 2.0;
  c->axis[sides[1] == 0 ? 1 : sides[1] == 2 ? 0 : 2] = 1;
  return true;
}

/* A quarter of the wall of a bent pipe: tori, planes and a cylinder; edges stay. */

static void bend_map(const double u[3], double point[3]) {
  double radius = 1 + u[0], tube = right_angle * u[1], angle = right_angle * (1 - u[2]);
  double out = 4 + radius * cos(tube);
  point[0] = out * cos(angle);
  point[1] = out * sin(angle);
  point[2] = radius * sin(tube);
}

static bool bend_carrier(const int sides[3], hexcon_carrier *c) {
  if ((sides[0] != 1) + (sides[1] != 1) + (sides[2] != 1) == 2)
    return false;
  c->kind = sides[0] != 1   ? HEXCON_CARRIER_TORUS
            : sides[1] == 2 ? HEXCON_CARRIER_CYLINDER
                            : HEXCON_CARRIER_PLANE;
  c->axis[sides[2] == 0 ? 0 : sides[2] == 2 ? 1 : 2] = 1;
  c->sizes[0] = 4;
  c->sizes[1] = 1 + sides[0] / 2.0;
  return true;
}

static const struct {
  const char *name;
  body_map map;
  body_carrier carrier;
  double scramble, worst; /* what must come out at least */
} bodies[] = {{"cube", cube_map, cube_carrier, 0.2, 0.99},
              {"pipe", pipe_map, pipe_carrier, 0.2, 0.9},
              {"shell", shell_map, shell_carrier, 0.15, 0.7},
              {"bend", bend_map, bend_carrier, 0.15, 0.7}};
enum { BODIES = sizeof bodies / sizeof *bodies };

/* -------------------------------------------------------------------------------- closed forms */

/** How far a place is from a carrier by its equation, and the equation's gradient where it is a
 * surface; written down anew, not as the core does. */
static double residual(const hexcon_carrier *c, const double p[3]) {
  double d[3], across[3], axis = 0, along = 0, square = 0, out = 0, length;
  for (int k = 0; k < 3; k++) {
    d[k] = p[k] - c->origin[k];
    axis += c->axis[k] * c->axis[k];
    square += d[k] * d[k];
  }
  for (int k = 0; k < 3; k++) {
    along += d[k] * c->axis[k] / sqrt(axis);
    across[k] = (d[(k + 1) % 3] * c->axis[(k + 2) % 3] - d[(k + 2) % 3] * c->axis[(k + 1) % 3]);
    out += across[k] * across[k];
  }
  out = sqrt(out / axis);
  switch (c->kind) {
  case HEXCON_CARRIER_POINT:
    return sqrt(square);
  case HEXCON_CARRIER_LINE:
    return out;
  case HEXCON_CARRIER_CIRCLE:
    return hypot(out - c->sizes[0], along);
  case HEXCON_CARRIER_ELLIPSE:
    length = 0;
    for (int k = 0; k < 3; k++)
      length += d[k] * c->across[k]; /* of length 1 here */
    return hypot(along, sqrt(length * length / (c->sizes[0] * c->sizes[0]) +
                             (out * out - length * length) / (c->sizes[1] * c->sizes[1])) -
                            1);
  case HEXCON_CARRIER_PLANE:
    return fabs(along);
  case HEXCON_CARRIER_CYLINDER:
    return fabs(out - c->sizes[0]);
  case HEXCON_CARRIER_CONE:
    return fabs(out * cos(c->sizes[0]) - along * sin(c->sizes[0]));
  case HEXCON_CARRIER_SPHERE:
    return fabs(sqrt(square) - c->sizes[0]);
  default:
    return fabs(hypot(out - c->sizes[0], along) - c->sizes[1]);
  }
}

/** Places lie on the carriers; no other place of a carrier is nearer; the direction is a tangent or
 * a normal. */
static void places_are_nearest(void **state) {
  (void)state;
  uint64_t random = 31;
  hexcon_context *context = hexcon_context_new();
  for (int round = 0; round < 4000; round++) {
    hexcon_carrier c = {.kind = round % HEXCON_CARRIER_COUNT, .axis = {0, 0, 1}, .across = {1}};
    if (c.kind == HEXCON_CARRIER_CURVE || c.kind == HEXCON_CARRIER_SURFACE ||
        c.kind == HEXCON_CARRIER_FACETS)
      continue;
    double p[3], at[3], way[3];
    for (int k = 0; k < 3; k++) {
      c.origin[k] = random_between(&random, -2, 2);
      p[k] = random_between(&random, -3, 3);
      if (c.kind != HEXCON_CARRIER_ELLIPSE)
        c.axis[k] = random_between(&random, -1, 1);
    }
    c.sizes[0] = random_between(&random, 0.1, 1.5);
    c.sizes[1] = random_between(&random, 0.05, 1) * c.sizes[0];
    if (c.kind == HEXCON_CARRIER_LINE || c.kind == HEXCON_CARRIER_CIRCLE)
      c.sizes[c.kind == HEXCON_CARRIER_CIRCLE] = 0;
    const int32_t starts[2] = {0, 1}, of_point = 0;
    const hexcon_sliding sliding = {
        .carrier_of_point = &of_point, .carrier_count = 1, .starts = starts, .pieces = &c};
    assert_int_equal(hexcon_project_points(context, p, 1, &sliding, at, way), HEXCON_OK);
    assert_close(residual(&c, at), 0, 1e-13);
    int freedom = hexcon_carrier_info(c.kind)->freedom;
    double gap[3], square = 0, slant = 0, length = 0;
    for (int k = 0; k < 3; k++) {
      gap[k] = p[k] - at[k];
      square += gap[k] * gap[k];
      slant += gap[k] * way[k];
      length += way[k] * way[k];
    }
    assert_close(length, freedom == 0 ? 0 : 1, 1e-14);
    if (freedom == 1)
      assert_close(slant, 0, 1e-10);
    bool apex = c.kind == HEXCON_CARRIER_CONE && memcmp(at, c.origin, sizeof at) == 0;
    if (freedom == 2 && !apex)
      assert_close(fabs(slant), sqrt(square), 1e-12);
    for (int other = 0; other < 20; other++) {
      double q[3], there[3], farther = 0;
      for (int k = 0; k < 3; k++)
        q[k] = at[k] + random_between(&random, -2, 2);
      assert_int_equal(hexcon_project_points(context, q, 1, &sliding, there, NULL), HEXCON_OK);
      for (int k = 0; k < 3; k++)
        farther += (p[k] - there[k]) * (p[k] - there[k]);
      assert_true(farther >= square * (1 - 1e-12));
    }
  }
  hexcon_context_free(context);
}

/** Lines and arcs that end: no sample of them is nearer than the place that is found. */
static void ends_are_kept(void **state) {
  (void)state;
  uint64_t random = 36;
  hexcon_context *context = hexcon_context_new();
  const int32_t starts[2] = {0, 1}, of_point = 0;
  size_t at_ends = 0;
  for (int round = 0; round < 400; round++) {
    const bool is_line = round % 2;
    hexcon_carrier c = {.kind = is_line ? HEXCON_CARRIER_LINE : HEXCON_CARRIER_CIRCLE,
                        .axis = {0, 0, 3},
                        .across = {0, 2, 0}};
    double p[3], at[3], nearest = INFINITY, found = 0, length = random_between(&random, 0.1, 6.2);
    c.sizes[0] = is_line ? length : 1.5;
    c.sizes[1] = is_line ? 0 : length;
    for (int k = 0; k < 3; k++)
      p[k] = random_between(&random, -4, 4);
    const hexcon_sliding sliding = {
        .carrier_of_point = &of_point, .carrier_count = 1, .starts = starts, .pieces = &c};
    assert_int_equal(hexcon_project_points(context, p, 1, &sliding, at, NULL), HEXCON_OK);
    for (int i = 0; i <= 2000; i++) {
      double t = length * i / 2000, gap = 0;
      const double q[3] = {is_line ? 0 : -1.5 * sin(t), is_line ? 0 : 1.5 * cos(t),
                           is_line ? t : 0};
      for (int k = 0; k < 3; k++)
        gap += (p[k] - q[k]) * (p[k] - q[k]);
      nearest = fmin(nearest, gap);
      at_ends +=
          i % 2000 == 0 && fabs(at[0] - q[0]) + fabs(at[1] - q[1]) + fabs(at[2] - q[2]) < 1e-14;
    }
    for (int k = 0; k < 3; k++)
      found += (p[k] - at[k]) * (p[k] - at[k]);
    assert_close(sqrt(found), sqrt(nearest), 1e-4);
    assert_true(found <= nearest + 1e-12);
  }
  assert_true(at_ends > 50);
  hexcon_context_free(context);
}

/** On the axis, in the centre, on an ellipse's longer axis: some nearest place. */
static void where_all_places_are_near(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  for (int kind = 0; kind < HEXCON_CARRIER_COUNT; kind++)
    for (int far = 0; far < 3; far++) {
      hexcon_carrier c = {kind, 0, {1, 2, 3}, {0, 0, 2}, {1, 0, 0}, {1.2, 0.5}};
      if (kind == HEXCON_CARRIER_CIRCLE)
        c.sizes[1] = 0;
      const int32_t starts[2] = {0, 1}, of_point = 0;
      const hexcon_sliding sliding = {
          .carrier_of_point = &of_point, .carrier_count = 1, .starts = starts, .pieces = &c};
      double p[3] = {1, 2, 3}, way[3];
      p[far == 1 ? 2 : 0] += far == 0 ? 0 : 0.1;
      if (kind == HEXCON_CARRIER_CURVE || kind == HEXCON_CARRIER_SURFACE ||
          kind == HEXCON_CARRIER_FACETS)
        continue;
      assert_int_equal(hexcon_project_points(context, p, 1, &sliding, p, way), HEXCON_OK);
      assert_close(residual(&c, p), 0, 1e-13);
    }
  hexcon_context_free(context);
}

/* ---------------------------------------------------------------------------------- relaxation */

typedef struct standing {
  size_t inverted;
  double worst;
} standing;

static standing measure(const body *b, const double *points) {
  hexcon_context *context = hexcon_context_new();
  standing s = {0, 1};
  double *values = malloc(b->mesh.hex_count * sizeof *values);
  assert_non_null(values);
  assert_int_equal(hexcon_quality(context, points, b->mesh.point_count, b->mesh.hexes,
                                  b->mesh.hex_count, values),
                   HEXCON_OK);
  for (size_t h = 0; h < b->mesh.hex_count; h++) {
    s.inverted += !(values[h] > 0);
    s.worst = fmin(s.worst, values[h]);
  }
  free(values);
  hexcon_context_free(context);
  return s;
}

static double *relax(body *b, const hexcon_relax_options *options) {
  test_memory memory = {0};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
  double *positions = calloc(b->mesh.point_count + 1, 3 * sizeof *positions);
  assert_non_null(positions);
  assert_int_equal(hexcon_relax(context, b->mesh.points, b->mesh.point_count, b->mesh.hexes,
                                b->mesh.hex_count, sliding_of(b), options, positions),
                   HEXCON_OK);
  hexcon_context_free(context);
  assert_int_equal(memory.live, 0);
  return positions;
}

/** The start on its carriers. */
static double *put_on(body *b) {
  hexcon_context *context = hexcon_context_new();
  double *positions = calloc(b->mesh.point_count + 1, 3 * sizeof *positions);
  assert_non_null(positions);
  assert_int_equal(hexcon_project_points(context, b->mesh.points, b->mesh.point_count,
                                         sliding_of(b), positions, NULL),
                   HEXCON_OK);
  hexcon_context_free(context);
  return positions;
}

static void scrambled_bodies_are_repaired(void **state) {
  (void)state;
  uint64_t random = 32;
  for (int i = 0; i < BODIES; i++)
    for (int round = 0; round < 3; round++) {
      body b = make_body(5, bodies[i].map, bodies[i].carrier);
      scramble(&b, &random, bodies[i].scramble);
      double *relaxed = relax(&b, NULL);
      standing after = measure(&b, relaxed);
      if (after.worst < bodies[i].worst)
        fail_msg("%s: worst %g", bodies[i].name, after.worst);
      for (size_t v = 0; v < b.mesh.point_count; v++) {
        if (b.of_point[v] == HEXCON_STAYS)
          assert_memory_equal(relaxed + 3 * v, b.mesh.points + 3 * v, 3 * sizeof *relaxed);
        if (b.of_point[v] >= 0)
          assert_close(residual(&b.pieces[b.of_point[v]], relaxed + 3 * v), 0, 1e-13);
      }
      free(relaxed);
      body_free(&b);
    }
}

/** Starts that may be beyond repair. */
static void never_worse(void **state) {
  (void)state;
  uint64_t random = 33;
  for (int round = 0; round < 24; round++) {
    body b = make_body(3, bodies[round % BODIES].map, bodies[round % BODIES].carrier);
    scramble(&b, &random, 0.1 * round);
    for (size_t v = 0; v < b.mesh.point_count; v++)
      if (random_below(&random, 6) == 0)
        b.of_point[v] = HEXCON_STAYS;
    const hexcon_relax_options options = {
        .max_rounds = round % 5, .passes = round % 4, .threads = round % 3};
    double *start = put_on(&b), *relaxed = relax(&b, &options);
    standing before = measure(&b, start), after = measure(&b, relaxed);
    assert_true(after.inverted <= before.inverted);
    assert_true(after.inverted < before.inverted || after.worst >= before.worst - 1e-12);
    free(start);
    free(relaxed);
    body_free(&b);
  }
}

/** Collapsed, tiny, enormous: nothing breaks, numbers stay finite. */
static void hopeless_bodies(void **state) {
  (void)state;
  static const double scales[] = {0, 1e-200, 1e-30, 1e30, 1e90};
  for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
    body b = make_body(3, cube_map, cube_carrier);
    for (size_t k = 0; k < 3 * b.mesh.point_count; k++)
      b.mesh.points[k] *= scales[i];
    double *relaxed = relax(&b, NULL);
    for (size_t k = 0; k < 3 * b.mesh.point_count; k++)
      assert_true(isfinite(relaxed[k]));
    free(relaxed);
    body_free(&b);
  }
}

/** A layer of hexes without any thickness, as sheets are when they are laid. */
static void flat_layers_open(void **state) {
  (void)state;
  body b = make_body(4, cube_map, cube_carrier);
  for (size_t v = 0; v < b.mesh.point_count; v++)
    if (b.mesh.points[3 * v + 2] == 0.25 || b.mesh.points[3 * v + 2] == 0.75)
      b.mesh.points[3 * v + 2] = b.mesh.points[3 * v + 2] < 0.5 ? 0 : 1;
  double *relaxed = relax(&b, NULL);
  assert_true(measure(&b, relaxed).worst > 0.99);
  free(relaxed);
  body_free(&b);
}

/** Rows in another order, hexes turned: the same places, bit for bit. */
static void numbering_does_not_matter(void **state) {
  (void)state;
  uint64_t random = 34;
  body b = make_body(3, pipe_map, pipe_carrier), other = make_body(3, pipe_map, pipe_carrier);
  size_t count = b.mesh.point_count;
  int32_t *to = malloc(count * sizeof *to);
  assert_non_null(to);
  scramble(&b, &random, 0.2);
  for (size_t v = 0; v < count; v++)
    to[v] = (int32_t)v;
  for (size_t v = count; v-- > 1;) {
    size_t w = random_below(&random, v + 1);
    int32_t kept = to[v];
    to[v] = to[w];
    to[w] = kept;
  }
  for (size_t v = 0; v < count; v++) {
    memcpy(other.mesh.points + 3 * to[v], b.mesh.points + 3 * v, 3 * sizeof(double));
    other.of_point[to[v]] = b.of_point[v];
  }
  static const int turned[8] = {1, 2, 3, 0, 5, 6, 7, 4};
  for (size_t h = 0; h < b.mesh.hex_count; h++)
    for (size_t c = 0; c < 8; c++)
      other.mesh.hexes[8 * (b.mesh.hex_count - 1 - h) + c] =
          to[b.mesh.hexes[8 * h + (size_t)turned[c]]];
  const hexcon_relax_options one = {.passes = 2, .mean_passes = 1, .threads = 1},
                             two = {.passes = 2, .mean_passes = 1, .threads = 2};
  double *relaxed = relax(&b, &one), *again = relax(&other, &two);
  for (size_t v = 0; v < count; v++)
    assert_memory_equal(relaxed + 3 * v, again + 3 * to[v], 3 * sizeof *relaxed);
  free(relaxed);
  free(again);
  free(to);
  body_free(&b);
  body_free(&other);
}

/* -------------------------------------------------------------------------- others' projections */

typedef struct asked {
  int calls, cancel_at;
  double answer; /* a length of the direction */
} asked;

/** The planes and lines of the cube, by their tags. */
static bool project_to_cube(void *user, size_t count, const double *points, const int32_t *tags,
                            double *projected, double *directions) {
  asked *a = user;
  memcpy(projected, points, 3 * count * sizeof *points);
  memset(directions, 0, 3 * count * sizeof *points);
  for (size_t i = 0; i < count; i++)
    for (int k = 0; k < 3; k++) {
      int side = (tags[i] >> (2 * k)) & 3, curve = tags[i] >> 6;
      if (side != 1)
        projected[3 * i + (size_t)k] = side / 2.0;
      if ((side != 1) != curve)
        directions[3 * i + (size_t)k] = a->answer;
    }
  return ++a->calls != a->cancel_at;
}

static bool asked_carrier(const int sides[3], hexcon_carrier *c) {
  bool edge = (sides[0] != 1) + (sides[1] != 1) + (sides[2] != 1) == 2;
  c->kind = edge ? HEXCON_CARRIER_CURVE : HEXCON_CARRIER_SURFACE;
  c->tag = sides[0] | sides[1] << 2 | sides[2] << 4 | edge << 6;
  return true;
}

static void others_project(void **state) {
  (void)state;
  uint64_t random = 35;
  body closed = make_body(4, cube_map, cube_carrier), open = make_body(4, cube_map, asked_carrier);
  asked a = {.answer = -2};
  scramble(&closed, &random, 0.2);
  memcpy(open.mesh.points, closed.mesh.points, 3 * open.mesh.point_count * sizeof(double));
  open.sliding.project = project_to_cube;
  open.sliding.project_user = &a;
  double *first = relax(&closed, NULL), *second = relax(&open, NULL);
  assert_true(a.calls > 3);
  for (size_t i = 0; i < 3 * open.mesh.point_count; i++)
    assert_close(first[i], second[i], 1e-4);
  free(first);
  free(second);
  /* a point that lies on no plane, or the nearest of two */
  int32_t starts[2] = {0, 2}, of_point = 0;
  hexcon_carrier pieces[2] = {{.kind = HEXCON_CARRIER_PLANE, .axis = {1, 0, 0}},
                              {.kind = HEXCON_CARRIER_SURFACE, .tag = 2 | 1 << 2 | 1 << 4}};
  hexcon_sliding two = {.carrier_of_point = &of_point,
                        .carrier_count = 1,
                        .starts = starts,
                        .pieces = pieces,
                        .project = project_to_cube,
                        .project_user = &a};
  hexcon_context *context = hexcon_context_new();
  double low[3] = {0.4, 5, 6}, high[3] = {0.6, 5, 6};
  assert_int_equal(hexcon_project_points(context, low, 1, &two, low, NULL), HEXCON_OK);
  assert_int_equal(hexcon_project_points(context, high, 1, &two, high, NULL), HEXCON_OK);
  assert_true(low[0] == 0 && high[0] == 1 && low[1] == 5 && high[2] == 6);
  hexcon_context_free(context);
  body_free(&closed);
  body_free(&open);
}

static hexcon_status try_relax(hexcon_context *context, body *b,
                               const hexcon_relax_options *options) {
  double *out = calloc(b->mesh.point_count + 1, 3 * sizeof *out);
  assert_non_null(out);
  hexcon_status status = hexcon_relax(context, b->mesh.points, b->mesh.point_count, b->mesh.hexes,
                                      b->mesh.hex_count, sliding_of(b), options, out);
  free(out);
  return status;
}

static void faults_of_others(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  body b = make_body(3, cube_map, asked_carrier);
  asked a = {.answer = 1, .cancel_at = 3};
  assert_int_equal(try_relax(context, &b, NULL), HEXCON_BAD_ARGUMENT); /* nobody is there to ask */
  b.sliding.project = project_to_cube;
  b.sliding.project_user = &a;
  b.mesh.points[3 * (b.mesh.point_count - 1)] += 0.1;
  assert_int_equal(try_relax(context, &b, NULL), HEXCON_CANCELLED);
  assert_message(context);
  static const double wrong[] = {0, NAN, INFINITY};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    a = (asked){.answer = wrong[i]};
    assert_int_equal(try_relax(context, &b, NULL), HEXCON_BAD_ARGUMENT);
    assert_message(context);
  }
  body_free(&b);
  hexcon_context_free(context);
}

static void faults(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  body b = make_body(2, cube_map, cube_carrier);
  const hexcon_relax_options wrong[] = {{.max_rounds = -1}, {.passes = -1}, {.mean_passes = -1},
                                        {.threads = -1},    {.budget = -1}, {.budget = NAN}};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    assert_int_equal(try_relax(context, &b, &wrong[i]), HEXCON_BAD_ARGUMENT);
    assert_elements(context, NULL, 0);
  }
  b.of_point[3] = (int32_t)b.sliding.carrier_count;
  b.of_point[5] = -3;
  assert_int_equal(try_relax(context, &b, NULL), HEXCON_INDEX_OUT_OF_RANGE);
  assert_elements(context, (int32_t[]){3, 5}, 2);
  b.of_point[3] = b.of_point[5] = HEXCON_FREE;
  hexcon_carrier bad[] = {
      {.kind = -1},
      {.kind = HEXCON_CARRIER_COUNT},
      {.kind = HEXCON_CARRIER_POINT, .origin = {NAN, 0, 0}},
      {.kind = HEXCON_CARRIER_LINE},
      {.kind = HEXCON_CARRIER_PLANE, .axis = {INFINITY, 0, 0}},
      {.kind = HEXCON_CARRIER_CIRCLE, .axis = {1, 0, 0}},
      {.kind = HEXCON_CARRIER_LINE, .axis = {1, 0, 0}, .sizes = {-1, 0}},
      {.kind = HEXCON_CARRIER_CIRCLE, .axis = {1, 0, 0}, .sizes = {1, NAN}},
      {.kind = HEXCON_CARRIER_CIRCLE, .axis = {1, 0, 0}, .sizes = {1, 1}},
      {.kind = HEXCON_CARRIER_SPHERE, .sizes = {-1, 0}},
      {.kind = HEXCON_CARRIER_CONE, .axis = {1, 0, 0}, .sizes = {1.6, 0}},
      {.kind = HEXCON_CARRIER_ELLIPSE, .axis = {1, 0, 0}, .across = {-2, 0, 0}, .sizes = {1, 1}},
      {.kind = HEXCON_CARRIER_TORUS, .axis = {1, 0, 0}, .sizes = {1, 0}},
      {.kind = HEXCON_CARRIER_TORUS, .axis = {1, 0, 0}, .sizes = {1, 1.1}}};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    b.pieces[4] = bad[i];
    assert_int_equal(try_relax(context, &b, NULL), HEXCON_BAD_ARGUMENT);
    assert_elements(context, (int32_t[]){4}, 1);
  }
  b.pieces[4] = b.pieces[3];
  b.pieces[1] = b.pieces[2];
  b.starts[2] = 1; /* a carrier without pieces */
  assert_int_equal(try_relax(context, &b, NULL), HEXCON_BAD_ARGUMENT);
  assert_elements(context, (int32_t[]){1}, 1);
  body_free(&b);
  hexcon_context_free(context);
}

/** Curves and surfaces in one carrier. */
static void pieces_of_several_kinds(void **state) {
  (void)state;
  hexcon_context *context = hexcon_context_new();
  const int32_t starts[2] = {0, 2}, of_point = 0;
  const hexcon_carrier pieces[2] = {{.kind = HEXCON_CARRIER_PLANE, .axis = {1, 0, 0}},
                                    {.kind = HEXCON_CARRIER_LINE, .axis = {1, 0, 0}}};
  const hexcon_sliding sliding = {
      .carrier_of_point = &of_point, .carrier_count = 1, .starts = starts, .pieces = pieces};
  double p[3] = {1, 1, 1};
  assert_int_equal(hexcon_project_points(context, p, 1, &sliding, p, NULL), HEXCON_BAD_ARGUMENT);
  assert_elements(context, (int32_t[]){0}, 1);
  hexcon_context_free(context);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(places_are_nearest),
      cmocka_unit_test(ends_are_kept),
      cmocka_unit_test(where_all_places_are_near),
      cmocka_unit_test(scrambled_bodies_are_repaired),
      cmocka_unit_test(never_worse),
      cmocka_unit_test(hopeless_bodies),
      cmocka_unit_test(flat_layers_open),
      cmocka_unit_test(numbering_does_not_matter),
      cmocka_unit_test(others_project),
      cmocka_unit_test(faults_of_others),
      cmocka_unit_test(faults),
      cmocka_unit_test(pieces_of_several_kinds),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
