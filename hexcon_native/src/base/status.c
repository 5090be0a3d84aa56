/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "hexcon.h"

#define FACTS(name, meaning, elements, advice) {#name, meaning, elements, advice},
static const hexcon_status_facts facts[HEXCON_STATUS_COUNT] = {{"OK", "", "", ""},
                                                               HEXCON_STATUSES(FACTS)};
#undef FACTS

const char *hexcon_version(void) {
  return HEXCON_VERSION;
}

const hexcon_status_facts *hexcon_status_info(int status) {
  return status >= 0 && status < HEXCON_STATUS_COUNT ? &facts[status] : NULL;
}

const char *hexcon_status_name(int status) {
  const hexcon_status_facts *found = hexcon_status_info(status);
  return found ? found->name : NULL;
}
