/* elements.c - shows the elements of vectors in memory as variables. */
#include <stdio.h>
#include <stdlib.h>

#include "asm/dap/variables.h"
#include "asm/view/word_text.h"

void put_bits(c205_word word, unsigned width, const struct sink *sink)
{
    struct word_text text = word_text(word, width == 32);
    if (width == 1)
        sink_print(sink, "%u", (unsigned)word & 1);
    else
        sink_print(sink, "%s  X'%s'", text.number, text.hex);
}

/* Prints the control bit, which determines whether the result of an element is
 * stored. */
static void put_control(const struct dap *dap, const struct vector_view *vector,
                        size_t i, const struct sink *sink)
{
    bool bit;
    if (vector_control(machine_of(dap->debugger), vector, i, &bit))
        sink_print(sink, "  ? %d", bit);
}

static void put_element(struct dap *dap, struct json *json,
                        const struct vector_view *vector, size_t i)
{
    uint64_t address = vector->address + (uint64_t)i * vector->width;
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    char name[DAP_ADDRESS_SIZE];
    c205_word word;
    snprintf(name, sizeof name, "[%zu]", i);
    if (vector_get(machine_of(dap->debugger), vector, i, 1, &word)) {
        put_bits(word, vector->width, &sink);
        put_control(dap, vector, i, &sink);
    } else {
        sink_put(&sink, "no memory is mapped there");
    }
    put_variable(json, name, text.text, 0);
    if (vector->width == 64) {
        snprintf(name, sizeof name, "[0x%llX]", (unsigned long long)address);
        json_text(json, "evaluateName", name);
    }
    if (vector->width >= 8)
        dap_put_address(json, "memoryReference", address);
    json_end(json);
}

void put_elements(struct dap *dap, struct json *json, const struct vector_view *vector,
                  size_t first, size_t count)
{
    for (size_t i = first; i < vector->length && i - first < count; i++)
        put_element(dap, json, vector, i);
}

bool element_number(const struct vector_view *vector, const char *name, size_t *number)
{
    char *end;
    unsigned long value;
    if (name[0] != '[' || name[1] < '0' || name[1] > '9')
        return false;
    value = strtoul(name + 1, &end, 10);
    *number = (size_t)value;
    return end[0] == ']' && end[1] == '\0' && value < vector->length;
}
