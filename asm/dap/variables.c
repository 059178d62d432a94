/* variables.c - scopes and variables: registers, operands, vectors, time.
 *
 * A reference says all about what it stands for: its kind, and a number.  So there is
 * no table of them, and one of an earlier stop means the same of this one.
 */
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/dap/parts.h"
#include "asm/operand_view.h"

enum reference_kind {
    OF_NAMED = 1, /* registers that the program has named */
    OF_OPERANDS,  /* of the next instruction */
    OF_VECTORS,   /* what registers describe */
    OF_REGISTERS, /* all */
    OF_TIME,
    OF_WORDS, /* elements of what a register describes, in three ways .. */
    OF_HALVES,
    OF_BITS,
    OF_OPERAND, /* .. and of an operand of the next instruction */
    OF_LAST,    /* the time of the last instruction */
    OF_REGION,  /* an account */
    KINDS = 16
};

static int64_t reference_of(enum reference_kind kind, size_t number)
{
    return (int64_t)kind + (int64_t)number * KINDS;
}

static enum reference_kind kind_of(int64_t reference)
{
    return (enum reference_kind)(reference % KINDS);
}

static size_t number_of(int64_t reference)
{
    return (size_t)(reference / KINDS);
}

/* ---- One variable ------------------------------------------------------------------ */

/* Behind it stand members of its own, and put_end. */
static void put_variable(struct json *json, const char *name,
                         const char *value, int64_t reference)
{
    json_object(json, NULL);
    json_text(json, "name", name);
    json_text(json, "value", value);
    json_number(json, "variablesReference", (double)reference);
}

