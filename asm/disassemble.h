/* disassemble.h - from words back to text that assembles to the same words.
 *
 * Segments that hold the entry or a region are read as code from their
 * beginning, the others as data.  An instruction word that the language
 * cannot express (undefined, or bits set that its format has no name for)
 * becomes a .half.  Labels have the names that the object knows; others are
 * called L and the address.
 */
#ifndef ASM_DISASSEMBLE_H
#define ASM_DISASSEMBLE_H

#include "asm/assemble.h"

/* False: the host has no memory left. */
bool disassemble(const struct object *object, const struct sink *sink);

enum { DISASSEMBLE_TEXT_SIZE = TEXT_LINE_SIZE };
/* One instruction, in the high half of word if it is short, as it is at
 * a bit address.  Returns its length in half words; one that the language
 * cannot express is one .half. */
unsigned disassemble_one(c205_word word, uint64_t address,
                         char text[DISASSEMBLE_TEXT_SIZE]);

#endif
