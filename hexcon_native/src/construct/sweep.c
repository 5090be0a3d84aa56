/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "sweep.h"

#include <string.h>

void sweep_free(hexcon_context *context, sweep *w) {
  context_free(context, w->cap_quads);
  context_free(context, w->on_rim);
  context_free(context, w->ids);
  memset(w, 0, sizeof *w);
}

/** What a quad belongs to. */
enum { UNSEEN = 0, FIRST_CAP, SECOND_CAP, SIDE };

typedef struct regions {
  uint8_t *of_quad; /* [quad_count] */
  int32_t *queue;   /* [quad_count] quads of the first cap come first, in order of discovery */
  size_t first_count, second_count;
} regions;

static void mark_sides(const surface_loops *loops, const strip_table *strips, const reflection *r,
                       size_t rings, regions *g) {
  for (size_t m = 0; m < r->mirror_count; m++) {
    const strip *in = &strips->strips[r->mirrors[m].strip];
    size_t turn = in->cyclic ? 2 * in->ring_count : 0;
    size_t start = (r->mirrors[m].middle + turn - rings) / 2;
    for (size_t i = 0; i < rings; i++) {
      int32_t entry = strips->entries[in->first + (start + i) % in->ring_count];
      int32_t loop = loops->loop_of_passage[surface_passage(entry)];
      for (size_t p = loops->offsets[loop]; p < loops->offsets[loop + 1]; p++)
        g->of_quad[half_edge_quad(loops->entries[p])] = SIDE;
    }
  }
}

/** Flood from one quad; returns how many quads were reached. */
static size_t flood(const surface *s, regions *g, int32_t seed, uint8_t cap, size_t first) {
  size_t head = first, tail = first;
  g->of_quad[seed] = cap;
  g->queue[tail++] = seed;
  while (head < tail) {
    int32_t quad = g->queue[head++];
    for (int side = 0; side < 4; side++) {
      int32_t other = half_edge_quad(s->twins[4 * quad + side]);
      if (g->of_quad[other] != UNSEEN)
        continue;
      g->of_quad[other] = cap;
      g->queue[tail++] = other;
    }
  }
  return tail - first;
}

/** Without the sides, two pieces must remain that the reflection exchanges. */
static const char *find_caps(const surface *s, const reflection *r, regions *g) {
  size_t q = 0;
  while (q < s->quad_count && g->of_quad[q] != UNSEEN)
    q++;
  if (q == s->quad_count)
    return "the rings leave no caps";
  g->first_count = flood(s, g, (int32_t)q, FIRST_CAP, 0);
  int32_t image = half_edge_quad(r->images[q]);
  if (g->of_quad[image] != UNSEEN)
    return "the sides do not part the surface in two caps";
  g->second_count = flood(s, g, image, SECOND_CAP, g->first_count);
  if (memchr(g->of_quad, UNSEEN, s->quad_count))
    return "the sides part the surface in more than two pieces";
  return NULL;
}

/** Number the points of the first cap in order of discovery; returns how many there are. */
static size_t number_cap_points(const surface *s, const regions *g, int32_t *local) {
  int32_t count = 0;
  memset(local, -1, s->point_count * sizeof *local);
  for (size_t i = 0; i < g->first_count; i++)
    for (int corner = 0; corner < 4; corner++) {
      int32_t v = s->quads[4 * g->queue[i] + corner];
      if (local[v] < 0)
        local[v] = count++;
    }
  return (size_t)count;
}

/** Both caps' points, and for every rim edge the column of sides below it. */
static void fill_from_surface(const surface *s, const reflection *r, const regions *g,
                              const int32_t *local, sweep *w) {
  size_t stride = w->cap_point_count;
  for (size_t i = 0; i < g->first_count; i++)
    for (int corner = 0; corner < 4; corner++) {
      int32_t h = 4 * g->queue[i] + corner, v = s->quads[h], next = half_edge_end(s, h);
      w->cap_quads[4 * i + (size_t)corner] = local[v];
      w->ids[local[v]] = v;
      w->ids[w->rings * stride + (size_t)local[v]] = half_edge_end(s, reflection_image(r, h));
      int32_t down = s->twins[h];
      if (g->of_quad[half_edge_quad(down)] != SIDE)
        continue;
      w->on_rim[local[v]] = w->on_rim[local[next]] = 1;
      for (size_t level = 1; level < w->rings; level++) {
        int32_t below = half_edge_turn(down, 2);
        w->ids[level * stride + (size_t)local[v]] = half_edge_start(s, below);
        w->ids[level * stride + (size_t)local[next]] = half_edge_end(s, below);
        down = s->twins[below];
      }
    }
}

