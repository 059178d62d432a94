/* disassemble.h - turns words into text that assembles to the same words.
 *
 * A segment that contains the entry or the start of a region is decoded as code from
 * its start; other segments are data. A word that the language cannot express becomes a
 * .half. It is an undefined instruction or has bits that its format does not use.
 * Labels without a name in the object are L and the address.
 */
#ifndef ASM_DISASSEMBLE_H
#define ASM_DISASSEMBLE_H

#include "asm/object/object.h"

/* Writes the program as text of the assembler. Returns false if memory is exhausted. */
bool disassemble(const struct object *object, const struct sink *sink);

enum { DISASSEMBLE_TEXT_SIZE = TEXT_LINE_SIZE };
/* Writes one instruction at a bit address. A short instruction is in the high half of
 * the word. Returns its length in half words. An instruction that the language cannot
 * express is written as one .half. */
unsigned disassemble_one(c205_word word, uint64_t address,
                         char text[DISASSEMBLE_TEXT_SIZE]);

#endif
