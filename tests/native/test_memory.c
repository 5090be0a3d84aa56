/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Every allocation fails once, every progress call cancels once: nothing leaks, nothing breaks. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support.h"
#include "verify/jacobian_sign.h"

/* ------------------------------------------------------------------------- the public calls */

/** Surfaces and meshes the calls work on. */
typedef struct material {
  test_mesh swept, twisted, diced, small, not_swept, torus, odd_torus, hollow, scrambled, cube,
      tunnels;
  uint8_t *fixed, *swept_fixed;
  double *positions, *goal; /* goal: of swept, to be gone to by its boundary */
} material;

/** One public call; what it makes is freed inside. */
typedef hexcon_status (*public_call)(hexcon_context *context, material *m);

static hexcon_status call_check(hexcon_context *context, material *m) {
  hexcon_surface_report report;
  return hexcon_check_surface(context, m->swept.points, m->swept.surface_point_count,
                              m->swept.quads, m->swept.quad_count, &report);
}

static hexcon_status call_check_torus(hexcon_context *context, material *m) {
  hexcon_surface_report report;
  return hexcon_check_surface(context, m->torus.points, m->torus.point_count, m->torus.quads,
                              m->torus.quad_count, &report);
}

/** A path that bounds inside is odd. */
static hexcon_status call_check_odd_torus(hexcon_context *context, material *m) {
  hexcon_surface_report report;
  return hexcon_check_surface(context, m->odd_torus.points, m->odd_torus.point_count,
                              m->odd_torus.quads, m->odd_torus.quad_count, &report);
}

static hexcon_status call_check_hollow(hexcon_context *context, material *m) {
  hexcon_surface_report report;
  return hexcon_check_surface(context, m->hollow.points, m->hollow.surface_point_count,
                              m->hollow.quads, m->hollow.quad_count, &report);
}

static hexcon_status call_loops(hexcon_context *context, material *m) {
  hexcon_loops loops;
  memset(&loops, 0xff, sizeof loops);
  hexcon_status status = hexcon_surface_loops(context, m->swept.quads, m->swept.quad_count, &loops);
  if (status)
    assert_true(!loops.offsets && !loops.quads && !loops.self_crossings);
  hexcon_loops_free(context, &loops);
  return status;
}

static hexcon_status call_colouring(hexcon_context *context, material *m) {
  uint8_t colours[256];
  return hexcon_surface_colouring(context, m->swept.quads, m->swept.quad_count,
                                  m->swept.surface_point_count, colours);
}

static hexcon_status call_colouring_torus(hexcon_context *context, material *m) {
  uint8_t colours[256];
  hexcon_status status = hexcon_surface_colouring(context, m->torus.quads, m->torus.quad_count,
                                                  m->torus.point_count, colours);
  return status == HEXCON_NOT_BIPARTITE ? HEXCON_OK : status;
}

static hexcon_status call_pairing(hexcon_context *context, material *m) {
  int32_t pairs[256];
  return hexcon_surface_pairing(context, m->twisted.points, m->twisted.surface_point_count,
                                m->twisted.quads, m->twisted.quad_count, pairs);
}

static hexcon_status call_pairing_topology(hexcon_context *context, material *m) {
  int32_t pairs[256];
  return hexcon_surface_pairing(context, NULL, m->torus.point_count, m->torus.quads,
                                m->torus.quad_count, pairs);
}

static hexcon_status call_pairing_of_crossings(hexcon_context *context, material *m) {
  int32_t pairs[256];
  size_t count;
  hexcon_status status =
      hexcon_surface_pairing_of_crossings(context, m->not_swept.point_count, m->not_swept.quads,
                                          m->not_swept.quad_count, pairs, &count);
  assert_true(status ? count == 0 : count > 0);
  return status;
}

static hexcon_status call_quality(hexcon_context *context, material *m) {
  double values[256];
  return hexcon_quality(context, m->swept.points, m->swept.point_count, m->swept.hexes,
                        m->swept.hex_count, values);
}

