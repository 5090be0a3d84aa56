/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "fuzz_call.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"
#include "verify/jacobian_sign.h"

enum {
  MOST_DAMAGES = 24,
  MOST_POINTS = 160, /* room for what damages add */
  MOST_QUADS = 128,
  MOST_HEXES = 48,
  MOST_REPORTS = 50, /* a call that reports more often is cancelled */
  MOST_MESHING_REPORTS = 12,
  MOST_BYTES = 1 << 24
};

/* -------------------------------------------------------------------------------------- bytes */

typedef struct bytes {
  const uint8_t *at, *end;
} bytes;

static uint8_t take(bytes *b) {
  return b->at < b->end ? *b->at++ : 0;
}

static size_t take_below(bytes *b, size_t count) {
  return count ? take(b) % count : 0;
}

/** Numbers at which arithmetic breaks, and small ones. */
static double take_coordinate(bytes *b) {
  static const double strange[] = {
      NAN,  INFINITY, -INFINITY, DBL_MAX, -DBL_MAX,  1e200,  -1e160,  1e100,  -1e100,  1e77,
      1e30, 1e15,     1e-15,     1e-77,   1e-160,    1e-300, DBL_MIN, 5e-324, -5e-324, -0.0,
      0.0,  1.0,      2.0,       0.5,     1 + 1e-15, 1e9,    1e-9,    1e-6,   1e6,     -1.0};
  const size_t count = sizeof strange / sizeof *strange;
  uint8_t byte = take(b);
  return byte < count ? strange[byte] : ((double)byte - 128) / 32;
}

static double take_scale(bytes *b) {
  static const double scales[] = {0,     5e-324, 1e-300, 1e-160, 1e-100, 1e-77, 1e-30, 1e-9,
                                  1e-3,  -1,     1e3,    1e9,    1e30,   1e77,  1e99,  1e100,
                                  1e103, 1e154,  1e160,  1e200,  1e300,  1e308};
  return scales[take_below(b, sizeof scales / sizeof *scales)];
}

/** Mostly a point that exists. */
static int32_t take_id(bytes *b, size_t point_count) {
  static const int32_t strange[] = {-1, INT32_MIN, INT32_MAX, INT32_MAX - 1, 1 << 30, 1 << 20};
  const size_t count = sizeof strange / sizeof *strange;
  uint8_t byte = take(b);
  if (byte >= 255 - count)
    return byte == 255 ? (int32_t)point_count : strange[254 - byte];
  return point_count ? (int32_t)(byte % point_count) : byte;
}

static int take_int(bytes *b) {
  static const int strange[] = {-1, INT32_MAX, INT32_MIN, 1000000};
  uint8_t byte = take(b);
  return byte >= 252 ? strange[byte - 252] : byte % 4;
}

/** For fractions and seconds; mostly 0, the default. */
static double take_option(bytes *b) {
  static const double values[] = {0.3, 1, 1e-6, -0.5, 1.5, NAN, INFINITY, 5e-324};
  uint8_t byte = take(b);
  return byte < 128 ? 0 : values[byte % 8];
}

/* -------------------------------------------------------------------------------------- seeds */

static test_mesh make_seed(size_t number) {
  switch (number) {
  case 0:
    return make_box(1, 1, 1);
  case 1:
    return make_box(2, 1, 1);
  case 2:
    return make_box(2, 2, 2);
  case 3:
    return make_box(3, 2, 1);
  case 4:
    return make_pentagonal_prism(1);
  case 5:
    return make_pentagonal_prism(2);
  case 6:
    return make_tube(4, 1);
  case 7:
    return make_torus(3, 4);
  case 8:
    return make_torus(3, 3);
  case 9:
    return make_cells(2, 2, 2, "###.###.");
  case 10:
    return make_cells(2, 2, 2, "#####...");
  case 11:
    return make_schneiders_pyramid();
  case 12:
    return make_trapezohedron();
  case 13: /* two bodies, and two that meet in an edge, a vertex */
    return make_cells(3, 1, 1, "#.#");
  case 14:
    return make_cells(2, 2, 1, "#..#");
  case 15:
    return make_cells(2, 2, 2, "#......#");
  case 16: /* a cavity */
    return make_cells(3, 3, 3, "#############.#############");
  default:
    return make_cells(3, 3, 1, "####.####");
  }
}
enum { SEED_COUNT = 18 };

