/* instruction_text.h - one instruction as text.  Not public. */
#ifndef ASM_INSTRUCTION_TEXT_H
#define ASM_INSTRUCTION_TEXT_H

#include "base/sink.h"
#include "vm/c205.h"

/* An address that a text names. */
struct label {
    uint64_t address;
    const char *name; /* NULL: it is called L and the address in hex */
};

/* In the order of their addresses. */
struct labels {
    struct label *items;
    size_t count, capacity;
};

/* NULL: it has none. */
const struct label *label_at(const struct labels *labels, uint64_t address);
/* Its name, or the address as a number. */
void label_write(const struct labels *labels, uint64_t address,
                 const struct sink *sink);

/* Write the instruction in the high part of word, of which available half
 * words may be used; addresses that have labels are called by them.  Returns how many half words were used. */
unsigned instruction_write(c205_word word, uint64_t address, unsigned available,
                           const struct labels *labels, const struct sink *sink);
/* The address that it branches to or enters; false: none. */
bool instruction_address(c205_word word, uint64_t address, uint64_t *target);

#endif
