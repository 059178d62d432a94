/* vector_view.h - finds and reads the vector that a register, an operand or a label
 * describes. */
#ifndef ASM_VECTOR_VIEW_H
#define ASM_VECTOR_VIEW_H

#include "asm/object/object.h"
#include "asm/view/operand_view.h"
#include "base/sink.h"

struct vector_view {
    uint64_t address;
    size_t length;
    unsigned width; /* bits per element: 64, 32 or 1 */
    bool controlled;
    uint64_t control; /* bit address of the control vector */
};

/* Returns the width of the elements at a label, or 0 if they are not a vector. */
unsigned vector_width(enum asm_contents contents);
/* Returns the name of the elements: "words", "half words" or "bits". */
const char *vector_elements(unsigned width);
/* Prints the extent, as in "100 words from 801900 on". */
void vector_extent(const struct vector_view *vector, const struct sink *sink);

/* Returns the vector that a descriptor describes. width is the size of its elements in
 * bits. */
struct vector_view vector_described(c205_word word, unsigned width);
/* Interprets a word as the descriptor of a vector of words if all of its elements are
 * mapped, and otherwise of a bit vector. Returns false if neither is possible. */
bool vector_recognise(const c205 *machine, c205_word word, struct vector_view *vector);
/* vector_has_elements returns true if an operand has a known number of elements.
 * vector_of_operand then returns its elements and their control bits. */
bool vector_has_elements(const struct operand_view *operand);
struct vector_view vector_of_operand(const struct instruction_view *view,
                                     const struct operand_view *operand);

/* Returns true if the whole vector is in mapped memory. */
bool vector_is_mapped(const c205 *machine, const struct vector_view *vector);
/* Reads elements from `first` on. Elements of 32 bits are left-aligned in words. Bits
 * are right-aligned. Returns false if memory is not mapped or the address is not a
 * multiple of the width. */
bool vector_get(const c205 *machine, const struct vector_view *vector, size_t first,
                size_t count, c205_word *words);
/* Sets *bit to the control bit of an element and returns true, or returns false if
 * there is none. The bit determines whether the result of the element is stored. */
bool vector_control(const c205 *machine, const struct vector_view *vector, size_t i,
                    bool *bit);

#endif
