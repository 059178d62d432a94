/* listing.h - source lines beside the words they became. */
#ifndef ASM_LISTING_H
#define ASM_LISTING_H

#include "asm/assemble.h"

void listing(const struct object *object, const struct sink *sink);

#endif
