/* listing.h - prints each source line with its words in hex. */
#ifndef ASM_LISTING_H
#define ASM_LISTING_H

#include "asm/object/object.h"

void listing(const struct object *object, const struct sink *sink);

#endif