/* ------------------------------------------------------------------------------------ the call */

/** Arrays with room for damages; the call gets copies that end where they end. */
typedef struct input {
  size_t point_count, quad_count, hex_count;
  double points[3 * MOST_POINTS], goal[3 * MOST_POINTS];
  int32_t quads[4 * MOST_QUADS], hexes[8 * MOST_HEXES];
  uint8_t fixed[MOST_POINTS];
} input;

static void must(int holds, const char *what) {
  if (!holds) {
    (void)fprintf(stderr, "fuzz_call: %s\n", what);
    abort();
  }
}

static void fill_input(size_t seed, bool surface_only, input *in) {
  test_mesh mesh = make_seed(seed);
  memset(in, 0, sizeof *in);
  in->point_count = surface_only ? mesh.surface_point_count : mesh.point_count;
  in->quad_count = mesh.quad_count;
  in->hex_count = mesh.hex_count;
  must(in->point_count <= MOST_POINTS && in->quad_count <= MOST_QUADS &&
           in->hex_count <= MOST_HEXES,
       "a seed is too large");
  memcpy(in->points, mesh.points, 3 * in->point_count * sizeof *in->points);
  memcpy(in->goal, mesh.points, 3 * in->point_count * sizeof *in->goal);
  memcpy(in->quads, mesh.quads, 4 * in->quad_count * sizeof *in->quads);
  if (in->hex_count)
    memcpy(in->hexes, mesh.hexes, 8 * in->hex_count * sizeof *in->hexes);
  memset(in->fixed, 1, mesh.surface_point_count);
  test_mesh_free(&mesh);
}

/* ------------------------------------------------------------------------------------- damages */

static void rename_point(input *in, int32_t from, int32_t to) {
  for (size_t i = 0; i < 4 * in->quad_count; i++)
    in->quads[i] = in->quads[i] == from ? to : in->quads[i];
  for (size_t i = 0; i < 8 * in->hex_count; i++)
    in->hexes[i] = in->hexes[i] == from ? to : in->hexes[i];
}

static void damage_quads(input *in, bytes *b) {
  size_t q = take_below(b, in->quad_count), other = take_below(b, in->quad_count);
  int32_t *quad = in->quads + 4 * q;
  test_mesh all = {.quad_count = in->quad_count, .quads = in->quads},
            one = {.quad_count = 1, .quads = quad};
  if (in->quad_count == 0)
    return;
  switch (take(b) % 7) {
  case 0:
    quad[take(b) % 4] = take_id(b, in->point_count);
    break;
  case 1: /* twice, at the end */
    if (in->quad_count < MOST_QUADS)
      memcpy(in->quads + 4 * in->quad_count++, quad, 4 * sizeof *quad);
    break;
  case 2:
    in->quad_count--;
    memmove(quad, in->quads + 4 * in->quad_count, 4 * sizeof *quad);
    break;
  case 3:
    turn_quads(&one);
    break;
  case 4:
    turn_quads(&all);
    break;
  case 5:
    memmove(quad, in->quads + 4 * other, 4 * sizeof *quad);
    break;
  default:
    in->quad_count = 0;
  }
}

static void damage_hexes(input *in, bytes *b) {
  size_t h = take_below(b, in->hex_count), other = take_below(b, in->hex_count);
  int32_t *hex = in->hexes + 8 * h;
  if (in->hex_count == 0)
    return;
  switch (take(b) % 7) {
  case 0:
    hex[take(b) % 8] = take_id(b, in->point_count);
    break;
  case 1: /* twice, at the end */
    if (in->hex_count < MOST_HEXES)
      memcpy(in->hexes + 8 * in->hex_count++, hex, 8 * sizeof *hex);
    break;
  case 2:
    in->hex_count--;
    memmove(hex, in->hexes + 8 * in->hex_count, 8 * sizeof *hex);
    break;
  case 3: { /* faces that repeat, inside out */
    size_t c = take(b) % 8, d = take(b) % 8;
    int32_t id = hex[c];
    hex[c] = hex[d];
    hex[d] = id;
    break;
  }
  case 4:
    for (size_t c = 0; c < 8; c++)
      hex[c] = take_id(b, in->point_count);
    break;
  case 5: /* a second one on the same points, turned */
    for (size_t c = 0; c < 8; c++)
      in->hexes[8 * other + c] = hex[(c & 4) | ((c + 1) & 3)];
    break;
  default:
    in->hex_count = 0;
  }
}