static void put_plain(struct json *json, const char *name, const char *format,
                      ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

static void put_plain(struct json *json, const char *name, const char *format,
                      ...)
{
    char text[200];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    put_variable(json, name, text, 0);
    json_end(json);
}

/* ---- Vectors of registers -------------------------------------------------------------- */

static struct dap_vector described(const struct dap *dap, size_t number,
                                   unsigned width)
{
    c205_word word = c205_register(machine_of(dap->debugger),
                                   (unsigned)number);

    return (struct dap_vector){ .address = word & UINT64_C(0xFFFFFFFFFFFF),
                                .length = (size_t)(word >> 48),
                                .width = width };
}

/* As words, if it can be; else as bits. */
static bool is_vector(const struct dap *dap, size_t number,
                      struct dap_vector *vector)
{
    *vector = described(dap, number, 64);
    if (vector_is_mapped(dap, vector))
        return true;
    vector->width = 1;
    return vector_is_mapped(dap, vector);
}

static const char *elements_of(unsigned width)
{
    return width == 64 ? "words" : width == 32 ? "half words" : "bits";
}

static void put_extent(const struct dap_vector *vector,
                       const struct sink *sink)
{
    sink_print(sink, "%zu %s from %" PRIX64 " on", vector->length,
               elements_of(vector->width), vector->address);
}

void put_word_members(struct dap *dap, struct json *json,
                      struct register_of named)
{
    struct dap_vector vector;
    bool is = !named.half && is_vector(dap, named.number, &vector);

    json_text(json, "type", named.half ? "half word" : "word");
    json_number(json, "variablesReference",
                is ? (double)reference_of(vector.width == 64 ? OF_WORDS
                                                             : OF_BITS,
                                          named.number)
                   : 0);
    if (!is)
        return;
    json_count(json, "indexedVariables", vector.length);
    dap_put_address(json, "memoryReference", vector.address);
}

/* ---- Registers ------------------------------------------------------------------------- */

static void put_register(struct dap *dap, struct json *json, const char *name,
                         struct register_of named)
{
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    struct dap_vector vector;

    put_bits(debug_register_word(dap->debugger, named), named.half ? 32 : 64,
             &sink);
    if (!named.half && is_vector(dap, named.number, &vector)) {
        sink_put(&sink, "  ");
        put_extent(&vector, &sink);
    }
    json_object(json, NULL);
    json_text(json, "name", name);
    json_text(json, "value", text.text);
    json_text(json, "evaluateName", name);
    put_word_members(dap, json, named);
    json_end(json);
}

enum { REGISTER_NAME = 8 };

/* A name is that of the last that was given it. */
static bool is_last(const struct object *object, size_t i)
{
    for (size_t k = i + 1; k < object->register_count; k++)
        if (strcmp(object->registers[k].name, object->registers[i].name) == 0)
            return false;
    return true;
}

static void put_named(struct dap *dap, struct json *json)
{
    const struct object *object = dap->object;

    for (size_t i = 0; i < object->register_count; i++)
        if (is_last(object, i))
            put_register(dap, json, object->registers[i].name,
                         (struct register_of){ object->registers[i].number,
                                               object->registers[i].half });
}

static void put_registers(struct dap *dap, struct json *json)
{
    for (unsigned i = 0; i < C205_REGISTERS; i++) {
        char number[REGISTER_NAME];

        snprintf(number, sizeof number, "r%u", i);
        put_register(dap, json, number,
                     (struct register_of){ (uint8_t)i, false });
    }
}

/* The name that the program has for it, if that means no other; or its number. */
static const char *name_of(const struct dap *dap, unsigned number,
                           char text[REGISTER_NAME])
{
    const char *name = debug_register_name(dap->debugger, number);
    struct rest rest = { name };
    struct register_of named;

    snprintf(text, REGISTER_NAME, "r%u", number);
    return *name && debug_register(dap->debugger, &rest, &named)
                   && named.number == number && !named.half
               ? name
               : text;
}

static void put_vectors(struct dap *dap, struct json *json)
{
    for (unsigned i = 1; i < C205_REGISTERS; i++) {
        char number[REGISTER_NAME];
        const char *name = name_of(dap, i, number);
        struct text_line text = { .length = 0 };
        struct sink sink = text_line_sink(&text);
        struct dap_vector vector;

        if (!is_vector(dap, i, &vector))
            continue;
        put_extent(&vector, &sink);
        json_object(json, NULL);
        json_text(json, "name", name);
        json_text(json, "value", text.text);
        json_number(json, "namedVariables", 2);
        put_word_members(dap, json,
                         (struct register_of){ (uint8_t)i, false });
        json_end(json);
    }
}

/* The same elements as halves and as bits. */
static void put_other_ways(struct json *json, const struct dap_vector *vector,
                           size_t number)
{
    put_variable(json, "half words", "", reference_of(OF_HALVES, number));
    json_count(json, "indexedVariables", vector->length);
    json_end(json);
    put_variable(json, "bits", "", reference_of(OF_BITS, number));
    json_count(json, "indexedVariables", vector->length);
    json_end(json);
}

/* ---- Operands ---------------------------------------------------------------------------- */

/* Of the next instruction, or the two that a LINKV links. */
struct operands {
    size_t count;
    struct instruction_view views[2];
};

static void find_operands(const struct dap *dap, struct operands *operands)
{
    c205 *machine = machine_of(dap->debugger);
    uint64_t pc = c205_pc(machine);
    struct instruction_view *views = operands->views;

    operands->count = 1;
    view_decode(&views[0], machine, pc);
    if (views[0].insn && views[0].insn->timing == C205_TIMING_vlink) {
        pc += 32 * (uint64_t)views[0].halves;
        view_decode(&views[0], machine, pc);
        pc += 32 * (uint64_t)views[0].halves;
        view_decode(&views[1], machine, pc);
        operands->count = 2;
    }
    for (size_t i = 0; i < operands->count; i++)
        if (views[i].insn)
            view_fill(&views[i], machine);
}

/* Its elements can be counted. */
static bool has_elements(const struct operand_view *operand)
{
    return operand->is_vector && !operand->is_bad && operand->length > 0
           && !strchr("xXzZ", operand->letter);
}

static struct dap_vector
vector_of_operand(const struct instruction_view *view,
                  const struct operand_view *operand)
{
    const struct operand_view *control = view_find(view, "z");
    struct dap_vector vector = { .address = operand->address,
                                 .length = operand->length,
                                 .width = operand->width };

    vector.controlled = control && control->number != 0;
    if (vector.controlled)
        vector.control = control->address;
    return vector;
}

static void put_operand(struct dap *dap, struct json *json,
                        const struct instruction_view *view,
                        const struct operand_view *operand, size_t number)
{
    struct dap_vector vector = vector_of_operand(view, operand);
    struct text_line text = { .length = 0 }, name = { .length = 0 };
    struct sink sink = text_line_sink(&text), naming = text_line_sink(&name);
    bool listed = has_elements(operand);
    char register_name[REGISTER_NAME];

    if (operand->is_half)
        snprintf(register_name, sizeof register_name, "h%u", operand->number);
    sink_print(&naming, operand->is_vector ? "%s [%s]" : "%s %s",
               view->insn->mnemonic,
               operand->is_half
                   ? register_name
                   : name_of(dap, operand->number, register_name));
    if (listed)
        put_extent(&vector, &sink);
    else if (operand->is_vector)
        sink_print(&sink, "%s from %" PRIX64 " on",
                   elements_of(operand->width), operand->address);
    else
        put_bits(operand->word, operand->is_half ? 32 : 64, &sink);
    put_variable(json, name.text, text.text,
                 listed ? reference_of(OF_OPERAND, number) : 0);
    if (listed)
        json_count(json, "indexedVariables", vector.length);
    json_end(json);
}

/* Not where it goes on, nor that there is no control vector. */
static bool is_shown(const struct operand_view *operand)
{
    return operand->field && !strchr("wWpP", operand->letter)
           && !(operand->letter == 'z' && operand->number == 0);
}

static void put_operands(struct dap *dap, struct json *json)
{
    struct operands operands;

    find_operands(dap, &operands);
    for (size_t i = 0; i < operands.count; i++) {
        const struct instruction_view *view = &operands.views[i];

        for (size_t k = 0; view->insn && k < view->count; k++)
            if (is_shown(&view->operands[k]))
                put_operand(dap, json, view, &view->operands[k],
                            i * VIEW_OPERANDS + k);
    }
}

bool vector_of(struct dap *dap, int64_t reference, struct dap_vector *vector)
{
    size_t number = number_of(reference);
    struct operands operands;
    const struct operand_view *operand;

    switch (kind_of(reference)) {
    case OF_WORDS: *vector = described(dap, number, 64); break;
    case OF_HALVES: *vector = described(dap, number, 32); break;
    case OF_BITS: *vector = described(dap, number, 1); break;
    case OF_OPERAND:
        find_operands(dap, &operands);
        if (number >= operands.count * VIEW_OPERANDS)
            return false;
        operand = &operands.views[number / VIEW_OPERANDS]
                       .operands[number % VIEW_OPERANDS];
        if (!has_elements(operand))
            return false;
        *vector = vector_of_operand(&operands.views[number / VIEW_OPERANDS],
                                    operand);
        return true;
    default: return false;
    }
    return number < C205_REGISTERS;
}

/* ---- Time ---------------------------------------------------------------------------------- */

static void put_time(struct dap *dap, struct json *json)
{
    c205 *machine = machine_of(dap->debugger);

    put_plain(json, "step", "%" PRIu64, step_of(dap->debugger));
    put_plain(json, "clock", "%" PRIu64, c205_clock(machine));
    if (dap->debugger->has_last) {
        char text[40];

        snprintf(text, sizeof text, "%" PRIu64 " clocks",
                 dap->debugger->last.clocks);
        put_variable(json, "last instruction", text,
                     reference_of(OF_LAST, 0));
        json_end(json);
    }
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);
        char text[60];

        snprintf(text, sizeof text, "%" PRIu64 " instructions",
                 account->instructions);
        put_variable(json, *account->name ? account->name : "outside regions",
                     text, reference_of(OF_REGION, i));
        json_end(json);
    }
}

