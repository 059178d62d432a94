/* registers.c - writes registers and vectors as numbers and as bits. */
#include <stdlib.h>

#include "asm/view/vector_view.h"
#include "asm/view/word_text.h"
#include "web/engine/engine_internal.h"

/* ---- Words --------------------------------------------------------------- */

void put_hex(struct json *json, const char *key, c205_word word)
{
    struct word_text text = word_text(word, false);
    json_text(json, key, text.hex);
}

void put_number(struct json *json, const char *key, c205_word word, bool half)
{
    struct word_text text = word_text(word, half);
    json_text(json, key, text.number);
}

/* ---- Registers ----------------------------------------------------------- */

static bool is_written(const struct engine *engine, unsigned number)
{
    const c205_event *last = debugger_last(engine->debugger);
    return last && last->written[number / 64] >> number % 64 & 1;
}

static void put_descriptor(const struct engine *engine, c205_word word,
                           struct json *reply)
{
    struct vector_view vector;
    if (!vector_recognise(engine_machine(engine), word, &vector))
        return;
    json_object(reply, "descriptor");
    json_count(reply, "address", vector.address);
    json_count(reply, "count", vector.length);
    json_text(reply, "kind", vector_elements(vector.width));
    json_text(reply, "label", object_label(engine->object, vector.address));
    json_end(reply);
}

static void put_halves(const struct engine *engine, unsigned number, struct json *reply)
{
    static const char *const keys[] = { "left", "right" };
    for (unsigned side = 0; side < 2; side++) {
        const char *name = object_register_name(engine->object, 2 * number + side,
                                                true);
        if (!*name)
            continue;
        json_object(reply, keys[side]);
        json_count(reply, "number", 2 * number + side);
        json_text(reply, "name", name);
        put_number(reply, "text",
                   view_register(engine_machine(engine), 2 * number + side, true),
                   true);
        json_end(reply);
    }
}

static void put_register(const struct engine *engine, unsigned number,
                         struct json *reply)
{
    c205_word word = c205_register(engine_machine(engine), number);
    json_object(reply, NULL);
    json_count(reply, "number", number);
    json_text(reply, "name", object_register_name(engine->object, number, false));
    put_hex(reply, "hex", word);
    put_number(reply, "text", word, false);
    json_number(reply, "integer", (double)c205_to_integer(word));
    put_descriptor(engine, word, reply);
    put_halves(engine, number, reply);
    json_bool(reply, "changed", is_written(engine, number));
    json_end(reply);
}

static bool is_shown(const struct engine *engine, unsigned number)
{
    return c205_register(engine_machine(engine), number) != 0
           || *object_register_name(engine->object, number, false)
           || *object_register_name(engine->object, 2 * number, true)
           || *object_register_name(engine->object, 2 * number + 1, true)
           || is_written(engine, number);
}

void put_registers(const struct engine *engine, bool all, struct json *reply)
{
    json_array(reply, "registers");
    for (unsigned i = 0; i < C205_REGISTERS; i++)
        if (all || is_shown(engine, i))
            put_register(engine, i, reply);
    json_end(reply);
}

/* ---- Vectors ------------------------------------------------------------- */

enum { MAX_VECTORS = 256, MAX_ELEMENTS = 65536 };

/* Returns the width of an element in bits, or 0 if the symbol has no elements. */
static unsigned symbol_width(const struct asm_symbol *symbol)
{
    return symbol->is_label && symbol->count > 0 ? vector_width(symbol->contents) : 0;
}

/* Writes the ranges of elements that the last instruction stored. */
static bool put_stored(const struct engine *engine, const struct vector_view *vector,
                       struct json *reply)
{
    const c205_event *last = debugger_last(engine->debugger);
    uint64_t from = vector->address;
    uint64_t end = from + (uint64_t)vector->length * vector->width;
    bool any = false;
    json_array(reply, "stored");
    for (size_t i = 0; last && i < last->store_count; i++) {
        uint64_t low = last->store[i].address;
        uint64_t high = low + last->store[i].bits;
        low = low < from ? from : low;
        high = high > end ? end : high;
        if (low >= high)
            continue;
        any = true;
        json_object(reply, NULL);
        json_count(reply, "first", (low - from) / vector->width);
        json_count(reply, "count",
                   (high - 1 - from) / vector->width - (low - from) / vector->width
                       + 1);
        json_end(reply);
    }
    json_end(reply);
    return any;
}

/* Writes numbers as a list of texts, and bits as one text. */
static bool put_values(const struct engine *engine, const struct vector_view *vector,
                       size_t first, size_t count, struct json *reply)
{
    c205_word *words = malloc((count + 1) * sizeof *words);
    char *bits = vector->width == 1 ? calloc(count + 1, 1) : NULL;
    bool good = words && (bits || vector->width != 1);
    bool mapped = good
                  && vector_get(engine_machine(engine), vector, first, count, words);
    if (good && !bits)
        json_array(reply, "values");
    for (size_t i = 0; mapped && i < count; i++)
        if (bits)
            bits[i] = words[i] & 1 ? '1' : '0';
        else
            put_number(reply, NULL, words[i], vector->width == 32);
    if (bits)
        json_text(reply, "values", bits);
    else if (good)
        json_end(reply);
    free(words);
    free(bits);
    return good;
}

struct window {
    uint64_t first, most;
};

static bool put_symbol(const struct engine *engine, const struct asm_symbol *symbol,
                       const struct window *window, struct json *reply)
{
    struct vector_view vector = { .address = (uint64_t)symbol->value,
                                  .length = (size_t)symbol->count,
                                  .width = symbol_width(symbol) };
    uint64_t first = window->first < symbol->count ? window->first : 0;
    uint64_t left = symbol->count - first;
    bool good;
    json_object(reply, NULL);
    json_text(reply, "label", symbol->name);
    json_text(reply, "kind", vector_elements(vector.width));
    json_count(reply, "address", vector.address);
    json_count(reply, "count", symbol->count);
    json_count(reply, "first", first);
    good = put_values(engine, &vector, (size_t)first,
                      (size_t)(left < window->most ? left : window->most), reply);
    json_bool(reply, "changed", put_stored(engine, &vector, reply));
    json_end(reply);
    return good;
}

/* Reads the index of the first element to write, from a member such as "first": { "x":
 * 100 }. */
static bool take_window(const struct json_value *request, const char *label,
                        struct window *window, c205_error *error)
{
    window->first = 0;
    return take_count(json_member(request, "first"), label, &window->first, error);
}

bool put_vectors(const struct engine *engine, const struct json_value *request,
                 struct json *reply, c205_error *error)
{
    const struct object *object = engine->object;
    const struct json_value *first = json_member(request, "first");
    struct window window = { 0, 64 };
    size_t count = 0;
    bool good = true;
    if (!take_count(request, "elements", &window.most, error))
        return false;
    if (first && first->kind != JSON_OBJECT)
        return error_set(error, "\"first\" must have names with integers");
    if (window.most > MAX_ELEMENTS)
        return error_set(error, "\"elements\" must be at most %d", MAX_ELEMENTS);
    json_array(reply, "vectors");
    for (size_t i = 0; good && i < object->symbol_count; i++) {
        const struct asm_symbol *symbol = &object->symbols[i];
        if (symbol_width(symbol) == 0 || count++ >= MAX_VECTORS)
            continue;
        good = take_window(request, symbol->name, &window, error)
               && (put_symbol(engine, symbol, &window, reply)
                   || error_set(error, "out of memory"));
    }
    json_end(reply);
    return good;
}
