/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Method `auto`: the best of what the other methods for solvers make of a surface. */
#ifndef HEXCON_SOLVE_AUTO_MESH_AUTO_H
#define HEXCON_SOLVE_AUTO_MESH_AUTO_H

#include "solve/common/method_function.h"

/**
 * Try the methods in the order of what their meshes are worth, until one is certified and good;
 * keep the best. Each is told of in the log, and so is the choice. After a certified mesh a further
 * method is worth a part of its effort, and of the time that is left: that of the worst scaled
 * Jacobian that it can still win.
 * @param fill  fills by options->method and certifies the result, whatever the certificate says
 * @param mesh  empty; receives the best
 * Errors: the last method's where none makes a mesh; CANCELLED, OUT_OF_MEMORY, OUT_OF_TIME. A mesh
 * that is not certified is handed out only where there is no other.
 */
hexcon_status mesh_auto(hexcon_context *context, const surface *s,
                        const hexcon_mesh_options *options, method_function fill,
                        hexcon_mesh *mesh);

#endif
