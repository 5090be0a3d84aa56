/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Search for hex meshes with a given boundary. See the README one folder up.
 *
 *     hexcon_template_search classes most_quads
 *     hexcon_template_search fill target [name value ...]
 *     hexcon_template_search refill target [name value ...]
 *     hexcon_template_search batch [name value ...]
 *     hexcon_template_search spread [name value ...]
 *
 * Standard output: a line for each result. A filling is its number of hexes and their points, eight
 * each, in VTK order; points below the number of boundary points are those of the target.
 *
 * `refill` answers each line of standard input, `tries slack most_hexes focus most_part
 * point_count` and a filling, by one line: the name of another filling and that filling, or 0 if
 * none was found.
 *
 * `batch` answers each target file on standard input, followed by the number of known fillings and
 * these, by its smallest fillings and 0: found by a beam, and then by re-filling parts of them.
 *
 * `spread` reads fillings of any boundaries and prints the smallest ones that they and the cube
 * lead to by gluing hexes on, of every boundary with as many quads as the option `small` or fewer.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "beam.h"
#include "classes.h"
#include "refill.h"
#include "shrink.h"
#include "spread.h"
#include "support.h"

typedef struct settings {
  int quads, alternatives, table_hexes;
  int keep;  /**< batch, spread: fillings of a boundary */
  int small; /**< spread: quads of those that are told */
  double entries, shrink_seconds;
  beam_options beam;
} settings;

static void set(settings *s, const char *name, const char *text) {
  const double value = real_number(&text);
  const struct {
    const char *name;
    int *whole;
    double *real;
  } known[] = {{"quads", &s->quads, NULL},
               {"alternatives", &s->alternatives, NULL},
               {"table_hexes", &s->table_hexes, NULL},
               {"entries", NULL, &s->entries},
               {"keep", &s->keep, NULL},
               {"small", &s->small, NULL},
               {"shrink", NULL, &s->shrink_seconds},
               {"width", &s->beam.width, NULL},
               {"cavity_quads", &s->beam.most_quads, NULL},
               {"hexes", &s->beam.most_hexes, NULL},
               {"fillings", &s->beam.most_fillings, NULL},
               {"noise", NULL, &s->beam.noise},
               {"seconds", NULL, &s->beam.seconds}};
  if (*text != '\0' || value < 0 || value > 1e9)
    stop("an option needs a number that is not negative");
  if (strcmp(name, "seed") == 0) {
    s->beam.seed = (uint64_t)value;
    return;
  }
  for (size_t i = 0; i < sizeof known / sizeof *known; i++)
    if (strcmp(name, known[i].name) == 0) {
      if (known[i].whole)
        *known[i].whole = (int)value;
      else
        *known[i].real = value;
      return;
    }
  stop("no such option");
}

static settings read_settings(int count, char **words) {
  settings s = {.quads = 20,
                .alternatives = 1,
                .table_hexes = 48,
                .entries = 1e6,
                .keep = 12,
                .small = 16,
                .shrink_seconds = 5,
                .beam = {.width = 2000,
                         .most_hexes = MOST_HEXES,
                         .most_fillings = 100,
                         .noise = 2,
                         .seconds = 600,
                         .seed = 1}};
  if (count % 2)
    stop("options come in pairs: name value");
  for (int i = 0; i + 1 < count; i += 2)
    set(&s, words[i], words[i + 1]);
  if (s.quads < 6 || s.quads > MOST_QUADS || s.alternatives < 1 ||
      s.alternatives > MOST_ALTERNATIVES || s.table_hexes > MOST_HEXES ||
      s.beam.most_hexes > MOST_HEXES || s.beam.most_quads > MOST_QUADS || s.keep < 1 ||
      s.keep > MOST_KEPT)
    stop("an option is out of its range");
  return s;
}

static void print_filling(void *user, const filling *f) {
  (void)user;
  (void)printf("%d", f->hex_count);
  for (int h = 0; h < f->hex_count; h++)
    for (int i = 0; i < 8; i++)
      (void)printf(" %d", f->hexes[h][i]);
  (void)printf("\n");
  (void)fflush(stdout);
}

static void grow_from_cube(table *t, int quads, int alternatives, const settings *s) {
  const double started = now();
  ball cube;
  ball_single_hex(&cube);
  table_begin(t, quads, alternatives);
  table_add_root(t, &cube);
  table_grow(t, (size_t)s->entries, s->table_hexes);
  (void)fprintf(stderr, "table: %zu entries in %zu classes up to %d quads, %d hexes; %.1f s\n",
                t->count, t->classes.count, quads, t->entries[t->count - 1].hex_count,
                now() - started);
}

/** One whole number from standard input. @return false at its end */
static bool next_number(int *value, int least, int most) {
  char word[16];
  const char *text = word;
  if (scanf("%15s", word) != 1)
    return false;
  *value = whole_number(&text, least, most);
  return true;
}

