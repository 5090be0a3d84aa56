/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The one table of methods: all that dispatches, checks options or tells users reads it. */
#ifndef HEXCON_SOLVE_METHODS_H
#define HEXCON_SOLVE_METHODS_H

#include "solve/common/method_function.h"

typedef struct method_row {
  hexcon_method_facts facts;
  method_function fill; /**< NULL: auto */
} method_row;

/** @return NULL if there is no such method */
const method_row *method_find(hexcon_method method);

/** The try of `auto` with this turn, and whose it is. @return NULL if there is none */
const hexcon_method_try *method_try_of_turn(int turn, const method_row **row);

/** Facts of a method by which some of them are chosen. */
typedef bool (*method_predicate)(const hexcon_method_facts *facts);

/** Room for what method_list writes. */
enum { METHOD_LIST = 256 };

/** Names of the methods that are so: "diced, cells". @param text [METHOD_LIST] */
void method_list(method_predicate is_so, char *text);

#endif