static hexcon_status certify(hexcon_context *context, const test_mesh *mesh) {
  hexcon_certificate certificate;
  memset(&certificate, 0xff, sizeof certificate);
  hexcon_status status =
      hexcon_certify(context, mesh->points, mesh->point_count, mesh->hexes, mesh->hex_count,
                     mesh->quads, mesh->quad_count, &certificate);
  if (status)
    assert_true(!certificate.nonpositive && !certificate.witnesses && !certificate.doublets &&
                !certificate.improper && !certificate.certified);
  hexcon_certificate_free(context, &certificate);
  return status;
}

static hexcon_status call_certify(hexcon_context *context, material *m) {
  return certify(context, &m->swept);
}

/** Of a swept body, embedded; and of a torus drawn flat, whose pairs are listed. */
static hexcon_status call_embedding(hexcon_context *context, material *m) {
  hexcon_embedding found;
  hexcon_status status =
      hexcon_surface_embedding(context, m->swept.points, m->swept.surface_point_count,
                               m->swept.quads, m->swept.quad_count, &found);
  hexcon_embedding_free(context, &found);
  if (status)
    return status;
  test_mesh flat = test_mesh_copy(&m->torus);
  for (size_t v = 0; v < flat.point_count; v++)
    flat.points[3 * v + 2] = 0;
  status = hexcon_surface_embedding(context, flat.points, flat.point_count, flat.quads,
                                    flat.quad_count, &found);
  assert_true(status || found.pair_count > 0);
  hexcon_embedding_free(context, &found);
  test_mesh_free(&flat);
  return status;
}

/** With lists of bad hexes to fill. */
static hexcon_status call_certify_bad(hexcon_context *context, material *m) {
  test_mesh bad = test_mesh_copy(&m->scrambled);
  memcpy(bad.hexes + 8, bad.hexes, 8 * sizeof *bad.hexes);
  hexcon_status status = certify(context, &bad);
  test_mesh_free(&bad);
  return status;
}

static hexcon_status call_optimize(hexcon_context *context, material *m) {
  hexcon_status status =
      hexcon_optimize(context, m->scrambled.points, m->scrambled.point_count, m->scrambled.hexes,
                      m->scrambled.hex_count, m->fixed, NULL, m->positions);
  for (size_t i = 0; i < 3 * m->scrambled.point_count; i++)
    assert_true(isfinite(m->positions[i]));
  return status;
}

/** The sides of a scrambled box slide on planes, one of which is asked for. */
static bool project_to_plane(void *user, size_t count, const double *points, const int32_t *tags,
                             double *projected, double *directions) {
  (void)user, (void)tags;
  for (size_t i = 0; i < 3 * count; i++) {
    projected[i] = i % 3 == 2 ? 0 : points[i];
    directions[i] = i % 3 == 2;
  }
  return true;
}

static hexcon_status call_relax(hexcon_context *context, material *m) {
  static const hexcon_carrier pieces[] = {{.kind = HEXCON_CARRIER_PLANE, .axis = {1, 0, 0}},
                                          {.kind = HEXCON_CARRIER_SURFACE}};
  const int32_t starts[] = {0, 1, 2};
  const test_mesh *box = &m->scrambled;
  int32_t *carriers = malloc(box->point_count * sizeof *carriers);
  assert_non_null(carriers);
  for (size_t v = 0; v < box->point_count; v++) {
    const double *p = box->points + 3 * v;
    carriers[v] = v >= box->surface_point_count ? HEXCON_FREE
                  : p[0] == 0                   ? 0
                  : p[2] == 0                   ? 1
                                                : HEXCON_STAYS;
  }
  const hexcon_sliding sliding = {.carrier_of_point = carriers,
                                  .carrier_count = 2,
                                  .starts = starts,
                                  .pieces = pieces,
                                  .project = project_to_plane};
  const hexcon_relax_options options = {.passes = 1, .mean_passes = 1, .threads = 1};
  hexcon_status status = hexcon_relax(context, box->points, box->point_count, box->hexes,
                                      box->hex_count, &sliding, &options, m->positions);
  for (size_t v = 0; v < box->surface_point_count; v++)
    assert_true(status == HEXCON_OUT_OF_MEMORY || carriers[v] < 0 ||
                m->positions[3 * v + (carriers[v] == 0 ? 0 : 2)] == 0);
  free(carriers);
  return status;
}

