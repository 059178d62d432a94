/* vector_view.h - elements in memory: what a register or an operand describes, or what
 * lies at a label.
 */
#ifndef ASM_VECTOR_VIEW_H
#define ASM_VECTOR_VIEW_H

#include "asm/operand_view.h"

struct vector_view {
    uint64_t address;
    size_t length;
    unsigned width; /* of an element in bits: 64, 32, 1 */
    bool controlled;
    uint64_t control; /* where its control bits are */
};

/* "words", "half words", "bits" */
const char *vector_elements(unsigned width);

/* The descriptor that a word of a register is then. */
struct vector_view vector_described(c205_word word, unsigned width);
/* .. as words if there is memory for all of them, else as bits; false: it is neither. */
bool vector_recognise(const c205 *machine, c205_word word, struct vector_view *vector);
/* Whether an operand has elements that can be counted, and these, with their control
 * bits. */
bool vector_has_elements(const struct operand_view *operand);
struct vector_view vector_of_operand(const struct instruction_view *view,
                                     const struct operand_view *operand);

/* Whether all of it is in mapped memory. */
bool vector_is_mapped(const c205 *machine, const struct vector_view *vector);
/* Elements from one on, those of 32 bits at the left of words, bits at the right.  False: there
 * is no memory, or they do not lie on addresses of their width. */
bool vector_get(const c205 *machine, const struct vector_view *vector, size_t first,
                size_t count, c205_word *words);
/* The bit that lets the result of an element be stored, or not; false: there is none. */
bool vector_control(const c205 *machine, const struct vector_view *vector, size_t i,
                    bool *bit);

#endif
