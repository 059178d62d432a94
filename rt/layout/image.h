/* image.h - collects the contents of memory at the start of a program, and loads them
 * into machines.
 *
 * A scene is converted to words only once. Each machine that traces a part of the frame
 * gets a copy.
 */
#ifndef RT_IMAGE_H
#define RT_IMAGE_H

#include <stdbool.h>

#include "vm/c205.h"

/* Words at consecutive addresses. A block is either memory that the image maps, or
 * words of the program that it overwrites. */
struct image_block {
    uint64_t address;
    size_t count;
    c205_word *words;    /* NULL: the words are zeros or in `shared` */
    c205_shared *shared; /* read-only words that machines share */
    bool mapped;
};

struct image {
    size_t count;
    struct image_block *blocks;
};

/* Adds a block of zeros. Returns false if out of memory. */
bool image_reserve(struct image *image, uint64_t address, size_t count);
/* Writes words into a reserved block, or over words of the program. Returns false
 * if out of memory. */
bool image_write(struct image *image, uint64_t address, const c205_word *words,
                 size_t count);
/* Ends the writing of the image. The machines then share the blocks that they only
 * read, if memory permits. */
void image_share(struct image *image);
/* Loads the image into a machine's memory. The image must outlive all use of the
 * machine. */
bool image_load(const struct image *image, c205 *machine, c205_error *error);
void image_free(struct image *image);

#endif
