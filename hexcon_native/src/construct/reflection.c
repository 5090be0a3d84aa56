/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "reflection.h"

#include <string.h>

hexcon_status reflection_new(hexcon_context *context, const surface *s, const strip_table *strips,
                             reflection *out) {
  memset(out, 0, sizeof *out);
  out->mirror_of_strip = context_allocate(context, strips->count, sizeof *out->mirror_of_strip);
  out->images = context_allocate(context, s->quad_count, sizeof *out->images);
  out->queue = context_allocate(context, s->quad_count, sizeof *out->queue);
  if (!out->images || !out->queue || !out->mirror_of_strip)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->mirror_of_strip, -1, strips->count * sizeof *out->mirror_of_strip);
  memset(out->images, -1, s->quad_count * sizeof *out->images);
  return HEXCON_OK;
}

void reflection_free(hexcon_context *context, reflection *r) {
  context_free(context, r->images);
  context_free(context, r->queue);
  context_free(context, r->mirrors);
  context_free(context, r->mirror_of_strip);
  memset(r, 0, sizeof *r);
}

/** The image of a quad under which half-edge h goes to half-edge image. */
static int32_t image_code(int32_t h, int32_t image) {
  return (image & ~3) | ((h + image) & 3);
}

static void set_image(reflection *r, int32_t quad, int32_t code) {
  r->images[quad] = code;
  r->queue[r->reached++] = quad;
}

static void forget(reflection *r) {
  for (size_t i = 0; i < r->reached; i++)
    r->images[r->queue[i]] = -1;
  for (size_t i = 0; i < r->mirror_count; i++)
    r->mirror_of_strip[r->mirrors[i].strip] = -1;
  r->reached = r->mirror_count = 0;
  r->max_rings = SIZE_MAX;
  r->clash[0] = r->clash[1] = -1;
  r->failure = NULL;
}

static void plant_seed(const surface *s, const strip_table *strips, mirror seed, reflection *r) {
  const strip *in = &strips->strips[seed.strip];
  int32_t entry = strips->entries[in->first + seed.middle / 2 % in->ring_count];
  int32_t fixed = seed.middle & 1 ? entry : half_edge_turn(entry, -1);
  int32_t image = seed.middle & 1 ? entry : s->twins[fixed];
  set_image(r, half_edge_quad(fixed), image_code(fixed, image));
}

/** Breadth-first: the image of a quad forces those of its neighbours. */
static void spread(const surface *s, reflection *r) {
  for (size_t head = 0; head < r->reached; head++)
    for (int side = 0; side < 4; side++) {
      int32_t h = 4 * r->queue[head] + side, next = s->twins[h];
      int32_t code = image_code(next, s->twins[reflection_image(r, h)]);
      int32_t known = r->images[half_edge_quad(next)];
      if (known == code)
        continue;
      if (known >= 0) {
        r->clash[0] = half_edge_quad(next);
        r->clash[1] = half_edge_quad(code);
        r->failure = "the two caps differ";
        return;
      }
      set_image(r, half_edge_quad(next), code);
    }
}

/** A strip has one mirror; a cyclic one is the whole surface, a torus, and has two. */
static bool is_known(const strip_table *strips, mirror found, const reflection *r) {
  if (!strips->strips[found.strip].cyclic)
    return r->mirror_of_strip[found.strip] >= 0;
  for (size_t i = 0; i < r->mirror_count; i++)
    if (r->mirrors[i].middle == found.middle)
      return true;
  return false;
}

/** Rings that a strip has symmetrically about its mirror. */
static size_t rings_about(const strip *in, size_t middle) {
  if (!in->cyclic)
    return middle < 2 * in->ring_count - middle ? middle : 2 * in->ring_count - middle;
  /* Two mirrors share the rings, and two caps need some as well. */
  size_t rings = in->ring_count / 2 > 0 ? in->ring_count / 2 - 1 : 0;
  return rings - (rings > 0 && ((rings ^ middle) & 1));
}