static bool read_filling(filling *f, int point_count) {
  if (!next_number(&f->hex_count, 1, MOST_HEXES))
    return false;
  for (int h = 0; h < f->hex_count; h++)
    for (int i = 0; i < 8; i++) {
      int id = 0;
      if (!next_number(&id, 0, point_count - 1))
        return false;
      f->hexes[h][i] = (uint8_t)id;
    }
  return true;
}

static void serve_refills(const table *t, const target *goal, uint64_t seed) {
  dice random = {seed};
  filling before, after;
  refill_options o;
  int points;
  while (next_number(&o.tries, 1, 1 << 20) && next_number(&o.slack, -MOST_HEXES, MOST_HEXES) &&
         next_number(&o.most_hexes, 1, MOST_HEXES) && next_number(&o.focus, -1, MOST_HEXES) &&
         next_number(&o.most_part, 1, MOST_HEXES) && next_number(&points, 8, MOST_POINTS) &&
         read_filling(&before, points)) {
    if (o.focus >= before.hex_count)
      stop("the focus is no hex");
    if (refill(t, goal, &before, points, &o, &random, &after)) {
      (void)printf("%" PRIu64 " ", filling_name(goal, &after));
      print_filling(NULL, &after);
    } else {
      (void)printf("0\n");
      (void)fflush(stdout);
    }
  }
}

static void offer_filling(void *user, const filling *f) {
  pool_offer(user, f);
}

static void answer_target(const table *deep, const table *wide, const char *path,
                          const settings *s) {
  target goal;
  filling known;
  int count = 0;
  dice random = {s->beam.seed};
  pool p = {.goal = &goal, .room = s->keep};
  target_read(&goal, path);
  for (bool more = next_number(&count, 0, 1 << 20); more && count > 0; count--)
    if (read_filling(&known, MOST_POINTS) &&
        target_filled(&goal, (const uint8_t(*)[8])known.hexes, known.hex_count))
      pool_offer(&p, &known);
  (void)beam_search(deep, &goal, &s->beam, offer_filling, &p);
  shrink(wide, &p, s->shrink_seconds, &random);
  for (int i = 0; i < p.count; i++)
    print_filling(NULL, &p.kept[i]);
  (void)printf("0\n");
  (void)fflush(stdout);
}

/** The beam wants a deep table, re-filling one with alternatives: the same if one is asked for. */
static int run_batch(const settings *s) {
  table deep, other, *wide = &deep;
  char path[4096];
  grow_from_cube(&deep, s->quads, 1, s);
  if (s->alternatives > 1) {
    settings half = *s;
    half.entries /= 2;
    grow_from_cube(&other, s->quads < 20 ? s->quads : 20, s->alternatives, &half);
    wide = &other;
  }
  while (scanf("%4095s", path) == 1)
    answer_target(&deep, wide, path, s);
  if (wide != &deep)
    table_free(wide);
  table_free(&deep);
  return 0;
}

static int run_spread(const settings *s) {
  table t;
  ball b;
  filling f;
  table_begin(&t, s->quads, s->alternatives);
  ball_single_hex(&b);
  table_add_root(&t, &b);
  while (read_filling(&f, MOST_POINTS))
    if (ball_of_filling(&f, &b))
      table_add_root(&t, &b);
  table_grow(&t, (size_t)s->entries, s->table_hexes);
  (void)fprintf(stderr, "spread: %zu entries from %zu roots\n", t.count, t.root_count);
  visit_smallest(&t, s->small, s->keep, print_filling, NULL);
  table_free(&t);
  return 0;
}

static int run_classes(const char *word) {
  size_t counts[MOST_QUADS + 1];
  int hexes[MOST_QUADS + 1];
  const int most = whole_number(&word, 6, MOST_QUADS);
  count_classes(most, counts, hexes);
  for (int q = 6; q <= most; q += 2)
    (void)printf("%d %zu %d\n", q, counts[q], hexes[q]);
  return 0;
}

int main(int count, char **words) {
  target goal;
  table t;
  if (count == 3 && strcmp(words[1], "classes") == 0)
    return run_classes(words[2]);
  if (count >= 2 && strcmp(words[1], "batch") == 0) {
    const settings s = read_settings(count - 2, words + 2);
    return run_batch(&s);
  }
  if (count >= 2 && strcmp(words[1], "spread") == 0) {
    const settings s = read_settings(count - 2, words + 2);
    return run_spread(&s);
  }
  if (count < 3 || (strcmp(words[1], "fill") != 0 && strcmp(words[1], "refill") != 0))
    stop("say: classes most_quads | fill target [name value ...] | refill target [name value ...] "
         "| batch [name value ...] | spread [name value ...]");
  const settings s = read_settings(count - 3, words + 3);
  target_read(&goal, words[2]);
  grow_from_cube(&t, s.quads, s.alternatives, &s);
  if (strcmp(words[1], "refill") == 0)
    serve_refills(&t, &goal, s.beam.seed);
  else
    (void)fprintf(stderr, "%d fillings\n", beam_search(&t, &goal, &s.beam, print_filling, NULL));
  table_free(&t);
  return 0;
}
