/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Tests have no use for a failed allocation of their own. */
static void *make_array(size_t count, size_t size) {
  void *memory = calloc(count ? count : 1, size);
  if (!memory)
    abort();
  return memory;
}

static void *copy_array(const void *from, size_t count, size_t size) {
  void *to = make_array(count, size);
  if (from && count)
    memcpy(to, from, count * size);
  return to;
}

/* ------------------------------------------------------------------------------------- meshes */

void test_mesh_free(test_mesh *mesh) {
  free(mesh->points);
  free(mesh->quads);
  free(mesh->hexes);
  memset(mesh, 0, sizeof *mesh);
}

test_mesh test_mesh_copy(const test_mesh *mesh) {
  test_mesh copy = *mesh;
  copy.points = copy_array(mesh->points, 3 * mesh->point_count, sizeof(double));
  copy.quads = copy_array(mesh->quads, 4 * mesh->quad_count, sizeof(int32_t));
  copy.hexes = copy_array(mesh->hexes, 8 * mesh->hex_count, sizeof(int32_t));
  return copy;
}

test_mesh make_surface(const double (*points)[3], size_t point_count, const int32_t (*quads)[4],
                       size_t quad_count) {
  test_mesh mesh = {
      .point_count = point_count, .surface_point_count = point_count, .quad_count = quad_count};
  mesh.points = copy_array(points, 3 * point_count, sizeof(double));
  mesh.quads = copy_array(quads, 4 * quad_count, sizeof(int32_t));
  mesh.hexes = make_array(0, sizeof(int32_t));
  return mesh;
}

/** A side of a hex: its corners as the hex has them, and sorted. */
typedef struct side {
  int32_t corners[4], sorted[4];
} side;

static int by_id(const void *a, const void *b) {
  int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;
  return (x > y) - (x < y);
}

static int by_corners(const void *a, const void *b) {
  const side *x = a, *y = b;
  for (int i = 0; i < 4; i++)
    if (x->sorted[i] != y->sorted[i])
      return x->sorted[i] < y->sorted[i] ? -1 : 1;
  return 0;
}

/** Outward sides of a hex whose corner i lies at bit pattern 0, 1, 3, 2, 4, 5, 7, 6. */
static const int outward[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                  {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}};

/** Quads: the sides that occur once. */
static void extract_boundary(test_mesh *mesh) {
  size_t count = 6 * mesh->hex_count;
  side *sides = make_array(count, sizeof *sides);
  for (size_t i = 0; i < count; i++) {
    for (int c = 0; c < 4; c++)
      sides[i].corners[c] = mesh->hexes[8 * (i / 6) + (size_t)outward[i % 6][c]];
    memcpy(sides[i].sorted, sides[i].corners, sizeof sides[i].sorted);
    qsort(sides[i].sorted, 4, sizeof(int32_t), by_id);
  }
  qsort(sides, count, sizeof *sides, by_corners);
  mesh->quads = make_array(4 * count, sizeof(int32_t));
  for (size_t i = 0; i < count;) {
    size_t next = i + 1;
    while (next < count && by_corners(&sides[i], &sides[next]) == 0)
      next++;
    if (next == i + 1)
      memcpy(mesh->quads + 4 * mesh->quad_count++, sides[i].corners, sizeof sides[i].corners);
    i = next;
  }
  free(sides);
}

static void renumber(int32_t *ids, size_t count, const int32_t *numbers) {
  for (size_t i = 0; i < count; i++)
    ids[i] = numbers[ids[i]];
}

/** Number the used points afresh, those in `ids` before others; returns the next number. */
static int32_t number_points(const int32_t *ids, size_t count, int32_t *numbers, int32_t next) {
  for (size_t i = 0; i < count; i++)
    if (numbers[ids[i]] < 0)
      numbers[ids[i]] = next++;
  return next;
}

/** Boundary, and points renumbered with those of the boundary first and unused ones dropped. */
static void finish_mesh(test_mesh *mesh) {
  extract_boundary(mesh);
  int32_t *numbers = make_array(mesh->point_count, sizeof *numbers);
  memset(numbers, -1, mesh->point_count * sizeof *numbers);
  int32_t next = number_points(mesh->quads, 4 * mesh->quad_count, numbers, 0);
  mesh->surface_point_count = (size_t)next;
  next = number_points(mesh->hexes, 8 * mesh->hex_count, numbers, next);
  double *points = make_array(3 * (size_t)next, sizeof *points);
  for (size_t v = 0; v < mesh->point_count; v++)
    if (numbers[v] >= 0)
      memcpy(points + 3 * numbers[v], mesh->points + 3 * v, 3 * sizeof *points);
  renumber(mesh->quads, 4 * mesh->quad_count, numbers);
  renumber(mesh->hexes, 8 * mesh->hex_count, numbers);
  free(numbers);
  free(mesh->points);
  mesh->points = points;
  mesh->point_count = (size_t)next;
}

