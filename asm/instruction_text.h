/* instruction_text.h - one instruction as text.  Not public. */
#ifndef ASM_INSTRUCTION_TEXT_H
#define ASM_INSTRUCTION_TEXT_H

#include "base/sink.h"
#include "vm/c205.h"

/* Addresses, in order. */
struct addresses {
    uint64_t *items;
    size_t count, capacity;
};

bool addresses_hold(const struct addresses *addresses, uint64_t address);

/* Write the instruction in the high part of word, of which available half
 * words may be used; the labels that exist are called L and the address in
 * hex.  Returns how many half words were used. */
unsigned instruction_write(c205_word word, uint64_t address,
                           unsigned available, const struct addresses *labels,
                           const struct sink *sink);
/* The address that it branches to or enters; false: none. */
bool instruction_address(c205_word word, uint64_t address, uint64_t *target);

#endif
