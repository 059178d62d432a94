/* print.c - prints values, registers and vectors in memory. */
#include <ctype.h>
#include <inttypes.h>

#include "asm/debug/debug_internal.h"
#include "asm/view/vector_view.h"
#include "asm/view/word_text.h"

/* ---- Values --------------------------------------------------------------- */

void show_word(c205_word word, bool half, const struct sink *sink)
{
    struct word_text text = word_text(word, half);
    sink_print(sink, "X'%s'  number %s", text.hex, text.number);
    if (!half && c205_descriptor_length(word) == 0)
        sink_print(sink, "  address %" PRIX64, word);
    else if (!half)
        sink_print(sink, "  length %u, address %" PRIX64,
                   (unsigned)c205_descriptor_length(word),
                   c205_descriptor_address(word));
    sink_put(sink, "\n");
}

bool verb_print(struct debugger *debugger, struct text_cursor *cursor)
{
    struct text_cursor again = *cursor;
    struct register_of named;
    struct value_of value;
    if (debug_register(debugger, &again, &named) && text_cursor_end(&again)) {
        show_word(debug_register_word(debugger, named), named.half, &debugger->out);
        return true;
    }
    if (!debug_value(debugger, cursor, &value) || !text_cursor_finish(debugger, cursor))
        return false;
    if (value.is_word)
        show_word(value.word, value.is_half, &debugger->out);
    else if (value.is_real)
        sink_print(&debugger->out, "%.15g\n", value.real);
    else
        sink_print(&debugger->out, "%" PRId64 "  X'%" PRIX64 "'\n", value.integer,
                   (uint64_t)value.integer);
    return true;
}

bool verb_assert(struct debugger *debugger, struct text_cursor *cursor)
{
    struct value_of value;
    const char *text;
    text_cursor_skip(cursor);
    text = cursor->at;
    if (!debug_value(debugger, cursor, &value) || !text_cursor_finish(debugger, cursor))
        return false;
    return debug_is_true(&value)
           || debug_fault(debugger, "assertion failed: %.200s", text);
}

/* ---- Vectors -------------------------------------------------------------- */

enum { ELEMENTS_USUAL = 16 };

/* The layout of the elements of a vector. */
struct element_look {
    struct vector_view of;
    char format; /* f: numbers, i: integers, x: hex, b: bits */
};

static void put_element(const struct debugger *debugger,
                        const struct element_look *look, c205_word word)
{
    bool half = look->of.width == 32;
    struct word_text text = word_text(word, half);
    if (look->of.width == 1)
        sink_print(&debugger->out, "%u", (unsigned)word);
    else if (look->format == 'i')
        sink_print(&debugger->out, "  %14" PRId64,
                   half ? (int64_t)(int32_t)(word >> 24) / 256 : c205_to_integer(word));
    else
        sink_print(&debugger->out, "  %14s",
                   look->format == 'x' ? text.hex : text.number);
}

static unsigned in_row(const struct element_look *look)
{
    return look->of.width == 1 ? 64 : look->format == 'x' ? 3 : 4;
}

/* Prints an element. Returns false if the element or its control bit is not mapped. */
static bool put_element_at(const struct debugger *debugger,
                           const struct element_look *look, size_t i)
{
    const struct vector_view *of = &look->of;
    c205_word word;
    bool bit = false;
    if (!view_read(machine_of(debugger), of->address, of->width, i, 1, &word)
        || (of->controlled && !vector_control(machine_of(debugger), of, i, &bit)))
        return false;
    if (i % in_row(look) == 0)
        sink_print(&debugger->out, "%6zu%s", i, of->width == 1 ? "  " : "");
    if (of->controlled)
        sink_print(&debugger->out, "  %d", bit);
    put_element(debugger, look, word);
    return true;
}

static bool put_elements(struct debugger *debugger, const struct element_look *look,
                         size_t count)
{
    unsigned row = in_row(look);
    bool good = true;
    size_t i;
    for (i = 0; i < count && good; i += good) {
        good = put_element_at(debugger, look, i);
        if (good && (i % row == row - 1 || i + 1 == count))
            sink_put(&debugger->out, "\n");
    }
    if (!good && i % row != 0)
        sink_put(&debugger->out, "\n");
    return good || debug_fault(debugger, "not all of this memory is mapped");
}