/** In several steps; where it ends early, and wherever it is cancelled, the mesh is valid. */
static hexcon_status call_morph(hexcon_context *context, material *m) {
  double reached = -1;
  hexcon_status status =
      hexcon_morph(context, m->swept.points, m->swept.point_count, m->swept.hexes,
                   m->swept.hex_count, m->swept_fixed, m->goal, NULL, m->positions, &reached);
  assert_true(reached >= 0 && reached <= 1);
  for (size_t h = 0; h < m->swept.hex_count; h++)
    assert_int_equal(prove_jacobian_sign(m->positions, m->swept.hexes + 8 * h), JACOBIAN_POSITIVE);
  return status;
}

static hexcon_status call_morph_boundary(hexcon_context *context, material *m) {
  const hexcon_morph_options options = {.boundary_only = true, .target = 0.3};
  double reached;
  return hexcon_morph(context, m->swept.points, m->swept.point_count, m->swept.hexes,
                      m->swept.hex_count, m->swept_fixed, m->goal, &options, m->positions,
                      &reached);
}

static hexcon_status mesh_by(hexcon_context *context, const test_mesh *surface,
                             hexcon_method method, int order) {
  hexcon_mesh *mesh = (hexcon_mesh *)context;
  const hexcon_mesh_options options = {.method = method, .order = order};
  hexcon_status status = hexcon_mesh_surface(context, surface->points, surface->surface_point_count,
                                             surface->quads, surface->quad_count, &options, &mesh);
  if (status)
    assert_null(mesh);
  else if (order == 1)
    assert_true(hexcon_mesh_certificate(mesh)->certified);
  hexcon_mesh_free(context, mesh);
  return status;
}

static hexcon_status mesh_of(hexcon_context *context, const test_mesh *surface, int order) {
  return mesh_by(context, surface, HEXCON_METHOD_SWEPT, order);
}

static hexcon_status call_raise_order(hexcon_context *context, material *m) {
  hexcon_second_order raised;
  memset(&raised, 0xff, sizeof raised);
  hexcon_status status = hexcon_raise_order(context, m->swept.points, m->swept.point_count,
                                            m->swept.hexes, m->swept.hex_count, &raised);
  if (status)
    assert_true(!raised.points && !raised.hexes);
  hexcon_second_order_free(context, &raised);
  return status;
}

static hexcon_status call_certify_second_order(hexcon_context *context, material *m) {
  hexcon_second_order raised;
  hexcon_status status = hexcon_raise_order(context, m->swept.points, m->swept.point_count,
                                            m->swept.hexes, m->swept.hex_count, &raised);
  hexcon_certificate c = {0};
  double *quality = malloc(m->swept.hex_count * sizeof *quality);
  assert_non_null(quality);
  if (!status)
    status = hexcon_quality_second_order(context, raised.points, raised.point_count, raised.hexes,
                                         m->swept.hex_count, quality);
  free(quality);
  if (!status)
    status =
        hexcon_certify_second_order(context, raised.points, raised.point_count, raised.hexes,
                                    m->swept.hex_count, m->swept.quads, m->swept.quad_count, &c);
  if (!status) {
    assert_true(c.certified);
    hexcon_certificate_free(context, &c);
    raised.hexes[8] = raised.hexes[9]; /* some are improper, some are not positive */
    status =
        hexcon_certify_second_order(context, raised.points, raised.point_count, raised.hexes,
                                    m->swept.hex_count, m->swept.quads, m->swept.quad_count, &c);
    if (status)
      assert_true(!c.nonpositive && !c.improper && !c.witnesses);
  }
  hexcon_certificate_free(context, &c);
  hexcon_second_order_free(context, &raised);
  return status;
}

static hexcon_status call_mesh(hexcon_context *context, material *m) {
  return mesh_of(context, &m->swept, 1);
}

static hexcon_status call_mesh_second_order(hexcon_context *context, material *m) {
  return mesh_of(context, &m->swept, 2);
}

