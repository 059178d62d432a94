/* results.c - the request results, which returns the data that the program has
 * changed. */
#include <stdlib.h>

#include "asm/view/vector_view.h"
#include "web/engine/engine_internal.h"

/* Returns the element that the program's text states for an address, aligned as in
 * vector_get. */
static c205_word element_in_text(const struct object *object, uint64_t address,
                                 unsigned width)
{
    const c205_segment *segment = object_segment(object, address);
    c205_word word;
    if (!segment)
        return 0;
    word = segment->words[(address - segment->address) / 64] << address % 64;
    return width == 64 ? word : width == 32 ? word >> 32 << 32 : word >> 63;
}

struct difference {
    uint64_t first, count;
    c205_word *words; /* the current elements */
    bool *changed;    /* per element */
};

static void difference_free(struct difference *difference)
{
    free(difference->words);
    free(difference->changed);
}

/* Compares all elements with the program's text. Returns false if memory is
 * exhausted. */
static bool compare_elements(const struct engine *engine,
                             const struct vector_view *vector,
                             struct difference *difference)
{
    size_t length = vector->length;
    *difference = (struct difference){ .words = calloc(length, sizeof(c205_word)),
                                       .changed = calloc(length, sizeof(bool)) };
    if (!difference->words || !difference->changed)
        return false;
    if (!vector_get(engine_machine(engine), vector, 0, length, difference->words))
        return true;
    for (size_t i = length; i-- > 0;) {
        uint64_t address = vector->address + (uint64_t)i * vector->width;
        if (difference->words[i]
            == element_in_text(engine->object, address, vector->width))
            continue;
        difference->changed[i] = true;
        difference->first = i;
        difference->count++;
    }
    return true;
}

static void put_elements(const struct vector_view *vector,
                         const struct difference *difference, uint64_t first,
                         uint64_t most, struct json *reply)
{
    uint64_t left = vector->length - first;
    uint64_t end = first + (left < most ? left : most);
    json_array(reply, "values");
    for (uint64_t i = first; i < end; i++)
        if (vector->width == 1)
            json_text(reply, NULL, difference->words[i] & 1 ? "1" : "0");
        else
            put_number(reply, NULL, difference->words[i], vector->width == 32);
    json_end(reply);
    json_array(reply, "changed");
    for (uint64_t i = first; i < end; i++)
        json_bool(reply, NULL, difference->changed[i]);
    json_end(reply);
}

static void put_result(const struct asm_symbol *symbol,
                       const struct vector_view *vector,
                       const struct difference *difference, uint64_t most,
                       struct json *reply)
{
    uint64_t first = difference->first < most ? 0 : difference->first;
    json_object(reply, NULL);
    json_text(reply, "label", symbol->name);
    json_text(reply, "kind", vector_elements(vector->width));
    json_count(reply, "count", vector->length);
    json_count(reply, "differs", difference->count);
    json_count(reply, "first", first);
    put_elements(vector, difference, first, most, reply);
    json_end(reply);
}

/* Writes a label if the program has changed its data. Returns false if memory is
 * exhausted. */
static bool put_symbol(const struct engine *engine, const struct asm_symbol *symbol,
                       uint64_t most, struct json *reply)
{
    struct vector_view vector = { .address = (uint64_t)symbol->value,
                                  .length = (size_t)symbol->count,
                                  .width = vector_width(symbol->contents) };
    struct difference difference;
    bool good;
    if (!symbol->is_label || symbol->count == 0 || vector.width == 0)
        return true;
    good = compare_elements(engine, &vector, &difference);
    if (good && difference.count > 0)
        put_result(symbol, &vector, &difference, most, reply);
    difference_free(&difference);
    return good;
}

bool answer_results(struct engine *engine, const struct json_value *request,
                    struct json *reply, c205_error *error)
{
    const struct object *object = engine->object;
    uint64_t most = 16;
    bool good = true;
    if (!take_count(request, "elements", &most, error))
        return false;
    json_array(reply, "results");
    for (size_t i = 0; good && i < object->symbol_count; i++)
        good = put_symbol(engine, &object->symbols[i], most, reply);
    json_end(reply);
    return good || error_set(error, "out of memory");
}
