/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Time and memory of the topological methods, against the size of what they make. */
#ifndef HEXCON_BENCH_TOPOLOGICAL_H
#define HEXCON_BENCH_TOPOLOGICAL_H

/**
 * Mesh bent cubes of 10^3, 10^4, 10^5 and 10^6 quads by every topological method without a
 * certificate, each in a process of its own; by one also cubes numbered at random, where time goes
 * to caches. Prints a table: seconds of processor
 * time, of every stage too, what they are of the time that copying the mesh takes, and what the
 * process's peak memory is of the mesh's; sizes that would not fit into memory are left out.
 */
void bench_topological(void);

#endif
