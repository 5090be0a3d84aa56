/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "hexes.h"

#include <string.h>

#include "hexmesh/hex_tables.h"

/** Corners of `a` that `b` has too, as bits; `where` tells which corner of b each is. */
static unsigned common_corners(const uint8_t a[8], const uint8_t b[8], int where[8]) {
  unsigned common = 0;
  for (int i = 0; i < 8; i++)
    for (int j = 0; j < 8; j++)
      if (a[i] == b[j]) {
        common |= 1U << i;
        where[i] = j;
      }
  return common;
}

static int size_of(unsigned set) {
  int size = 0;
  for (; set; set &= set - 1)
    size++;
  return size;
}

static bool is_edge(int i, int j) {
  const int difference = hex_corner_bits[i] ^ hex_corner_bits[j];
  return difference == 1 || difference == 2 || difference == 4;
}

static bool is_face(unsigned corners) {
  for (int f = 0; f < 6; f++) {
    unsigned face = 0;
    for (int k = 0; k < 4; k++)
      face |= 1U << hex_faces[f][k];
    if (face == corners)
      return true;
  }
  return false;
}

bool hexes_meet_properly(const uint8_t a[8], const uint8_t b[8]) {
  int where[8];
  const unsigned common = common_corners(a, b, where);
  if ((common & (common - 1)) == 0)
    return true;
  const int size = size_of(common);
  if (size != 2 && size != 4)
    return false;
  unsigned in_b = 0;
  for (int i = 0; i < 8; i++) {
    if (!(common >> i & 1))
      continue;
    in_b |= 1U << where[i];
    for (int j = 0; j < i; j++)
      if ((common >> j & 1) && is_edge(i, j) != is_edge(where[i], where[j]))
        return false;
  }
  if (size == 4)
    return is_face(common) && is_face(in_b);
  int first = 0, second = 7;
  while (!(common >> first & 1))
    first++;
  while (!(common >> second & 1))
    second--;
  return is_edge(first, second);
}

void hex_mirror(uint8_t hex[8]) {
  uint8_t bottom[4];
  memcpy(bottom, hex, 4);
  memcpy(hex, hex + 4, 4);
  memcpy(hex + 4, bottom, 4);
}

uint64_t mixed(uint64_t x) {
  x = (x ^ x >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
  x = (x ^ x >> 27) * UINT64_C(0x94d049bb133111eb);
  return x ^ x >> 31;
}

/** What one hex says about the point at one of its corners. */
static uint64_t seen_from(const uint8_t hex[8], int corner, const uint64_t colours[256]) {
  uint64_t sum[4] = {0};
  for (int j = 0; j < 8; j++) {
    const int distance = size_of((unsigned)(hex_corner_bits[corner] ^ hex_corner_bits[j]));
    sum[distance] += mixed(colours[hex[j]] + 1);
  }
  return mixed(sum[1] * 3 + mixed(sum[2] * 5 + mixed(sum[3] + 7)));
}

uint64_t hexes_fingerprint(const uint8_t (*hexes)[8], int count, uint64_t colours[256],
                           int rounds) {
  for (int round = 0; round < rounds; round++) {
    uint64_t news[256] = {0};
    for (int h = 0; h < count; h++)
      for (int i = 0; i < 8; i++)
        news[hexes[h][i]] += seen_from(hexes[h], i, colours);
    for (int p = 0; p < 256; p++)
      colours[p] = news[p] ? mixed(colours[p] * 7 + news[p]) : colours[p];
  }
  uint64_t total = mixed((uint64_t)count);
  for (int h = 0; h < count; h++) {
    uint64_t sum = 0;
    for (int i = 0; i < 8; i++)
      sum += mixed(colours[hexes[h][i]]);
    total += mixed(sum);
  }
  return total;
}