static hexcon_status add_mirror(hexcon_context *context, const strip_table *strips, mirror found,
                                reflection *r) {
  const strip *in = &strips->strips[found.strip];
  if (in->cyclic)
    found.middle %= 2 * in->ring_count;
  if (is_known(strips, found, r))
    return HEXCON_OK;
  if (r->mirror_count == r->mirror_capacity) {
    size_t capacity = r->mirror_capacity ? 2 * r->mirror_capacity : 4;
    mirror *mirrors = context_grow(context, r->mirrors, capacity, sizeof *mirrors);
    if (!mirrors)
      return HEXCON_OUT_OF_MEMORY;
    r->mirrors = mirrors;
    r->mirror_capacity = capacity;
  }
  r->mirror_of_strip[found.strip] = (int32_t)r->mirror_count;
  r->mirrors[r->mirror_count++] = found;
  size_t rings = rings_about(in, found.middle);
  if (rings < r->max_rings)
    r->max_rings = rings;
  return HEXCON_OK;
}

/** The half-edge of this quad that stays in place, and whether its mirror runs through the quad
 * (1), along the half-edge (2), or neither (0). */
static int fixed_side(const surface *s, const reflection *r, int32_t quad, int32_t *fixed) {
  int32_t image = r->images[quad];
  if (half_edge_quad(image) == quad) {
    *fixed = 4 * quad + (image & 3) / 2;
    return image & 1 ? -1 : 1;
  }
  for (int side = 0; side < 4; side++) {
    *fixed = 4 * quad + side;
    if (reflection_image(r, *fixed) == s->twins[*fixed])
      return 2;
  }
  return 0;
}

/** The mirror at a fixed half-edge, as a place in its strip; false if its loop is not simple. */
static bool locate_mirror(const surface_loops *loops, const strip_table *strips, const surface *s,
                          int32_t fixed, bool through, mirror *found) {
  int32_t passage = through ? fixed : half_edge_turn(fixed, 1);
  int32_t loop = loops->loop_of_passage[surface_passage(passage)];
  found->strip = strips->strip_of_loop[loop];
  if (found->strip < 0)
    return false;
  found->middle = 2 * (size_t)strips->ring_of_loop[loop] + 1;
  if (through)
    return true;
  /* The half-edge is the left or the right rim of its ring: the neighbour's ring tells. */
  const strip *in = &strips->strips[found->strip];
  int32_t beyond = half_edge_turn(s->twins[fixed], 1);
  int32_t other = loops->loop_of_passage[surface_passage(beyond)];
  if (strips->strip_of_loop[other] != found->strip)
    return false;
  size_t ring = (size_t)strips->ring_of_loop[loop], next = (size_t)strips->ring_of_loop[other];
  bool right = next == ring + 1 || (in->cyclic && ring == in->ring_count - 1 && next == 0);
  found->middle = right ? 2 * ring + 2 : 2 * ring;
  return true;
}

static hexcon_status find_mirrors(hexcon_context *context, const surface *s,
                                  const surface_loops *loops, const strip_table *strips,
                                  reflection *r) {
  bool through = false, along = false;
  for (size_t q = 0; q < s->quad_count; q++) {
    int32_t fixed;
    mirror found;
    int kind = fixed_side(s, r, (int32_t)q, &fixed);
    if (kind == 0)
      continue;
    through |= kind == 1;
    along |= kind == 2;
    if (kind < 0 || (through && along) ||
        !locate_mirror(loops, strips, s, fixed, kind == 1, &found)) {
      r->clash[0] = (int32_t)q;
      r->failure = "the middle of the sides is no closed ring of quads";
      return HEXCON_OK;
    }
    hexcon_status status = add_mirror(context, strips, found, r);
    if (status)
      return status;
  }
  if (r->max_rings == 0)
    r->failure = "the rings go all the way round and leave no caps";
  return HEXCON_OK;
}

hexcon_status reflection_try(hexcon_context *context, const surface *s, const surface_loops *loops,
                             const strip_table *strips, mirror seed, reflection *r) {
  forget(r);
  plant_seed(s, strips, seed, r);
  spread(s, r);
  return r->failure ? HEXCON_OK : find_mirrors(context, s, loops, strips, r);
}