/** With levels that are no affine images, and improvement. */
static hexcon_status call_mesh_twisted(hexcon_context *context, material *m) {
  return mesh_of(context, &m->twisted, 1);
}

/** Three hexes in a surface that is rough, so that they have to be moved. */
static hexcon_status call_mesh_smallest(hexcon_context *context, material *m) {
  return mesh_by(context, &m->small, HEXCON_METHOD_SMALLEST, 1);
}

/** The swept mesh's own hexes, with places for the inner points and without. */
static hexcon_status call_mesh_proposal(hexcon_context *context, material *m) {
  const test_mesh *given = &m->swept;
  const size_t inner = given->point_count - given->surface_point_count;
  hexcon_status status = HEXCON_OK;
  for (int placed = 0; !status && placed < 2; placed++) {
    const hexcon_proposal proposal = {given->hex_count, given->hexes, inner,
                                      placed ? given->points + 3 * given->surface_point_count
                                             : NULL};
    const hexcon_mesh_options options = {
        .method = HEXCON_METHOD_PROPOSAL, .proposal = &proposal, .allow_uncertified = true};
    hexcon_mesh *mesh;
    status = hexcon_mesh_surface(context, given->points, given->surface_point_count, given->quads,
                                 given->quad_count, &options, &mesh);
    hexcon_mesh_free(context, mesh);
  }
  return status;
}

static hexcon_status call_mesh_not_swept(hexcon_context *context, material *m) {
  hexcon_status status = mesh_of(context, &m->not_swept, 1);
  return status == HEXCON_NOT_SWEPT ? HEXCON_OK : status;
}

/** Eight triangles whose tetrahedra meet in one point; test_diced has larger ones. */
static hexcon_status call_mesh_diced(hexcon_context *context, material *m) {
  hexcon_mesh *mesh = (hexcon_mesh *)context;
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_DICED, .threads = 1};
  hexcon_status status = hexcon_mesh_surface(context, m->diced.points, m->diced.surface_point_count,
                                             m->diced.quads, m->diced.quad_count, &options, &mesh);
  if (status)
    assert_null(mesh);
  else
    assert_true(hexcon_mesh_certificate(mesh)->certified);
  hexcon_mesh_free(context, mesh);
  return status;
}

static hexcon_status mesh_topological(hexcon_context *context, const test_mesh *given,
                                      const hexcon_mesh_options *options) {
  hexcon_mesh *mesh = (hexcon_mesh *)context;
  hexcon_status status = hexcon_mesh_surface(context, given->points, given->surface_point_count,
                                             given->quads, given->quad_count, options, &mesh);
  if (status)
    assert_null(mesh);
  else
    assert_true(hexcon_mesh_certificate(mesh)->conforming);
  hexcon_mesh_free(context, mesh);
  return status;
}

/** Down to the front; without pairs, in three families. */
static hexcon_status call_mesh_four_split(hexcon_context *context, material *m) {
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_FOUR_SPLIT,
                                       .pairing = HEXCON_PAIRING_NONE};
  return mesh_topological(context, &m->cube, &options);
}

/** Paired, and closed by pyramids. */
static hexcon_status call_mesh_pyramid(hexcon_context *context, material *m) {
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_PYRAMID};
  return mesh_topological(context, &m->cube, &options);
}

/** With given pairs, the other layers, and Geodes. */
static hexcon_status call_mesh_geode_alt(hexcon_context *context, material *m) {
  int32_t pairs[6];
  hexcon_status status = hexcon_surface_pairing(context, NULL, m->cube.surface_point_count,
                                                m->cube.quads, m->cube.quad_count, pairs);
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_GEODE_ALT,
                                       .pairing = HEXCON_PAIRING_GIVEN,
                                       .pairs = pairs,
                                       .pair_count = 3};
  return status ? status : mesh_topological(context, &m->cube, &options);
}

/** Loops without sides, told in the caller's points. */
static hexcon_status call_mesh_no_sides(hexcon_context *context, material *m) {
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_FOUR_SPLIT};
  hexcon_status status = mesh_topological(context, &m->torus, &options);
  return status == HEXCON_NO_SIDES ? HEXCON_OK : status;
}

