/* show.c - where the program stands and what it holds. */
#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "asm/debug/parts.h"
#include "asm/disassemble.h"
#include "asm/operand_view.h"
#include "asm/trap_report.h"
#include "base/diagnostic.h"

/* ---- Instructions --------------------------------------------------------- */

static void put_text(const struct debugger *debugger, const char *file,
                     size_t number, const char *source)
{
    const char *slash = strrchr(file, '/');

    while (isspace((unsigned char)*source))
        source++;
    sink_print(&debugger->out, "%s:%zu: %s", slash ? slash + 1 : file, number,
               source);
}

/* Of a macro the call first. */
static void put_source(const struct debugger *debugger,
                       const struct asm_line *line)
{
    sink_put(&debugger->out, "  ; ");
    put_text(debugger, line->call_file, line->call_number, line->call_source);
    if (line->number == line->call_number
        && strcmp(line->file, line->call_file) == 0)
        return;
    sink_put(&debugger->out, "  <- ");
    put_text(debugger, line->file, line->number, line->source);
}

void show_instruction(struct debugger *debugger, uint64_t address,
                      const char *before)
{
    const struct asm_line *line = object_line(debugger->setup.object,
                                              address);
    char text[DISASSEMBLE_TEXT_SIZE];

    disassemble_one(view_word_at(machine_of(debugger), address), address,
                    text);
    sink_print(&debugger->out,
               line ? "%s%6" PRIX64 "  %-28s" : "%s%6" PRIX64 "  %s", before,
               address, text);
    if (line)
        put_source(debugger, line);
    sink_put(&debugger->out, "\n");
}

static void show_halt(struct debugger *debugger)
{
    const c205_stop *stop = &debugger->halt;

    if (stop->trap == C205_TRAP_NONE)
        sink_print(&debugger->out,
                   "the program has ended with status %" PRId64 "\n",
                   stop->status);
    else
        trap_report(debugger->setup.object, debugger->setup.name,
                    machine_of(debugger), stop, &debugger->out);
}

void show_end_line(struct debugger *debugger)
{
    if (debugger->line_open)
        sink_put(&debugger->out, "\n");
    debugger->line_open = false;
}

void show_place(struct debugger *debugger)
{
    c205 *machine = machine_of(debugger);
    const char *region = place_region(debugger, c205_pc(machine));

    show_end_line(debugger);
    sink_print(&debugger->out, "step %" PRIu64 ", clock %" PRIu64 "%s%s\n",
               c205_history_step(debugger->history), c205_clock(machine),
               *region ? ", region " : "", region);
    if (debugger->halted)
        show_halt(debugger);
    if (!debugger->halted || debugger->halt.trap != C205_TRAP_NONE)
        show_instruction(debugger, c205_pc(machine), "=> ");
}

bool verb_where(struct debugger *debugger, struct rest *rest)
{
    if (!rest_finish(debugger, rest))
        return false;
    show_place(debugger);
    return true;
}

/* PLACE, or from where the program stands. */
static bool read_start(struct debugger *debugger, struct rest *rest,
                       uint64_t *address)
{
    *address = c205_pc(machine_of(debugger));
    rest_skip(rest);
    return !*rest->at || *rest->at == ','
           || place_address(debugger, rest, address);
}

/* ", COUNT" behind the rest, or as many as usual. */
static bool read_count(struct debugger *debugger, struct rest *rest,
                       uint64_t *count)
{
    rest_skip(rest);
    if (*rest->at != ',')
        return rest_finish(debugger, rest);
    rest->at++;
    return debug_count(debugger, rest, count) && rest_finish(debugger, rest);
}

/* disassemble [PLACE] [, COUNT] */
bool verb_disassemble(struct debugger *debugger, struct rest *rest)
{
    enum { MOST = 100000 };
    uint64_t address, count = 10;

    if (!read_start(debugger, rest, &address)
        || !read_count(debugger, rest, &count))
        return false;
    if (count > MOST)
        return debug_fault(debugger, "at most %d instructions are shown",
                           MOST);
    for (; count > 0 && address >> 48 == 0; count--) {
        struct instruction_view view;
        bool at = address == c205_pc(machine_of(debugger));

        view_decode(&view, machine_of(debugger), address);
        show_instruction(debugger, address, at ? "=> " : "   ");
        address += 32 * (uint64_t)view.halves;
    }
    return true;
}

/* ---- Source --------------------------------------------------------------- */

static bool is_same_line(const struct asm_line *a, const struct asm_line *b)
{
    return a && b && a->number == b->number && strcmp(a->file, b->file) == 0;
}