test_mesh make_cells(int nx, int ny, int nz, const char *cells) {
  static const int offsets[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  test_mesh mesh = {.point_count = (size_t)((nx + 1) * (ny + 1) * (nz + 1))};
  mesh.points = make_array(3 * mesh.point_count, sizeof(double));
  mesh.hexes = make_array((size_t)(8 * nx * ny * nz), sizeof(int32_t));
  for (int v = 0; v < (int)mesh.point_count; v++) {
    mesh.points[3 * v] = v % (nx + 1);
    mesh.points[3 * v + 1] = v / (nx + 1) % (ny + 1);
    mesh.points[3 * v + 2] = v / (nx + 1) / (ny + 1);
  }
  for (int cell = 0; cell < nx * ny * nz; cell++) {
    if (cells && cells[cell] != '#')
      continue;
    int x = cell % nx, y = cell / nx % ny, z = cell / nx / ny;
    for (int c = 0; c < 8; c++)
      mesh.hexes[8 * mesh.hex_count + (size_t)c] =
          x + offsets[c][0] + (nx + 1) * (y + offsets[c][1] + (ny + 1) * (z + offsets[c][2]));
    mesh.hex_count++;
  }
  finish_mesh(&mesh);
  return mesh;
}

test_mesh make_box(int nx, int ny, int nz) {
  return make_cells(nx, ny, nz, NULL);
}

test_mesh make_prism(const double (*cap_points)[2], size_t cap_point_count,
                     const int32_t (*cap_quads)[4], size_t cap_quad_count, int rings) {
  size_t levels = (size_t)rings;
  test_mesh mesh = {.point_count = cap_point_count * (levels + 1),
                    .hex_count = cap_quad_count * levels};
  mesh.points = make_array(3 * mesh.point_count, sizeof(double));
  mesh.hexes = make_array(8 * mesh.hex_count, sizeof(int32_t));
  for (size_t i = 0; i < mesh.point_count; i++) {
    memcpy(mesh.points + 3 * i, cap_points[i % cap_point_count], 2 * sizeof(double));
    mesh.points[3 * i + 2] = (double)(i / cap_point_count);
  }
  for (size_t h = 0; h < mesh.hex_count; h++)
    for (size_t c = 0; c < 8; c++) {
      size_t level = h / cap_quad_count + c / 4;
      mesh.hexes[8 * h + c] =
          cap_quads[h % cap_quad_count][c % 4] + (int32_t)(level * cap_point_count);
    }
  finish_mesh(&mesh);
  return mesh;
}

test_mesh make_pentagonal_prism(int rings) {
  double points[11][2] = {{0}};
  int32_t quads[5][4];
  for (int i = 0; i < 5; i++) {
    double angle = 2 * 3.14159265358979 * i / 5, middle = angle + 3.14159265358979 / 5;
    points[1 + 2 * i][0] = cos(angle);
    points[1 + 2 * i][1] = sin(angle);
    points[2 + 2 * i][0] = 0.809016994374947 * cos(middle);
    points[2 + 2 * i][1] = 0.809016994374947 * sin(middle);
    int32_t quad[4] = {0, 2 * ((i + 4) % 5) + 2, 2 * i + 1, 2 * i + 2};
    memcpy(quads[i], quad, sizeof quad);
  }
  return make_prism((const double(*)[2])points, 11, (const int32_t(*)[4])quads, 5, rings);
}

test_mesh make_tube(int sectors, int rings) {
  size_t n = (size_t)sectors;
  double(*points)[2] = make_array(2 * n, sizeof *points);
  int32_t(*quads)[4] = make_array(n, sizeof *quads);
  for (int i = 0; i < sectors; i++) {
    double angle = 2 * 3.14159265358979 * i / sectors;
    points[i][0] = cos(angle);
    points[i][1] = sin(angle);
    points[sectors + i][0] = 2 * cos(angle);
    points[sectors + i][1] = 2 * sin(angle);
    int32_t next = (i + 1) % sectors;
    int32_t quad[4] = {i, sectors + i, sectors + next, next};
    memcpy(quads[i], quad, sizeof quad);
  }
  test_mesh mesh =
      make_prism((const double(*)[2])points, 2 * n, (const int32_t(*)[4])quads, n, rings);
  free(points);
  free(quads);
  return mesh;
}

test_mesh make_torus(int m, int n) {
  size_t count = (size_t)(m * n);
  double(*points)[3] = make_array(count, sizeof *points);
  int32_t(*quads)[4] = make_array(count, sizeof *quads);
  for (int i = 0; i < m; i++)
    for (int j = 0; j < n; j++) {
      double u = 2 * 3.14159265358979 * i / m, v = 2 * 3.14159265358979 * j / n;
      double *point = points[i * n + j];
      point[0] = (3 + cos(v)) * cos(u);
      point[1] = (3 + cos(v)) * sin(u);
      point[2] = sin(v);
      int32_t next_i = (i + 1) % m, next_j = (j + 1) % n;
      int32_t quad[4] = {i * n + j, next_i * n + j, next_i * n + next_j, i * n + next_j};
      memcpy(quads[i * n + j], quad, sizeof quad);
    }
  test_mesh mesh =
      make_surface((const double(*)[3])points, count, (const int32_t(*)[4])quads, count);
  free(points);
  free(quads);
  return mesh;
}

test_mesh make_schneiders_pyramid(void) {
  /* 0 .. 3 base, 4 apex; 5 .. 8 base edges, 9 .. 12 others; 13 base, 14 .. 17 triangles */
  double points[18][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1.4}};
  int32_t quads[16][4];
  for (int i = 0; i < 4; i++) {
    int next = (i + 1) % 4, before = (i + 3) % 4;
    for (int k = 0; k < 3; k++) {
      points[5 + i][k] = (points[i][k] + points[next][k]) / 2;
      points[9 + i][k] = (points[i][k] + points[4][k]) / 2;
      points[14 + i][k] = (points[i][k] + points[next][k] + points[4][k]) / 3;
    }
    int32_t made[4][4] = {{i, 5 + before, 13, 5 + i},
                          {i, 5 + i, 14 + i, 9 + i},
                          {next, 9 + next, 14 + i, 5 + i},
                          {4, 9 + i, 14 + i, 9 + next}};
    memcpy(quads[4 * i], made, sizeof made);
  }
  return make_surface((const double(*)[3])points, 18, (const int32_t(*)[4])quads, 16);
}