/** Points that nothing uses, points that are gone. */
static void damage_counts(input *in, bytes *b) {
  switch (take(b) % 4) {
  case 0:
    for (size_t i = 1 + take(b) % 4; i > 0 && in->point_count < MOST_POINTS; i--) {
      for (size_t k = 3 * in->point_count; k < 3 * in->point_count + 3; k++)
        in->goal[k] = in->points[k] = take_coordinate(b);
      in->fixed[in->point_count++] = take(b) & 1;
    }
    break;
  case 1:
    in->point_count -= in->point_count > 0;
    break;
  case 2: /* an unused point before the used ones */
    if (in->point_count < MOST_POINTS) {
      rename_point(in, 0, (int32_t)in->point_count);
      memcpy(in->points + 3 * in->point_count, in->points, 3 * sizeof *in->points);
      memcpy(in->goal + 3 * in->point_count, in->goal, 3 * sizeof *in->goal);
      in->fixed[in->point_count++] = in->fixed[0];
      in->fixed[0] = take(b) & 1;
    }
    break;
  default:
    in->point_count = 0;
  }
}

static void damage_points(input *in, bytes *b) {
  double *array = take(b) & 1 ? in->goal : in->points, factor;
  size_t v = take_below(b, in->point_count), other = take_below(b, in->point_count), k;
  switch (take(b) % 5) {
  case 0:
    array[3 * v + take(b) % 3] = take_coordinate(b);
    break;
  case 1:
    memmove(array + 3 * v, array + 3 * other, 3 * sizeof *array);
    break;
  case 2:
    factor = take_scale(b);
    for (size_t i = 0; i < 3 * in->point_count; i++)
      array[i] *= factor;
    break;
  case 3:
    k = take(b) % 3;
    factor = take_scale(b);
    for (size_t i = 0; i < in->point_count; i++)
      array[3 * i + k] *= factor;
    break;
  default:
    for (k = 0; k < 3; k++)
      array[3 * v + k] += ((double)take(b) - 128) / 128;
  }
}

static void damage_ids(input *in, bytes *b) {
  int32_t a = (int32_t)take_below(b, in->point_count), c = (int32_t)take_below(b, in->point_count);
  if (take(b) & 1) { /* torn */
    rename_point(in, a, INT32_MAX);
    rename_point(in, c, a);
    rename_point(in, INT32_MAX, c);
  } else {
    rename_point(in, a, c);
  }
}

static void damage_fixed(input *in, bytes *b) {
  uint8_t what = take(b) % 4;
  if (what < 2)
    memset(in->fixed, what, sizeof in->fixed);
  else
    in->fixed[take_below(b, in->point_count)] ^= 1;
}

static void damage(input *in, bytes *b) {
  static void (*const damages[])(input *, bytes *) = {damage_quads,  damage_hexes, damage_counts,
                                                      damage_points, damage_ids,   damage_fixed};
  for (int i = 0; i < MOST_DAMAGES && b->at < b->end; i++)
    damages[take(b) % (sizeof damages / sizeof *damages)](in, b);
}

/* -------------------------------------------------------------------------------------- calls */

typedef struct call {
  hexcon_context *context;
  input in; /* as it is, for comparison */
  /* exact copies */
  double *points, *goal, *positions;
  int32_t *quads, *hexes;
  uint8_t *fixed;
  size_t reports, most_reports, cancel_at;
  bytes options;
  int mesher;           /* what the tetrahedraliser does */
  double new_points[3]; /* of the tetrahedraliser */
  int32_t *tetrahedra;
} call;