/* list [PLACE] [, COUNT]: lines that made code or data, in the order of addresses. */
bool verb_list(struct debugger *debugger, struct rest *rest)
{
    const struct object *object = debugger->setup.object;
    const struct asm_line *shown = NULL, *now;
    uint64_t address, count = 10;

    if (!read_start(debugger, rest, &address)
        || !read_count(debugger, rest, &count))
        return false;
    if (object->line_count == 0)
        return debug_fault(debugger, "the source lines are not known");
    now = object_line(object, c205_pc(machine_of(debugger)));
    for (size_t i = 0; i < object->line_count && count > 0; i++) {
        const struct asm_line *line = &object->lines[i];

        if (line->address + 32 * line->halves <= address
            || is_same_line(line, shown))
            continue;
        sink_print(&debugger->out, "%s%s:%zu\t%.*s\n",
                   is_same_line(line, now) ? "=> " : "   ", line->file,
                   line->number, (int)strcspn(line->source, "\n"),
                   line->source);
        shown = line;
        count--;
    }
    return true;
}

/* ---- Values --------------------------------------------------------------- */

static void put_word(const struct debugger *debugger, c205_word word,
                     bool half)
{
    char hex[C205_TEXT_SIZE], text[C205_TEXT_SIZE];

    c205_to_hex(word, hex);
    (half ? c205_half_to_text : c205_to_text)(word, text);
    if (half)
        hex[9] = '\0';
    sink_print(&debugger->out, "X'%s'  number %s", hex, text);
    if (!half && word >> 48 == 0)
        sink_print(&debugger->out, "  address %" PRIX64, word);
    else if (!half)
        sink_print(&debugger->out, "  length %u, address %" PRIX64,
                   (unsigned)(word >> 48), word & UINT64_C(0xFFFFFFFFFFFF));
    sink_put(&debugger->out, "\n");
}

bool verb_print(struct debugger *debugger, struct rest *rest)
{
    struct rest again = *rest;
    struct register_of named;
    struct value_of value;

    if (debug_register(debugger, &again, &named) && rest_end(&again)) {
        put_word(debugger, debug_register_word(debugger, named), named.half);
        return true;
    }
    if (!debug_value(debugger, rest, &value) || !rest_finish(debugger, rest))
        return false;
    if (value.is_word)
        put_word(debugger, value.word, value.is_half);
    else if (value.is_real)
        sink_print(&debugger->out, "%.15g\n", value.real);
    else
        sink_print(&debugger->out, "%" PRId64 "  X'%" PRIX64 "'\n",
                   value.integer, (uint64_t)value.integer);
    return true;
}

bool verb_assert(struct debugger *debugger, struct rest *rest)
{
    struct value_of value;
    const char *text;

    rest_skip(rest);
    text = rest->at;
    if (!debug_value(debugger, rest, &value) || !rest_finish(debugger, rest))
        return false;
    return debug_is_true(&value)
           || debug_fault(debugger, "it does not hold: %.200s", text);
}

/* ---- Memory --------------------------------------------------------------- */

enum { ELEMENTS_USUAL = 16 };

/* Elements of a vector as they are shown. */
struct element_look {
    struct operand_view of;
    char format; /* f i x b */
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
                 half ? (int64_t)(int32_t)(word >> 24) / 256
                      : c205_to_integer(word));
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

/* False: some of it is not there. */
static bool put_element_at(const struct debugger *debugger,
                           const struct element_look *look, size_t i)
{
    c205_word word, bit;

    if (!view_read(machine_of(debugger), &look->of, i, 1, &word))
        return false;
    if (look->controlled) {
        if (!view_read(machine_of(debugger), &look->control, i, 1, &bit))
            return false;
        sink_print(&debugger->out, "  %u", (unsigned)bit);
    }
    put_element(debugger, look, word);
    return true;
}

static bool put_elements(struct debugger *debugger,
                         const struct element_look *look, size_t count)
{
    unsigned row = in_row(look);
    bool good = true;

    for (size_t i = 0; good && i < count; i++) {
        if (i % row == 0)
            sink_print(&debugger->out, "%6zu%s", i,
                       look->of.width == 1 ? "  " : "");
        good = put_element_at(debugger, look, i);
        if (good && (i % row == row - 1 || i + 1 == count))
            sink_put(&debugger->out, "\n");
    }
    if (!good)
        sink_put(&debugger->out, "\n");
    return good
           || debug_fault(debugger, "no memory is mapped there, or not all "
                                    "of it");
}

/* What a register describes. */
static void look_at_register(const struct debugger *debugger,
                             struct register_of named, unsigned width,
                             struct operand_view *of)
{
    c205_word word = debug_register_word(debugger, named);