test_mesh make_trapezohedron(void) {
  /* a flat zigzag of 8 points; kites are planar for apices this high: h = z (1 + c) / (1 - c) */
  const double c = cos(3.14159265358979 / 4), z = 0.2;
  double points[10][3];
  int32_t quads[8][4];
  for (int i = 0; i < 8; i++) {
    points[i][0] = cos(2 * 3.14159265358979 * i / 8);
    points[i][1] = sin(2 * 3.14159265358979 * i / 8);
    points[i][2] = i % 2 ? -z : z;
  }
  for (int i = 0; i < 2; i++) {
    points[8 + i][0] = points[8 + i][1] = 0;
    points[8 + i][2] = (i ? -1 : 1) * z * (1 + c) / (1 - c);
  }
  for (int i = 0; i < 8; i++) {
    int32_t top[4] = {8, i, (i + 1) % 8, (i + 2) % 8};
    int32_t bottom[4] = {9, (i + 2) % 8, (i + 1) % 8, i};
    memcpy(quads[i], i % 2 ? bottom : top, sizeof top);
  }
  return make_surface((const double(*)[3])points, 10, (const int32_t(*)[4])quads, 8);
}

void turn_quads(test_mesh *mesh) {
  for (size_t q = 0; q < mesh->quad_count; q++) {
    int32_t corner = mesh->quads[4 * q + 1];
    mesh->quads[4 * q + 1] = mesh->quads[4 * q + 3];
    mesh->quads[4 * q + 3] = corner;
  }
}

bool has_edge(const test_mesh *mesh, int32_t a, int32_t b) {
  for (size_t h = 0; h < 4 * mesh->quad_count; h++) {
    int32_t x = mesh->quads[h], y = mesh->quads[(h & ~(size_t)3) | ((h + 1) & 3)];
    if ((x == a && y == b) || (x == b && y == a))
      return true;
  }
  return false;
}

/* ------------------------------------------------------------------------------------- memory */

/** Every block starts with its size. */
enum { HEADER = 16 };