static void put_region(struct dap *dap, struct json *json, size_t number)
{
    c205 *machine = machine_of(dap->debugger);
    const c205_account *account;

    if (number >= c205_account_count(machine))
        return;
    account = c205_account_at(machine, number);
    for (int i = 0; i < C205_CAUSES; i++)
        put_plain(json, c205_cause_name((c205_cause)i), "%" PRIu64,
                  account->clocks[i]);
    put_plain(json, "instructions", "%" PRIu64, account->instructions);
    put_plain(json, "of them vector", "%" PRIu64,
              account->vector_instructions);
    put_plain(json, "elements", "%" PRIu64, account->elements);
    put_plain(json, "operations", "%" PRIu64, account->operations);
    put_plain(json, "entries", "%" PRIu64, account->entries);
}

static void put_piece(struct dap *dap, struct json *json,
                      const c205_piece *piece)
{
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);

    sink_print(&sink, "%" PRIu64 " clocks", piece->clocks);
    if (piece->wait != C205_WAIT_NONE)
        sink_put(&sink, ", ");
    show_wait(dap->debugger, piece, &sink);
    put_plain(json, c205_cause_name(piece->cause), "%s", text.text);
}

/* When it came and went, what it waited for, and what the vector unit still does for
 * it. */
static void put_last(struct dap *dap, struct json *json)
{
    const c205_times *record = &dap->debugger->record;

    if (!dap->debugger->has_last)
        return;
    put_plain(json, "arrived", "%" PRIu64, record->arrived);
    put_plain(json, "issued", "%" PRIu64, record->issued);
    put_plain(json, "its result", "%" PRIu64, record->ready);
    put_plain(json, "its unit free", "%" PRIu64, record->unit_free);
    for (size_t i = 0; i < record->piece_count; i++)
        put_piece(dap, json, &record->piece[i]);
    for (size_t i = 0; i < record->phase_count; i++)
        put_plain(json, c205_cause_name(record->phase[i].cause),
                  "from clock %" PRIu64 " to %" PRIu64,
                  record->phase[i].begin, record->phase[i].end);
}

