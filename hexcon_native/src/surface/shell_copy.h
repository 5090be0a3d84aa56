/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Single shells of a surface, as surfaces of their own. */
#ifndef HEXCON_SURFACE_SHELL_COPY_H
#define HEXCON_SURFACE_SHELL_COPY_H

#include "half_edges.h"

/** What all copies share, so that to copy all shells is linear. */
typedef struct shell_copies {
  const surface *s;
  size_t *first;      /**< [component_count + 1] into quads */
  int32_t *quads;     /**< [quad_count] by shell, ascending in each */
  int32_t *new_quad;  /**< [quad_count] row in its shell's copy */
  int32_t *new_point; /**< [point_count] row in its shell's copy; -1: not yet copied */
} shell_copies;

/** @param out  free with shell_copies_free, also after an error. Linear. @return OUT_OF_MEMORY */
hexcon_status shell_copies_new(hexcon_context *context, const surface *s, shell_copies *out);
void shell_copies_free(hexcon_context *context, shell_copies *copies);

/**
 * One shell with ids 0, 1, 2 ... of its own: its quads keep their order. Each may be taken once.
 * @param s  with points
 * @param shell  free with shell_copy_free, also after an error
 * @return OUT_OF_MEMORY. Linear in the shell.
 */
hexcon_status shell_copies_take(hexcon_context *context, shell_copies *copies, size_t component,
                                surface *shell);
/** Frees its points as well, which surface_free leaves alone. */
void shell_copy_free(hexcon_context *context, surface *shell);

/** The surface's id for a quad of a copy. */
int32_t shell_copies_quad(const shell_copies *copies, size_t component, int32_t quad);

#endif