    *of = (struct operand_view){ .letter = 'v',
                                 .is_vector = true,
                                 .width = width,
                                 .word = word,
                                 .address = word & UINT64_C(0xFFFFFFFFFFFF),
                                 .length = (size_t)(word >> 48) };
}

/* "/": then a count, and letters: f numbers, i integers, x hex, h half words, b bits. */
static bool read_format(struct debugger *debugger, struct rest *rest,
                        struct element_look *look, uint64_t *count)
{
    rest_skip(rest);
    if (*rest->at != '/')
        return true;
    rest->at++;
    for (; *rest->at && !isspace((unsigned char)*rest->at); rest->at++) {
        char c = *rest->at;

        if (isdigit((unsigned char)c) && *count != UINT64_MAX
            && *count > C205_MAX_LENGTH)
            return debug_fault(debugger, "a count of at most %u",
                               C205_MAX_LENGTH);
        if (isdigit((unsigned char)c))
            *count = (*count == UINT64_MAX ? 0 : *count) * 10
                     + (uint64_t)(c - '0');
        else if (c == 'h')
            look->of.width = 32;
        else if (c == 'b')
            look->of.width = 1;
        else if (c == 'f' || c == 'i' || c == 'x')
            look->format = c;
        else
            return debug_fault(debugger,
                               "after / stand a count and f, i, x, h or b, "
                               "not '%c'",
                               c);
    }
    return true;
}

static bool read_control(struct debugger *debugger, struct rest *rest,
                         struct element_look *look)
{
    struct register_of named;

    rest_skip(rest);
    if (*rest->at != '?')
        return rest_finish(debugger, rest);
    rest->at++;
    if (!debug_register(debugger, rest, &named))
        return debug_fault(debugger, "behind ? stands the register of a "
                                     "control vector");
    look->controlled = true;
    look_at_register(debugger, named, 1, &look->control);
    return rest_finish(debugger, rest);
}

/* x [/COUNT LETTERS] REGISTER | ADDRESS [? REGISTER] */
bool verb_x(struct debugger *debugger, struct rest *rest)
{
    struct element_look look = { .of = { .width = 64 }, .format = 'f' };
    uint64_t count = UINT64_MAX, address;
    struct register_of named;
    unsigned width;

    if (!read_format(debugger, rest, &look, &count))
        return false;
    width = look.of.width;
    if (debug_register(debugger, rest, &named)) {
        look_at_register(debugger, named, width, &look.of);
        sink_print(&debugger->out, "%zu from %" PRIX64 " on\n",
                   look.of.length, look.of.address);
    } else if (debug_address(debugger, rest, &address)) {
        look_at_register(debugger, (struct register_of){ 0, false }, width,
                         &look.of);
        look.of.address = address;
        look.of.length = count == UINT64_MAX ? ELEMENTS_USUAL : (size_t)count;
    } else {
        return false;
    }
    if (!read_control(debugger, rest, &look))
        return false;
    if (count == UINT64_MAX)
        count = look.of.width == 1 ? 64 : ELEMENTS_USUAL;
    if (count > look.of.length)
        count = look.of.length;
    return put_elements(debugger, &look, (size_t)count);
}

/* ---- Information ---------------------------------------------------------- */

/* Those that hold something. */
static bool info_registers(struct debugger *debugger)
{
    for (unsigned i = 1; i < C205_REGISTERS; i++) {
        c205_word word = c205_register(machine_of(debugger), i);

        if (word == 0)
            continue;
        sink_print(&debugger->out, "r%-3u %-12s ", i,
                   debug_register_name(debugger, i));
        put_word(debugger, word, false);
    }
    return true;
}

static bool info_breaks(struct debugger *debugger)
{
    if (debugger->stop_count == 0)
        sink_put(&debugger->out, "there are none\n");
    for (size_t i = 0; i < debugger->stop_count; i++) {
        const struct stop_point *stop = &debugger->stops[i];

        sink_print(&debugger->out, "%zu %s %s%s%s%s, met %" PRIu64 " times\n",
                   stop->number, stop->kind == STOP_WATCH ? "watch" : "break",
                   stop->text, *stop->condition ? " if " : "",
                   stop->condition, stop->once ? ", once" : "", stop->hits);
    }
    return true;
}

static bool info_regions(struct debugger *debugger)
{
    const c205_program *program = &debugger->setup.object->program;

    for (size_t i = 0; i < program->region_count; i++)
        sink_print(&debugger->out, "%6" PRIX64 " .. %6" PRIX64 "  %s\n",
                   program->regions[i].begin, program->regions[i].end,
                   program->regions[i].name);
    return true;
}