static hexcon_status number_inner_points(hexcon_context *context, const surface *s, sweep *w) {
  hexcon_status status = HEXCON_OK;
  int32_t next = (int32_t)s->point_count;
  for (size_t level = 1; !status && level < w->rings; level++)
    for (size_t v = 0; !status && v < w->cap_point_count; v++) {
      if (!w->on_rim[v])
        w->ids[level * w->cap_point_count + v] = next++;
      status = context_pass(context, level * w->cap_point_count + v);
    }
  for (size_t v = 0; v < w->cap_point_count; v++)
    w->inner_point_count += !w->on_rim[v];
  w->point_count = (size_t)next;
  return status;
}

/** New ids must fit: every layer has fewer new points than four a quad. */
static hexcon_status check_size(hexcon_context *context, const surface *s, const regions *g,
                                size_t rings) {
  const size_t most = CONTEXT_MAX_COUNT / 24;
  if (s->quad_count < most && rings < (most - s->quad_count) / g->first_count)
    return HEXCON_OK;
  return context_fail(context, HEXCON_TOO_LARGE,
                      "%zu cap quads times %zu rings are more hexes than 32-bit ids hold (%zu)",
                      g->first_count, rings, most);
}

static hexcon_status assemble(hexcon_context *context, const surface *s, const reflection *r,
                              const regions *g, int32_t *local, sweep *w) {
  hexcon_status status = check_size(context, s, g, w->rings);
  if (status)
    return status;
  w->cap_quad_count = g->first_count;
  w->cap_point_count = number_cap_points(s, g, local);
  w->cap_quads = context_allocate(context, 4 * w->cap_quad_count, sizeof *w->cap_quads);
  w->on_rim = context_allocate_zeroed(context, w->cap_point_count, sizeof *w->on_rim);
  w->ids = context_allocate(context, (w->rings + 1) * w->cap_point_count, sizeof *w->ids);
  if (!w->cap_quads || !w->on_rim || !w->ids)
    return HEXCON_OUT_OF_MEMORY;
  fill_from_surface(s, r, g, local, w);
  status = context_after(context, s->quad_count);
  return status ? status : number_inner_points(context, s, w);
}

hexcon_status sweep_build(hexcon_context *context, const surface *s, const surface_loops *loops,
                          const strip_table *strips, const reflection *r, size_t rings,
                          sweep *out) {
  memset(out, 0, sizeof *out);
  out->rings = rings;
  regions g = {context_allocate_zeroed(context, s->quad_count, sizeof *g.of_quad),
               context_allocate(context, s->quad_count, sizeof *g.queue), 0, 0};
  int32_t *local = context_allocate(context, s->point_count, sizeof *local);
  hexcon_status status = g.of_quad && g.queue && local ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status) {
    mark_sides(loops, strips, r, rings, &g);
    out->failure = find_caps(s, r, &g);
  }
  if (!status && !out->failure)
    status = assemble(context, s, r, &g, local, out);
  context_free(context, g.of_quad);
  context_free(context, g.queue);
  context_free(context, local);
  return status;
}

hexcon_status sweep_write_hexes(hexcon_context *context, const sweep *w, int32_t *hexes) {
  hexcon_status status = HEXCON_OK;
  for (size_t level = 0; !status && level < w->rings; level++) {
    const int32_t *upper = w->ids + level * w->cap_point_count;
    const int32_t *lower = upper + w->cap_point_count;
    for (size_t q = 0; !status && q < w->cap_quad_count; q++, hexes += 8) {
      for (size_t corner = 0; corner < 4; corner++) {
        int32_t v = w->cap_quads[4 * q + corner];
        hexes[corner] = lower[v];
        hexes[corner + 4] = upper[v];
      }
      status = context_pass(context, level * w->cap_quad_count + q);
    }
  }
  return status;
}