/** With rims that do not move as one, and improvement. */
static hexcon_status call_mesh_sheets(hexcon_context *context, material *m) {
  return mesh_by(context, &m->twisted, HEXCON_METHOD_SHEETS, 1);
}

/** A ring, whose cut leaves a sweep. */
static hexcon_status call_mesh_cut_ring(hexcon_context *context, material *m) {
  return mesh_by(context, &m->torus, HEXCON_METHOD_SHEETS, 1);
}

/** A cube with three tunnels, of genus 5. */
static hexcon_status call_mesh_cut_cube(hexcon_context *context, material *m) {
  return mesh_by(context, &m->tunnels, HEXCON_METHOD_SHEETS, 1);
}

/** Its given hexes first. */
static hexcon_status call_repair(hexcon_context *context, material *m) {
  const uint8_t fixed[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  const hexcon_repair_options options = {.pillow = 2, .threads = 1};
  hexcon_repaired repaired;
  hexcon_status status = hexcon_repair(context, m->cube.points, m->cube.point_count, m->cube.hexes,
                                       m->cube.hex_count, fixed, &options, &repaired);
  assert_int_equal(repaired.hex_count, status ? 0 : 1 + 2 * m->cube.quad_count);
  hexcon_repaired_free(context, &repaired);
  return status;
}

/** Laid, and told of; two sheets. */
static hexcon_status call_mesh_pillow(hexcon_context *context, material *m) {
  hexcon_mesh *mesh = NULL;
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_SWEPT, .pillow = 2, .threads = 1};
  hexcon_status status = hexcon_mesh_surface(context, m->cube.points, m->cube.surface_point_count,
                                             m->cube.quads, m->cube.quad_count, &options, &mesh);
  if (!status)
    assert_int_equal(hexcon_mesh_hex_count(mesh), 1 + 2 * m->cube.quad_count);
  hexcon_mesh_free(context, mesh);
  return status;
}

/** With dead ends, and cores that are found, but not filled. */
static hexcon_status call_mesh_no_sheets(hexcon_context *context, material *m) {
  hexcon_mesh *mesh = NULL;
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_SHEETS, .no_core = true};
  hexcon_status status =
      hexcon_mesh_surface(context, m->not_swept.points, m->not_swept.surface_point_count,
                          m->not_swept.quads, m->not_swept.quad_count, &options, &mesh);
  return status == HEXCON_NO_SHEETS ? HEXCON_OK : status;
}

static hexcon_status call_mesh_core(hexcon_context *context, material *m) {
  return mesh_by(context, &m->not_swept, HEXCON_METHOD_SHEETS, 1);
}

static hexcon_status call_mesh_not_diced(hexcon_context *context, material *m) {
  hexcon_mesh *mesh = NULL;
  const hexcon_mesh_options options = {.method = HEXCON_METHOD_DICED};
  hexcon_status status = hexcon_mesh_surface(context, m->swept.points, m->swept.surface_point_count,
                                             m->swept.quads, m->swept.quad_count, &options, &mesh);
  return status == HEXCON_NOT_DICED ? HEXCON_OK : status;
}