static bool report(void *user, const char *stage, double fraction) {
  call *c = user;
  must(stage && *stage, "a stage has no name");
  must(fraction >= 0 && fraction <= 1, "a fraction of a stage is none");
  return ++c->reports != c->cancel_at && c->reports < c->most_reports;
}

static void *exact_copy(const void *from, size_t count, size_t size) {
  void *to = malloc(count > 0 ? count * size : 1);
  must(to != NULL, "no memory for the test itself");
  if (count)
    memcpy(to, from, count * size);
  return to;
}

static void call_begin(call *c) {
  const input *in = &c->in;
  c->points = exact_copy(in->points, 3 * in->point_count, sizeof *c->points);
  c->goal = exact_copy(in->goal, 3 * in->point_count, sizeof *c->goal);
  c->positions = exact_copy(in->points, 3 * in->point_count, sizeof *c->positions);
  c->quads = exact_copy(in->quads, 4 * in->quad_count, sizeof *c->quads);
  c->hexes = exact_copy(in->hexes, 8 * in->hex_count, sizeof *c->hexes);
  c->fixed = exact_copy(in->fixed, in->point_count, 1);
}

static void call_end(call *c) {
  must(!memcmp(c->points, c->in.points, 3 * c->in.point_count * sizeof *c->points) &&
           !memcmp(c->quads, c->in.quads, 4 * c->in.quad_count * sizeof *c->quads) &&
           !memcmp(c->hexes, c->in.hexes, 8 * c->in.hex_count * sizeof *c->hexes),
       "the caller's arrays were written to");
  free(c->points);
  free(c->goal);
  free(c->positions);
  free(c->quads);
  free(c->hexes);
  free(c->fixed);
  free(c->tetrahedra);
}

static hexcon_status call_check(call *c) {
  hexcon_surface_report facts;
  hexcon_status status = hexcon_check_surface(c->context, c->points, c->in.point_count, c->quads,
                                              c->in.quad_count, &facts);
  if (!status)
    must(facts.euler == 2 * (int64_t)facts.component_count - 2 * facts.genus && facts.volume >= 0,
         "the facts of a surface do not fit together");
  return status;
}

static hexcon_status call_loops(call *c) {
  hexcon_loops loops;
  hexcon_status status = hexcon_surface_loops(c->context, c->quads, c->in.quad_count, &loops);
  if (!status) {
    must(loops.offsets[loops.count] == 2 * c->in.quad_count, "loops miss quads");
    hexcon_loops_free(c->context, &loops);
  }
  return status;
}

static hexcon_status call_colouring(call *c) {
  uint8_t *colours = exact_copy(c->in.fixed, c->in.point_count, 1);
  hexcon_status status =
      hexcon_surface_colouring(c->context, c->quads, c->in.quad_count, c->in.point_count, colours);
  for (size_t i = 0; !status && i < 4 * c->in.quad_count; i++)
    must(colours[c->quads[i]] != colours[c->quads[i ^ 1]], "an edge has one colour");
  free(colours);
  return status;
}

static hexcon_status call_pairing(call *c) {
  size_t most = c->in.quad_count / 2, count = most;
  int32_t *pairs = exact_copy(c->in.quads, 2 * most, sizeof *pairs);
  uint8_t way = take(&c->options) % 3;
  hexcon_status status =
      way == 2 ? hexcon_surface_pairing_of_crossings(c->context, c->in.point_count, c->quads,
                                                     c->in.quad_count, pairs, &count)
               : hexcon_surface_pairing(c->context, way ? c->points : NULL, c->in.point_count,
                                        c->quads, c->in.quad_count, pairs);
  for (size_t i = 0; !status && i < 2 * count; i++)
    must(pairs[i] >= 0 && (size_t)pairs[i] < c->in.quad_count, "a pair names no quad");
  free(pairs);
  return status;
}

