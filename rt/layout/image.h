/* image.h - what memory is to hold before a program begins.
 *
 * A scene is turned into words once; every machine that traces a part of the
 * frame gets a copy.
 */
#ifndef RT_IMAGE_H
#define RT_IMAGE_H

#include <stdbool.h>

#include "vm/c205.h"

/* Words from an address on: mapped by the image, or of what the program has
 * there anyway. */
struct image_block {
    uint64_t address;
    size_t count;
    c205_word *words;    /* NULL: zeros, or .. */
    c205_shared *shared; /* .. these */
    bool mapped;
};

struct image {
    size_t count;
    struct image_block *blocks;
};

/* A block of zeros.  False: no memory. */
bool image_reserve(struct image *image, uint64_t address, size_t count);
/* Words into a block that was reserved, or among those of the program.
 * False: no memory. */
bool image_write(struct image *image, uint64_t address, const c205_word *words,
                 size_t count);
/* Nothing more is written: machines have in common what they only read, as far as there
 * is memory for that. */
void image_share(struct image *image);
/* Into a machine's memory; the image stays as long as that runs or is looked at. */
bool image_load(const struct image *image, c205 *machine, c205_error *error);
void image_free(struct image *image);

#endif
