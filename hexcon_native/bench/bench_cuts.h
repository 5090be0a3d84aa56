/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Time of bodies with holes through them, against their size and the number of holes. */
#ifndef HEXCON_BENCH_CUTS_H
#define HEXCON_BENCH_CUTS_H

/**
 * Mesh plates with a row of square holes by method sheets, whose cuts leave balls that are swept or
 * filled by sheets: of 4 holes, ever finer, and of ever more holes, as fine. Prints two tables of
 * processor seconds with exponents between neighbouring rows: by quads, and by holes and quads
 * alike.
 */
void bench_cuts(void);

#endif