static hexcon_status call_quality(call *c) {
  double *values = malloc((c->in.hex_count + 1) * sizeof *values);
  must(values != NULL, "no memory for the test itself");
  hexcon_status status =
      hexcon_quality(c->context, c->points, c->in.point_count, c->hexes, c->in.hex_count, values);
  for (size_t h = 0; !status && h < c->in.hex_count; h++)
    must(values[h] >= -1 && values[h] <= 1 + 1e-12, "a scaled Jacobian beyond -1 .. 1");
  free(values);
  return status;
}

/** A verdict, its pairs in order, and words for all but YES. */
static void check_embedding(const hexcon_embedding *found, size_t quad_count) {
  const bool yes = found->embedded == HEXCON_EMBEDDED_YES;
  must(found->embedded < HEXCON_EMBEDDED_COUNT && yes == (*found->reason == '\0') &&
           (!yes || (found->pair_count == 0 && found->twin_count == 0)) &&
           (found->embedded != HEXCON_EMBEDDED_NO || found->pair_count > 0),
       "a verdict on places against its own facts");
  must(found->pair_count <= HEXCON_MAX_EMBEDDING_PAIRS, "too many pairs");
  for (size_t i = 0; i < found->pair_count; i++) {
    const int32_t *pair = found->pairs + 2 * i;
    must(pair[0] >= 0 && pair[0] <= pair[1] && (size_t)pair[1] < quad_count,
         "a pair that crosses names no quads");
    must(i == 0 || pair[-2] < pair[0] || (pair[-2] == pair[0] && pair[-1] < pair[1]),
         "pairs that cross are not ascending");
  }
}

static hexcon_status call_embedding(call *c) {
  hexcon_embedding found;
  hexcon_status status = hexcon_surface_embedding(c->context, c->points, c->in.point_count,
                                                  c->quads, c->in.quad_count, &found);
  if (status)
    return status;
  check_embedding(&found, c->in.quad_count);
  hexcon_embedding_free(c->context, &found);
  return status;
}

static hexcon_status call_certify(call *c) {
  hexcon_certificate found;
  hexcon_status status = hexcon_certify(c->context, c->points, c->in.point_count, c->hexes,
                                        c->in.hex_count, c->quads, c->in.quad_count, &found);
  if (status)
    return status;
  must(!found.certified || (found.conforming && found.proper && found.boundary_exact &&
                            found.nonpositive_count == 0 && found.improper_count == 0 &&
                            found.embedding.embedded == HEXCON_EMBEDDED_YES),
       "certified against its own facts");
  check_embedding(&found.embedding, c->in.quad_count);
  for (size_t i = 0; i < found.nonpositive_count; i++)
    must(found.nonpositive[i] >= 0 && (size_t)found.nonpositive[i] < c->in.hex_count,
         "a certificate names no hex");
  for (size_t h = 0; found.certified && h < c->in.hex_count; h++)
    must(prove_jacobian_sign(c->points, c->hexes + 8 * h) == JACOBIAN_POSITIVE,
         "certified with a hex that is not positive");
  hexcon_certificate_free(c->context, &found);
  return status;
}

static size_t count_bad(const call *c, const double *points) {
  size_t bad = 0;
  for (size_t h = 0; h < c->in.hex_count; h++)
    bad += prove_jacobian_sign(points, c->hexes + 8 * h) != JACOBIAN_POSITIVE;
  return bad;
}

static hexcon_status call_optimize(call *c) {
  const hexcon_optimize_options options = {.max_rounds = take_int(&c->options),
                                           .threads = take_int(&c->options),
                                           .target = take_option(&c->options),
                                           .mean_passes = take_int(&c->options)};
  hexcon_status status =
      hexcon_optimize(c->context, c->points, c->in.point_count, c->hexes, c->in.hex_count, c->fixed,
                      options.threads == 0 ? NULL : &options, c->positions);
  if (!status || status == HEXCON_CANCELLED)
    must(count_bad(c, c->positions) <= count_bad(c, c->points), "optimised for the worse");
  for (size_t v = 0; v < c->in.point_count; v++)
    must(!c->fixed[v] || !memcmp(c->positions + 3 * v, c->points + 3 * v, 3 * sizeof(double)),
         "a fixed point has moved");
  return status;
}