void *test_reallocate(void *user, void *memory, size_t size) {
  test_memory *counts = user;
  char *block = memory ? (char *)memory - HEADER : NULL;
  size_t before = 0;
  if (block)
    memcpy(&before, block, sizeof before);
  if (size == 0) {
    counts->live -= block != NULL;
    counts->live_bytes -= before;
    free(block);
    return NULL;
  }
  if (++counts->calls == counts->fail_at)
    return NULL;
  if (counts->most_bytes &&
      (size > counts->most_bytes || counts->live_bytes - before + size > counts->most_bytes))
    return NULL;
  char *grown = malloc(size + HEADER); /* never in place: stale pointers show under ASan */
  if (!grown)
    return NULL;
  memcpy(grown, &size, sizeof size);
  if (block)
    memcpy(grown + HEADER, memory, before < size ? before : size);
  else
    counts->live++;
  free(block);
  counts->live_bytes += size - before;
  return grown + HEADER;
}

/* ------------------------------------------------------------------------------------- random */

bool lose_patience(void *user, const char *stage, double fraction) {
  test_patience *p = user;
  assert_true(stage && stage[0] && fraction >= 0 && fraction <= 1);
  return ++p->calls != p->cancel_at;
}

uint64_t random_bits(uint64_t *state) {
  uint64_t x = *state += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

size_t random_below(uint64_t *state, size_t count) {
  return (size_t)(random_bits(state) % count);
}

double random_between(uint64_t *state, double low, double high) {
  return low + (high - low) * ((double)(random_bits(state) >> 11) / 9007199254740992.0);
}

/* ---------------------------------------------------------------------------------- assertions */

void assert_close(double a, double b, double tolerance) {
  if (!(fabs(a - b) <= tolerance))
    fail_msg("%.17g is not %.17g", a, b);
}

void assert_message(const hexcon_context *context) {
  assert_true(hexcon_context_message(context)[0] != '\0');
}

void assert_elements(const hexcon_context *context, const int32_t *expected, size_t count) {
  const int32_t *elements;
  assert_message(context);
  assert_int_equal(hexcon_context_elements(context, &elements), count);
  int32_t *found = copy_array(elements, count, sizeof *found);
  int32_t *wanted = copy_array(expected, count, sizeof *wanted);
  qsort(found, count, sizeof *found, by_id);
  qsort(wanted, count, sizeof *wanted, by_id);
  assert_memory_equal(found, wanted, count * sizeof *found);
  free(found);
  free(wanted);
}

void assert_certified_mesh(hexcon_context *context, const test_mesh *surface,
                           const hexcon_mesh *mesh) {
  hexcon_certificate certificate;
  assert_non_null(mesh);
  assert_true(hexcon_mesh_certificate(mesh)->certified);
  assert_memory_equal(hexcon_mesh_points(mesh), surface->points,
                      3 * surface->surface_point_count * sizeof(double));
  hexcon_status status = hexcon_certify(
      context, hexcon_mesh_points(mesh), hexcon_mesh_point_count(mesh), hexcon_mesh_hexes(mesh),
      hexcon_mesh_hex_count(mesh), hexcon_mesh_quads(mesh), surface->quad_count, &certificate);
  assert_int_equal(status, HEXCON_OK);
  assert_true(certificate.certified);
  hexcon_certificate_free(context, &certificate);
}

void assert_filled(test_mesh surface, const hexcon_mesh_options *options, const char *method,
                   size_t hex_count) {
  test_memory memory = {0};
  hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
  hexcon_mesh *made = NULL;
  assert_int_equal(hexcon_mesh_surface(context, surface.points, surface.surface_point_count,
                                       surface.quads, surface.quad_count, options, &made),
                   HEXCON_OK);
  assert_int_equal(hexcon_mesh_hex_count(made), hex_count);
  assert_string_equal(hexcon_mesh_method(made), method);
  assert_certified_mesh(context, &surface, made);
  hexcon_mesh_free(context, made);
  hexcon_context_free(context);
  assert_int_equal(memory.live, 0);
  test_mesh_free(&surface);
}

void assert_witness(bool proved, const double witness[3]) {
  for (int k = 0; k < 3; k++)
    if (proved)
      assert_true(witness[k] >= 0 && witness[k] <= 1);
    else
      assert_true(isnan(witness[k]));
}

double figure_of(const hexcon_mesh *mesh, const char *name) {
  const hexcon_figure *figures;
  size_t count = hexcon_mesh_report(mesh, &figures);
  for (size_t i = 0; i < count; i++)
    if (strcmp(figures[i].name, name) == 0)
      return figures[i].value;
  fail_msg("there is no figure %s", name);
  return NAN;
}
