/* print.c - prints values, registers and vectors in memory. */
#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>

#include "asm/debug/debug_internal.h"
#include "asm/view/operand_view.h"

/* ---- Values --------------------------------------------------------------- */

void show_word(c205_word word, bool half, const struct sink *sink)
{
    char hex[C205_TEXT_SIZE], text[C205_TEXT_SIZE];

    c205_to_hex(word, hex);
    (half ? c205_half_to_text : c205_to_text)(word, text);
    if (half)
        hex[9] = '\0';
    sink_print(sink, "X'%s'  number %s", hex, text);
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

/* How the elements of a vector are shown. */
struct element_look {
    struct operand_view of;
    char format; /* f numbers, i integers, x hex, b bits */
    bool controlled;
    struct operand_view control;
};

static void put_element(const struct debugger *debugger,
                        const struct element_look *look, c205_word word)
{
    bool half = look->of.width == 32;
    char text[C205_TEXT_SIZE];

    if (look->of.width == 1)
        snprintf(text, sizeof text, "%u", (unsigned)word);
    else if (look->format == 'x')
        c205_to_hex(word, text);
    else if (look->format == 'i')
        snprintf(text, sizeof text, "%" PRId64,
                 half ? (int64_t)(int32_t)(word >> 24) / 256 : c205_to_integer(word));
    else
        (half ? c205_half_to_text : c205_to_text)(word, text);
    if (half && look->format == 'x')
        text[9] = '\0';
    sink_print(&debugger->out, look->of.width == 1 ? "%s" : "  %14s", text);
}

static unsigned in_row(const struct element_look *look)
{
    return look->of.width == 1 ? 64 : look->format == 'x' ? 3 : 4;
}

/* Returns false if the element or its control bit is not mapped. */
static bool put_element_at(const struct debugger *debugger,
                           const struct element_look *look, size_t i)
{
    c205_word word, bit = 0;

    if (!view_read(machine_of(debugger), &look->of, i, 1, &word)
        || (look->controlled
            && !view_read(machine_of(debugger), &look->control, i, 1, &bit)))
        return false;
    if (i % in_row(look) == 0)
        sink_print(&debugger->out, "%6zu%s", i, look->of.width == 1 ? "  " : "");
    if (look->controlled)
        sink_print(&debugger->out, "  %u", (unsigned)bit);
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

/* Sets the vector that a register describes. */
static void look_at_register(const struct debugger *debugger, struct register_of named,
                             unsigned width, struct operand_view *of)
{
    c205_word word = debug_register_word(debugger, named);

    *of = (struct operand_view){ .letter = 'v',
                                 .is_vector = true,
                                 .width = width,
                                 .word = word,
                                 .address = c205_descriptor_address(word),
                                 .length = c205_descriptor_length(word) };
}

/* Parses "/", a count and letters: f numbers, i integers, x hex, h half words, b
 * bits. */
static bool read_format(struct debugger *debugger, struct text_cursor *cursor,
                        struct element_look *look, uint64_t *count)
{
    text_cursor_skip(cursor);
    if (*cursor->at != '/')
        return true;
    cursor->at++;
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

    text_cursor_skip(cursor);
    if (*cursor->at != '?')
        return text_cursor_finish(debugger, cursor);
    cursor->at++;
    if (!debug_register(debugger, cursor, &named))
        return debug_fault(debugger,
                           "expected the register of a control vector after ?");
    look->controlled = true;
    look_at_register(debugger, named, 1, &look->control);
    return text_cursor_finish(debugger, cursor);
}

/* If a label has this address, sets the width and the count from the data that the
 * program declares there. A width that the user gave must match. */
static void look_at_label(const struct debugger *debugger, uint64_t address,
                          bool width_asked, struct element_look *look)
{
    static const unsigned widths[] = {
        [ASM_WORDS] = 64, [ASM_HALF_WORDS] = 32, [ASM_BITS] = 1
    };
    const struct object *object = debugger->setup.object;

    for (size_t i = 0; i < object->symbol_count; i++) {
        const struct asm_symbol *symbol = &object->symbols[i];
        unsigned width = symbol->contents < ASM_BYTES ? widths[symbol->contents] : 0;

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

/* Shows elements: x [/COUNT LETTERS] REGISTER | ADDRESS [? REGISTER] */
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
        look_at_register(debugger, named, width, &look.of);
        sink_print(&debugger->out, "%zu from %" PRIX64 " on\n", look.of.length,
                   look.of.address);
    } else if (debug_address(debugger, cursor, &address)) {
        look_at_register(debugger, (struct register_of){ 0, false }, width, &look.of);
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