static hexcon_status call_morph(call *c) {
  const hexcon_morph_options options = {.boundary_only = take(&c->options) & 1,
                                        .target = take_option(&c->options)};
  double reached = -1;
  hexcon_status status =
      hexcon_morph(c->context, c->points, c->in.point_count, c->hexes, c->in.hex_count, c->fixed,
                   c->goal, &options, c->positions, &reached);
  must(reached >= 0 && reached <= 1, "morph went nowhere and beyond");
  if (!status || status == HEXCON_CANCELLED)
    must(count_bad(c, c->positions) == 0 || count_bad(c, c->points) > 0, "a state is not valid");
  for (size_t v = 0; !status && reached >= 1 && v < c->in.point_count; v++)
    must(!c->fixed[v] || !memcmp(c->positions + 3 * v, c->goal + 3 * v, 3 * sizeof(double)),
         "a fixed point is not at its goal");
  return status;
}

static hexcon_status call_raise_order(call *c) {
  hexcon_second_order raised;
  hexcon_status status = hexcon_raise_order(c->context, c->points, c->in.point_count, c->hexes,
                                            c->in.hex_count, &raised);
  if (status)
    return status;
  for (size_t i = 0; i < 20 * c->in.hex_count; i++)
    must(raised.hexes[i] >= 0 && (size_t)raised.hexes[i] < raised.point_count,
         "a hex of order 2 names no point");
  hexcon_certificate certificate;
  status = hexcon_certify_second_order(c->context, raised.points, raised.point_count, raised.hexes,
                                       c->in.hex_count, c->quads, c->in.quad_count, &certificate);
  must(!status || !certificate.nonpositive, "a certificate after an error");
  for (size_t i = 0; !status && i < certificate.nonpositive_count; i++)
    must((size_t)certificate.nonpositive[i] < c->in.hex_count, "no such hex is not positive");
  hexcon_certificate_free(c->context, &certificate);
  hexcon_second_order_free(c->context, &raised);
  return status;
}

/** A star about the mean of the points, or what nobody should hand out. */
static bool tetrahedralise(void *user, const double *points, size_t point_count,
                           const int32_t *triangles, size_t triangle_count,
                           hexcon_tetrahedra *out) {
  call *c = user;
  free(c->tetrahedra);
  c->tetrahedra = malloc((4 * triangle_count + 4) * sizeof *c->tetrahedra);
  must(c->tetrahedra != NULL, "no memory for the test itself");
  memset(c->new_points, 0, sizeof c->new_points);
  for (size_t i = 0; i < 3 * point_count; i++)
    c->new_points[i % 3] += points[i] / (double)point_count;
  for (size_t t = 0; t < triangle_count; t++) {
    const int32_t *from = triangles + 3 * t;
    int32_t to[4] = {from[0], from[2], from[1], (int32_t)point_count};
    memcpy(c->tetrahedra + 4 * t, to, sizeof to);
  }
  *out = (hexcon_tetrahedra){1, c->new_points, triangle_count, c->tetrahedra};
  switch (c->mesher) {
  case 2:
    *out = (hexcon_tetrahedra){0, NULL, 0, NULL};
    break;
  case 3:
    c->tetrahedra[take_below(&c->options, 4 * triangle_count)] = take_id(&c->options, point_count);
    break;
  case 4:
    c->new_points[0] = take_coordinate(&c->options);
    break;
  case 5:
    out->point_count = SIZE_MAX;
    break;
  case 6:
    out->tetrahedron_count = SIZE_MAX / 2;
    break;
  case 7:
    return false;
  default:
    break;
  }
  return true;
}

static void check_mesh(call *c, const hexcon_mesh *mesh, const hexcon_mesh_options *options) {
  size_t points = hexcon_mesh_point_count(mesh), hexes = hexcon_mesh_hex_count(mesh),
         nodes = hexcon_mesh_order(mesh) == 2 ? 20 : 8;
  must(points >= c->in.point_count &&
           !memcmp(hexcon_mesh_points(mesh), c->points, 3 * c->in.point_count * sizeof(double)),
       "a mesh does not begin with the points of its surface");
  for (size_t i = 0; i < nodes * hexes; i++)
    must(hexcon_mesh_hexes(mesh)[i] >= 0 && (size_t)hexcon_mesh_hexes(mesh)[i] < points,
         "a hex names no point");
  must(options->skip_certificate || options->allow_uncertified ||
           hexcon_mesh_is_topological(mesh) || hexcon_mesh_certificate(mesh)->certified,
       "a mesh is not certified, and nobody allowed that");
}

