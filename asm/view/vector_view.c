/* vector_view.c - recognises vectors in registers and operands, and reads their
 * elements. */
#include "asm/view/vector_view.h"

#include <inttypes.h>
#include <string.h>

unsigned vector_width(enum asm_contents contents)
{
    switch (contents) {
    case ASM_WORDS: return 64;
    case ASM_HALF_WORDS: return 32;
    case ASM_BITS: return 1;
    default: return 0;
    }
}

const char *vector_elements(unsigned width)
{
    return width == 64 ? "words" : width == 32 ? "half words" : "bits";
}

void vector_extent(const struct vector_view *vector, const struct sink *sink)
{
    sink_print(sink, "%zu %s from %" PRIX64 " on", vector->length,
               vector_elements(vector->width), vector->address);
}

struct vector_view vector_described(c205_word word, unsigned width)
{
    return (struct vector_view){ .address = c205_descriptor_address(word),
                                 .length = c205_descriptor_length(word),
                                 .width = width };
}

bool vector_recognise(const c205 *machine, c205_word word, struct vector_view *vector)
{
    *vector = vector_described(word, 64);
    if (vector_is_mapped(machine, vector))
        return true;
    vector->width = 1;
    return vector_is_mapped(machine, vector);
}

bool vector_has_elements(const struct operand_view *operand)
{
    return operand->is_vector && !operand->is_bad && operand->length > 0
           && !strchr("xXzZ", operand->letter);
}

struct vector_view vector_of_operand(const struct instruction_view *view,
                                     const struct operand_view *operand)
{
    const struct operand_view *control = view_find(view, "z");
    struct vector_view vector = { .address = operand->address,
                                  .length = operand->length,
                                  .width = operand->width };
    vector.controlled = control && control->number != 0;
    if (vector.controlled)
        vector.control = control->address;
    return vector;
}

/* ---- Elements ---------------------------------------------------------------- */

bool vector_get(const c205 *machine, const struct vector_view *vector, size_t first,
                size_t count, c205_word *words)
{
    return vector->address % vector->width == 0
           && view_read(machine, vector->address, vector->width, first, count, words);
}

/* Returns true if the vector is mapped. It has at most 65,535 words, less than a page,
 * so it is in at most two pages. Checking the first and the last element is enough. */
bool vector_is_mapped(const c205 *machine, const struct vector_view *vector)
{
    c205_word word;
    return vector->length > 0 && vector_get(machine, vector, 0, 1, &word)
           && vector_get(machine, vector, vector->length - 1, 1, &word);
}

bool vector_control(const c205 *machine, const struct vector_view *vector, size_t i,
                    bool *bit)
{
    c205_word word;
    if (!vector->controlled || !view_read(machine, vector->control, 1, i, 1, &word))
        return false;
    *bit = word & 1;
    return true;
}