/* ---- Requests -------------------------------------------------------------------------------- */

static void put_scope(struct json *body, const char *name,
                      enum reference_kind kind, const char *hint)
{
    json_object(body, NULL);
    json_text(body, "name", name);
    if (hint)
        json_text(body, "presentationHint", hint);
    json_number(body, "variablesReference", (double)reference_of(kind, 0));
    json_truth(body, "expensive", false);
    json_end(body);
}

bool request_scopes(struct dap *dap, const struct json_value *arguments,
                    struct json *body)
{
    (void)dap;
    (void)arguments;
    json_array(body, "scopes");
    put_scope(body, "Registers", OF_NAMED, "registers");
    put_scope(body, "Operands", OF_OPERANDS, NULL);
    put_scope(body, "Vectors", OF_VECTORS, NULL);
    put_scope(body, "All registers", OF_REGISTERS, "registers");
    put_scope(body, "Time", OF_TIME, NULL);
    json_end(body);
    return true;
}

static bool wants(const struct json_value *arguments, const char *kind)
{
    const char *filter = json_member_text(arguments, "filter");

    return !filter || strcmp(filter, kind) == 0;
}

static bool read_range(struct dap *dap, const struct json_value *arguments,
                       size_t *first, size_t *count)
{
    int64_t start = 0, most = 0;

    if (!dap_whole(dap, arguments, "start", &start)
        || !dap_whole(dap, arguments, "count", &most))
        return false;
    if (start < 0 || most < 0)
        return dap_fault(dap, "elements are counted from 0 on");
    *first = (size_t)start;
    *count = most == 0 ? SIZE_MAX : (size_t)most;
    return true;
}

static bool put_vector(struct dap *dap, const struct json_value *arguments,
                       struct json *body, int64_t reference)
{
    struct dap_vector vector;
    size_t first = 0, count = 0;