static const struct {
  const char *name;
  public_call call;
} calls[] = {{"check", call_check},
             {"check torus", call_check_torus},
             {"check odd torus", call_check_odd_torus},
             {"check hollow", call_check_hollow},
             {"loops", call_loops},
             {"colouring", call_colouring},
             {"colouring torus", call_colouring_torus},
             {"pairing", call_pairing},
             {"pairing topology", call_pairing_topology},
             {"pairing crossings", call_pairing_of_crossings},
             {"quality", call_quality},
             {"embedding", call_embedding},
             {"certify", call_certify},
             {"certify bad", call_certify_bad},
             {"optimize", call_optimize},
             {"relax", call_relax},
             {"morph", call_morph},
             {"morph boundary", call_morph_boundary},
             {"raise order", call_raise_order},
             {"certify second order", call_certify_second_order},
             {"mesh", call_mesh},
             {"mesh second order", call_mesh_second_order},
             {"mesh twisted", call_mesh_twisted},
             {"mesh proposal", call_mesh_proposal},
             {"mesh not swept", call_mesh_not_swept},
             {"mesh four-split", call_mesh_four_split},
             {"mesh pyramid", call_mesh_pyramid},
             {"mesh geode-alt", call_mesh_geode_alt},
             {"mesh no sides", call_mesh_no_sides},
             {"repair", call_repair},
             {"mesh pillow", call_mesh_pillow},
             {"mesh sheets", call_mesh_sheets},
             {"mesh cut ring", call_mesh_cut_ring},
             {"mesh cut cube", call_mesh_cut_cube},
             {"mesh no sheets", call_mesh_no_sheets},
             {"mesh core", call_mesh_core},
             {"mesh diced", call_mesh_diced},
             {"refuse not diced", call_mesh_not_diced},
             {"mesh smallest", call_mesh_smallest}};

enum { CALL_COUNT = sizeof calls / sizeof *calls };

/** Of calls that take long, every 23rd allocation fails, not each. */
static size_t stride_of(public_call call) {
  return call == call_mesh_core || call == call_mesh_cut_cube ? 23 : 1;
}

/* --------------------------------------------------------------------------------- material */

/** Sides that bend and swell and are rough, so that placement has to solve and improvement has to
 * work: without the roughness, placement alone reaches what the surface allows. */
static void twist(test_mesh *mesh, double height, uint64_t random) {
  for (size_t v = 0; v < mesh->surface_point_count; v++) {
    for (size_t k = 0; k < 3; k++)
      mesh->points[3 * v + k] += random_between(&random, -0.25, 0.25);
    double *p = mesh->points + 3 * v, t = p[2] / height, angle = 1.2 * t;
    double x = p[0] - 1.5, y = p[1] - 1.5, swell = 1 + 0.6 * t * (1 - t) * x * x;
    p[0] = swell * (cos(angle) * x - sin(angle) * y);
    p[1] = sin(angle) * x + cos(angle) * y;
  }
}

/** Every point of the boundary on a half turn about an axis outside, those inside left behind. */
static void bend(const test_mesh *mesh, double *goal) {
  memcpy(goal, mesh->points, 3 * mesh->point_count * sizeof *goal);
  for (size_t v = 0; v < mesh->surface_point_count; v++) {
    double *p = goal + 3 * v, angle = 0.8 * p[2], radius = 1 + p[0];
    p[0] = radius * cos(angle);
    p[2] = radius * sin(angle);
  }
}

static int set_up(void **state) {
  static material m;
  uint64_t random = 21;
  m.swept = make_box(3, 2, 4);
  m.twisted = make_box(3, 3, 3);
  twist(&m.twisted, 3, 7);
  m.small = make_box(3, 1, 1);
  twist(&m.small, 3, 5);
  m.goal = malloc(3 * m.swept.point_count * sizeof *m.goal);
  m.swept_fixed = calloc(m.swept.point_count, 1);
  assert_true(m.goal && m.swept_fixed);
  memset(m.swept_fixed, 1, m.swept.surface_point_count);
  bend(&m.swept, m.goal);
  m.diced = make_box(2, 2, 2);
  m.not_swept = make_schneiders_pyramid();
  m.torus = make_torus(3, 4);
  m.odd_torus = make_torus(4, 3);
  m.hollow = make_cells(3, 3, 3, "#############.#############");
  m.tunnels = make_cells(3, 3, 3,
                         "####.####"
                         "#.#...#.#"
                         "####.####");
  m.cube = make_box(1, 1, 1);
  m.scrambled = make_box(4, 3, 3);
  for (size_t i = 3 * m.scrambled.surface_point_count; i < 3 * m.scrambled.point_count; i++)
    m.scrambled.points[i] += random_between(&random, -0.8, 0.8);
  m.fixed = calloc(m.scrambled.point_count, 1);
  m.positions = malloc(3 * m.scrambled.point_count * sizeof *m.positions);
  assert_true(m.fixed && m.positions);
  memset(m.fixed, 1, m.scrambled.surface_point_count);
  *state = &m;
  return 0;
}