/* Parses "/", a count and letters. f selects numbers, i integers, x hex, h half words,
 * and b bits. */
static bool read_format(struct debugger *debugger, struct text_cursor *cursor,
                        struct element_look *look, uint64_t *count)
{
    if (!text_cursor_sign(cursor, "/"))
        return true;
    for (; *cursor->at && !isspace((unsigned char)*cursor->at); cursor->at++) {
        char c = *cursor->at;
        if (isdigit((unsigned char)c) && *count != UINT64_MAX
            && *count > C205_MAX_LENGTH)
            return debug_fault(debugger, "the count must be at most %u",
                               C205_MAX_LENGTH);
        if (isdigit((unsigned char)c))
            *count = (*count == UINT64_MAX ? 0 : *count) * 10 + (uint64_t)(c - '0');
        else if (c == 'h')
            look->of.width = 32;
        else if (c == 'b')
            look->of.width = 1;
        else if (c == 'f' || c == 'i' || c == 'x')
            look->format = c;
        else
            return debug_fault(debugger,
                               "expected a count, f, i, x, h or b after /, found '%c'",
                               c);
    }
    return true;
}

static bool read_control(struct debugger *debugger, struct text_cursor *cursor,
                         struct element_look *look)
{
    struct register_of named;
    if (!text_cursor_sign(cursor, "?"))
        return text_cursor_finish(debugger, cursor);
    if (!debug_register(debugger, cursor, &named))
        return debug_fault(debugger,
                           "expected the register of a control vector after ?");
    look->of.controlled = true;
    look->of.control = c205_descriptor_address(debug_register_word(debugger, named));
    return text_cursor_finish(debugger, cursor);
}

/* Sets the width and the count if a label has this address. They come from the data
 * that the program declares there. A width in the command must match. */
static void look_at_label(const struct debugger *debugger, uint64_t address,
                          bool width_asked, struct element_look *look)
{
    const struct object *object = debugger->setup.object;
    for (size_t i = 0; i < object->symbol_count; i++) {
        const struct asm_symbol *symbol = &object->symbols[i];
        unsigned width = vector_width(symbol->contents);
        if (!symbol->is_label || (uint64_t)symbol->value != address || width == 0
            || (width_asked && width != look->of.width))
            continue;
        look->of.width = width;
        look->of.length = symbol->count < C205_MAX_LENGTH ? (size_t)symbol->count
                                                          : C205_MAX_LENGTH;
        sink_print(&debugger->out, "%zu at %s\n", look->of.length, symbol->name);
        return;
    }
}

/* Executes x [/COUNT LETTERS] REGISTER | ADDRESS [? REGISTER], which prints
 * elements. */
bool verb_x(struct debugger *debugger, struct text_cursor *cursor)
{
    struct element_look look = { .of = { .width = 64 }, .format = 'f' };
    uint64_t count = UINT64_MAX, address;
    struct register_of named;
    unsigned width;
    if (!read_format(debugger, cursor, &look, &count))
        return false;
    width = look.of.width;
    if (debug_register(debugger, cursor, &named)) {
        look.of = vector_described(debug_register_word(debugger, named), width);
        sink_print(&debugger->out, "%zu from %" PRIX64 " on\n", look.of.length,
                   look.of.address);
    } else if (debug_address(debugger, cursor, &address)) {
        look.of.address = address;
        look.of.length = count == UINT64_MAX ? ELEMENTS_USUAL : (size_t)count;
        if (count == UINT64_MAX)
            look_at_label(debugger, address, width != 64, &look);
    } else {
        return false;
    }
    if (!read_control(debugger, cursor, &look))
        return false;
    if (count == UINT64_MAX)
        count = look.of.width == 1 ? 64 : ELEMENTS_USUAL;
    if (count > look.of.length)
        count = look.of.length;
    return put_elements(debugger, &look, (size_t)count);
}