static bool info_pages(struct debugger *debugger)
{
    c205_page page = { 0 };

    for (uint64_t from = 0; c205_next_page(machine_of(debugger), from, &page);
         from = page.address + UINT64_C(64) * C205_PAGE_WORDS)
        sink_print(&debugger->out, "%12" PRIX64 "  %s%s\n", page.address,
                   page.writable ? "read and written" : "read only",
                   page.touched ? "" : ", not touched yet");
    return true;
}

static bool info_symbols(struct debugger *debugger)
{
    const struct object *object = debugger->setup.object;

    for (size_t i = 0; i < object->symbol_count; i++) {
        const struct asm_symbol *symbol = &object->symbols[i];

        if (symbol->is_label)
            sink_print(&debugger->out, "%6" PRIX64 "  %s\n",
                       (uint64_t)symbol->value, symbol->name);
    }
    return true;
}

static bool info_operands(struct debugger *debugger)
{
    trap_report_operands(machine_of(debugger), c205_pc(machine_of(debugger)),
                         &debugger->out);
    return true;
}

bool verb_info(struct debugger *debugger, struct rest *rest)
{
    static const struct {
        const char *name;
        bool (*show)(struct debugger *debugger);
    } topics[] = {
        { "registers", info_registers }, { "breaks", info_breaks },
        { "regions", info_regions },     { "pages", info_pages },
        { "symbols", info_symbols },     { "operands", info_operands },
    };

    for (size_t i = 0; i < sizeof topics / sizeof *topics; i++)
        if (rest_begin(rest, topics[i].name))
            return rest_finish(debugger, rest) && topics[i].show(debugger);
    return debug_fault(debugger, "info is of registers, operands, breaks, "
                                 "regions, pages or symbols");
}

/* ---- Changes -------------------------------------------------------------- */

static bool set_register(struct debugger *debugger, struct register_of named,
                         const struct value_of *value)
{
    c205 *machine = machine_of(debugger);
    unsigned shift = named.number % 2 * 32;
    c205_word word, kept;

    if (named.number / (named.half ? 2 : 1) == 0)
        return debug_fault(debugger, "register 0 stays what it is");
    if (!debug_word(debugger, value, named.half, &word))
        return false;
    if (!named.half) {
        c205_set_register(machine, named.number, word);
        return true;
    }
    kept = c205_register(machine, named.number / 2u)
           & (shift ? ~(c205_word)UINT32_MAX : UINT32_MAX);
    c205_set_register(machine, named.number / 2u, kept | word >> shift);
    return true;
}

static bool set_word(struct debugger *debugger, uint64_t address,
                     const struct value_of *value)
{
    c205_word word;

    return debug_word(debugger, value, false, &word)
           && (c205_write(machine_of(debugger), address, &word, 1)
               || debug_fault(debugger, "there is no word at %" PRIX64,
                              address));
}

static bool read_new(struct debugger *debugger, struct rest *rest,
                     struct value_of *value)
{
    rest_skip(rest);
    if (*rest->at != '=')
        return debug_fault(debugger, "set REGISTER = VALUE, or "
                                     "[ADDRESS] = VALUE");
    rest->at++;
    return debug_value(debugger, rest, value) && rest_finish(debugger, rest);
}

static bool keep_change(struct debugger *debugger)
{
    c205_error error;

    debugger->halted = false;
    if (debugger->told > c205_history_step(debugger->history))
        debugger->told = c205_history_step(debugger->history);
    stops_sample(debugger);
    return c205_history_changed(debugger->history, &error)
           || debug_fault(debugger, "%s", error.message);
}

/* From here on the run is another one. */
bool verb_set(struct debugger *debugger, struct rest *rest)
{
    struct register_of named;
    struct value_of value;
    uint64_t address;

    if (debugger->halted && debugger->halt.trap == C205_TRAP_NONE)
        return debug_fault(debugger, "the program has ended: go back first");
    rest_skip(rest);
    if (*rest->at == '[') {
        rest->at++;
        if (!debug_address(debugger, rest, &address))
            return false;
        rest_skip(rest);
        if (*rest->at != ']')
            return debug_fault(debugger, "a ] is missing");
        rest->at++;
        return read_new(debugger, rest, &value)
               && set_word(debugger, address, &value)
               && keep_change(debugger);
    }
    if (!debug_register(debugger, rest, &named))
        return debug_fault(debugger, "set REGISTER = VALUE, or "
                                     "[ADDRESS] = VALUE");
    return read_new(debugger, rest, &value)
           && set_register(debugger, named, &value) && keep_change(debugger);
}