static int tear_down(void **state) {
  material *m = *state;
  test_mesh_free(&m->swept);
  test_mesh_free(&m->twisted);
  test_mesh_free(&m->diced);
  test_mesh_free(&m->small);
  test_mesh_free(&m->not_swept);
  test_mesh_free(&m->torus);
  test_mesh_free(&m->odd_torus);
  test_mesh_free(&m->hollow);
  test_mesh_free(&m->tunnels);
  test_mesh_free(&m->cube);
  test_mesh_free(&m->scrambled);
  free(m->fixed);
  free(m->swept_fixed);
  free(m->positions);
  free(m->goal);
  return 0;
}

/* ------------------------------------------------------------------------------------- tests */

/** The k-th allocation fails, for every k until there are no more. */
static void out_of_memory(void **state) {
  for (int c = 0; c < CALL_COUNT; c++) {
    const size_t stride = stride_of(calls[c].call);
    size_t fail_at = 2; /* the context itself is the first */
    for (;; fail_at += stride) {
      test_memory memory = {.fail_at = fail_at};
      hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
      hexcon_status status = calls[c].call(context, *state);
      bool failed = memory.calls >= fail_at;
      if (failed != (status == HEXCON_OUT_OF_MEMORY))
        fail_msg("%s: allocation %zu fails, status %s", calls[c].name, fail_at,
                 hexcon_status_name((int)status));
      if (failed)
        assert_message(context);
      assert_int_equal(memory.live, 1);
      hexcon_context_free(context);
      assert_int_equal(memory.live, 0);
      if (!failed)
        break;
    }
    print_message("%-18s %3zu allocations\n", calls[c].name, fail_at - 2);
  }
}

static void no_context(void **state) {
  (void)state;
  test_memory memory = {.fail_at = 1};
  assert_null(hexcon_context_new_with(test_reallocate, &memory));
  hexcon_context_free(NULL);
  hexcon_context *context = hexcon_context_new();
  hexcon_mesh_free(context, NULL);
  hexcon_context_free(context);
}

/** The k-th call of progress cancels, for every k until there are no more. */
static void cancellation(void **state) {
  for (int c = 0; c < CALL_COUNT; c++) {
    size_t cancel_at = 1;
    for (;; cancel_at += stride_of(calls[c].call)) {
      test_memory memory = {0};
      test_patience left = {.cancel_at = cancel_at};
      hexcon_context *context = hexcon_context_new_with(test_reallocate, &memory);
      hexcon_context_set_progress(context, lose_patience, &left);
      hexcon_status status = calls[c].call(context, *state);
      bool cancelled = left.calls >= cancel_at;
      assert_int_equal(status, cancelled ? HEXCON_CANCELLED : HEXCON_OK);
      assert_int_equal(left.calls, cancelled ? cancel_at : left.calls); /* not asked again */
      if (cancelled)
        assert_message(context);
      hexcon_context_free(context);
      assert_int_equal(memory.live, 0);
      if (!cancelled)
        break;
    }
    print_message("%-18s %3zu calls of progress\n", calls[c].name, cancel_at - 1);
    if (strncmp(calls[c].name, "mesh", 4) == 0 || strncmp(calls[c].name, "certify", 7) == 0)
      assert_true(cancel_at > 1);
  }
}

/** A cancelled optimisation has moved nothing that is fixed and is not worse. */
static void cancelled_optimisation(void **state) {
  material *m = *state;
  for (size_t cancel_at = 1; cancel_at < 60; cancel_at += 7) {
    test_patience left = {.cancel_at = cancel_at};
    hexcon_context *context = hexcon_context_new();
    hexcon_context_set_progress(context, lose_patience, &left);
    (void)call_optimize(context, m);
    assert_memory_equal(m->positions, m->scrambled.points,
                        3 * m->scrambled.surface_point_count * sizeof *m->positions);
    hexcon_context_free(context);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(out_of_memory),
      cmocka_unit_test(no_context),
      cmocka_unit_test(cancellation),
      cmocka_unit_test(cancelled_optimisation),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
