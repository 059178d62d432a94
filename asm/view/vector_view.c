/* vector_view.c - recognises vectors in registers and operands, and
 * reads their elements. */
#include "asm/view/vector_view.h"

#include <string.h>

const char *vector_elements(unsigned width)
{
    return width == 64 ? "words" : width == 32 ? "half words" : "bits";
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

/* Makes the view that the reader of operands needs. */
static struct operand_view elements_at(uint64_t address, size_t length, unsigned width)
{
    return (struct operand_view){ .letter = 'v',
                                  .is_vector = true,
                                  .width = width,
                                  .address = address,
                                  .length = length };
}

bool vector_get(const c205 *machine, const struct vector_view *vector, size_t first,
                size_t count, c205_word *words)
{
    struct operand_view elements = elements_at(vector->address, vector->length,
                                               vector->width);

    return vector->address % vector->width == 0
           && view_read(machine, &elements, first, count, words);
}

/* A vector of words has at most 65,535 elements, less than a page, so it is in at most
 * two pages. The first and the last element are enough to check both. */
bool vector_is_mapped(const c205 *machine, const struct vector_view *vector)
{
    c205_word word;

    return vector->length > 0 && vector_get(machine, vector, 0, 1, &word)
           && vector_get(machine, vector, vector->length - 1, 1, &word);
}

bool vector_control(const c205 *machine, const struct vector_view *vector, size_t i,
                    bool *bit)
{
    struct operand_view bits = elements_at(vector->control, vector->length, 1);
    c205_word word;

    if (!vector->controlled || !view_read(machine, &bits, i, 1, &word))
        return false;
    *bit = word & 1;
    return true;
}
