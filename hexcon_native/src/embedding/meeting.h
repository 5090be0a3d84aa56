/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What is proved of two patches, or of two cells of theirs. */
#ifndef HEXCON_EMBEDDING_MEETING_H
#define HEXCON_EMBEDDING_MEETING_H

typedef enum meeting {
  MEETING_NONE,   /**< proved: they have in common what they share, and nothing else */
  MEETING_PROVED, /**< proved: they meet elsewhere */
  MEETING_OPEN    /**< nearer to each other than rounding, or the effort, can tell */
} meeting;

#endif