static hexcon_status call_mesh(call *c) {
  bytes *o = &c->options;
  uint8_t flags = take(o);
  c->mesher = take(o) % 8;
  int32_t pairs[4] = {0, 1, 2, 3};
  hexcon_mesh_options options = {
      .method = (hexcon_method)(take(o) % (HEXCON_METHOD_COUNT + 1)),
      .order = flags & 1        ? 2
               : take(o) == 255 ? -1
                                : 1,
      .allow_uncertified = flags & 2,
      .threads = flags & 64 ? 2 : 1,
      .layers = flags & 4 ? take_int(o) : 0,
      .tetrahedralise = c->mesher ? tetrahedralise : NULL,
      .tetrahedralise_user = c,
      .pairing = (hexcon_pairing)(flags & 8 ? take(o) % (HEXCON_PAIRING_COUNT + 1) : 0),
      .pairs = flags & 16 ? NULL : pairs,
      .pair_count = take(o) % 3,
      .skip_certificate = flags & 32,
      .no_core = flags & 128,
      .pillow = c->in.quad_count % 4 == 0 ? (int)(flags & 3) : 0};
  for (size_t i = 0; i < 4 && options.pairing == HEXCON_PAIRING_GIVEN; i++)
    pairs[i] = take_id(o, c->in.quad_count);
  hexcon_mesh *mesh = NULL;
  hexcon_status status = hexcon_mesh_surface(c->context, c->points, c->in.point_count, c->quads,
                                             c->in.quad_count, &options, &mesh);
  must((mesh != NULL) == (status == HEXCON_OK), "a mesh and an error, or neither");
  if (mesh)
    check_mesh(c, mesh, &options);
  hexcon_mesh_free(c->context, mesh);
  return status;
}

static hexcon_status (*const calls[])(call *) = {
    call_check,    call_loops, call_colouring,   call_pairing, call_quality,  call_certify,
    call_optimize, call_morph, call_raise_order, call_mesh,    call_embedding};
enum { CALL_COUNT = sizeof calls / sizeof *calls };

static bool is_of_hexes(size_t kind) {
  return calls[kind] == call_quality || calls[kind] == call_certify ||
         calls[kind] == call_optimize || calls[kind] == call_morph ||
         calls[kind] == call_raise_order;
}

static void check_error(const call *c, hexcon_status status) {
  const int32_t *ids;
  size_t count = hexcon_context_elements(c->context, &ids);
  must(hexcon_status_name((int)status) != NULL, "a status has no name");
  must(count <= 1000, "too many offending ids");
  must((status == HEXCON_OK) == (*hexcon_context_message(c->context) == '\0'),
       "an error without words, or words without an error");
}

void fuzz_call(const uint8_t *data, size_t size) {
  bytes b = {data, data + size};
  size_t kind = take(&b) % CALL_COUNT, seed = take(&b) % SEED_COUNT;
  test_memory memory = {.most_bytes = MOST_BYTES};
  call c = {0};
  memory.fail_at = take(&b);
  c.cancel_at = take(&b);
  c.most_reports = calls[kind] == call_mesh ? MOST_MESHING_REPORTS : MOST_REPORTS;
  c.options = (bytes){b.at, b.at + 8 < b.end ? b.at + 8 : b.end};
  b.at = c.options.end;
  fill_input(seed, !is_of_hexes(kind), &c.in);
  damage(&c.in, &b);
  call_begin(&c);
  c.context = hexcon_context_new_with(test_reallocate, &memory);
  if (c.context) {
    hexcon_context_set_progress(c.context, report, &c);
    check_error(&c, calls[kind](&c));
  }
  call_end(&c);
  hexcon_context_free(c.context);
  must(memory.live == 0, "memory is left behind");
}
