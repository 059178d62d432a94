/* instruction_text.h - writes an instruction as text. Not public. */
#ifndef ASM_INSTRUCTION_TEXT_H
#define ASM_INSTRUCTION_TEXT_H

#include "base/sink.h"
#include "vm/c205.h"

/* An address with a label in the text. */
struct label {
    uint64_t address;
    const char *name; /* NULL: L and the address in hex */
};

/* Labels, sorted by address. */
struct labels {
    struct label *items;
    size_t count, capacity;
};

/* Returns the label at an address, or NULL. */
const struct label *label_at(const struct labels *labels, uint64_t address);
/* Writes the label of an address, or the address as a number. */
void label_write(const struct labels *labels, uint64_t address,
                 const struct sink *sink);

/* Writes the instruction in the high part of a word, with labels for addresses.
 * available is the number of half words that it may occupy; a longer instruction is
 * written as .half. Returns the length in half words. */
unsigned instruction_write(c205_word word, uint64_t address, unsigned available,
                           const struct labels *labels, const struct sink *sink);
/* Returns true and sets *target if the instruction branches to an address or enters an
 * address into a register. */
bool instruction_address(c205_word word, uint64_t address, uint64_t *target);

#endif