    if (!vector_of(dap, reference, &vector))
        return dap_fault(dap, "no variables have the reference %lld",
                         (long long)reference);
    if (!read_range(dap, arguments, &first, &count))
        return false;
    if (kind_of(reference) == OF_WORDS && wants(arguments, "named"))
        put_other_ways(body, &vector, number_of(reference));
    if (wants(arguments, "indexed"))
        put_elements(dap, body, &vector, first, count);
    return true;
}

bool request_variables(struct dap *dap, const struct json_value *arguments,
                       struct json *body)
{
    int64_t reference = 0;
    bool good = true;

    if (!dap_whole(dap, arguments, "variablesReference", &reference))
        return false;
    json_array(body, "variables");
    switch (kind_of(reference)) {
    case OF_NAMED: put_named(dap, body); break;
    case OF_OPERANDS: put_operands(dap, body); break;
    case OF_VECTORS: put_vectors(dap, body); break;
    case OF_REGISTERS: put_registers(dap, body); break;
    case OF_TIME: put_time(dap, body); break;
    case OF_LAST: put_last(dap, body); break;
    case OF_REGION: put_region(dap, body, number_of(reference)); break;
    default: good = put_vector(dap, arguments, body, reference);
    }
    json_end(body);
    return good;
}

/* ---- Changes ----------------------------------------------------------------------------------- */

static bool set_element(struct dap *dap, const struct dap_vector *vector,
                        const char *name, const struct value_of *value)
{
    c205_word word;
    size_t number;

    if (!element_number(vector, name, &number)
        || !element_word(dap, vector, number, &word))
        return dap_fault(dap, "there is no element %.40s", name);
    if (vector->width == 1)
        word = debug_is_true(value) ? UINT64_C(1) << 63 : 0;
    else if (!debug_word(dap->debugger, value, vector->width == 32, &word))
        return false;
    return debug_set_bits(dap->debugger,
                          vector->address + (uint64_t)number * vector->width,
                          vector->width, word);
}

static bool set(struct dap *dap, int64_t reference, const char *name,
                const struct value_of *value)
{
    struct rest rest = { name };
    struct register_of named;
    struct dap_vector vector;

    if (vector_of(dap, reference, &vector))
        return set_element(dap, &vector, name, value);
    if ((kind_of(reference) == OF_NAMED || kind_of(reference) == OF_REGISTERS
         || kind_of(reference) == OF_VECTORS)
        && debug_register(dap->debugger, &rest, &named) && rest_end(&rest))
        return debug_set_register(dap->debugger, named, value);
    return dap_fault(dap, "'%.40s' cannot be changed", name);
}

/* What it is now, as variables show it. */
static void put_new(struct dap *dap, struct json *body, int64_t reference,
                    const char *name)
{
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    struct dap_vector vector;
    struct rest rest = { name };
    struct register_of named;
    size_t number;
    c205_word word;

    if (vector_of(dap, reference, &vector)) {
        if (element_number(&vector, name, &number)
            && element_word(dap, &vector, number, &word))
            put_bits(word, vector.width, &sink);
    } else if (debug_register(dap->debugger, &rest, &named)) {
        put_bits(debug_register_word(dap->debugger, named),
                 named.half ? 32 : 64, &sink);
        put_word_members(dap, body, named);
    }
    json_text(body, "value", text.text);
}

bool request_set_variable(struct dap *dap, const struct json_value *arguments,
                          struct json *body)
{
    const char *name = json_member_text(arguments, "name");
    const char *text = json_member_text(arguments, "value");
    struct rest rest = { text };
    struct value_of value;
    int64_t reference = 0;

    if (!name || !text)
        return dap_fault(dap, "'name' or 'value' is missing");
    if (!dap_whole(dap, arguments, "variablesReference", &reference)
        || !debug_value(dap->debugger, &rest, &value)
        || !rest_finish(dap->debugger, &rest)
        || !set(dap, reference, name, &value))
        return false;
    put_new(dap, body, reference, name);
    return true;
}
