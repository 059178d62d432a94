/* variables.c - answers the requests for scopes and variables. The scopes are
 * registers, operands, vectors and time. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "asm/dap/variables.h"

static enum reference_kind kind_of(int64_t reference)
{
    return (enum reference_kind)(reference % KINDS);
}

static size_t number_of(int64_t reference)
{
    return (size_t)(reference / KINDS);
}

/* ---- One variable -------------------------------------------------------- */

void put_variable(struct json *json, const char *name, const char *value,
                  int64_t reference)
{
    json_object(json, NULL);
    json_text(json, "name", name);
    json_text(json, "value", value);
    json_number(json, "variablesReference", (double)reference);
}

/* ---- Vectors of registers ------------------------------------------------ */

static struct vector_view described(const struct dap *dap, size_t number,
                                    unsigned width)
{
    return vector_described(c205_register(machine_of(dap->debugger), (unsigned)number),
                            width);
}

static bool is_vector(const struct dap *dap, unsigned number,
                      struct vector_view *vector)
{
    c205 *machine = machine_of(dap->debugger);
    return vector_recognise(machine, c205_register(machine, number), vector);
}

void put_word_members(struct dap *dap, struct json *json, struct register_of named)
{
    struct vector_view vector;
    bool is = !named.half && is_vector(dap, named.number, &vector);
    json_text(json, "type", named.half ? "half word" : "word");
    json_number(json, "variablesReference",
                is ? (double)reference_of(vector.width == 64 ? OF_WORDS : OF_BITS,
                                          named.number)
                   : 0);
    if (!is)
        return;
    json_count(json, "indexedVariables", vector.length);
    dap_put_address(json, "memoryReference", vector.address);
}

/* ---- Registers ----------------------------------------------------------- */

static void put_register(struct dap *dap, struct json *json, const char *name,
                         struct register_of named)
{
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    struct vector_view vector;
    put_bits(debug_register_word(dap->debugger, named), named.half ? 32 : 64, &sink);
    if (!named.half && is_vector(dap, named.number, &vector)) {
        sink_put(&sink, "  ");
        vector_extent(&vector, &sink);
    }
    json_object(json, NULL);
    json_text(json, "name", name);
    json_text(json, "value", text.text);
    json_text(json, "evaluateName", name);
    put_word_members(dap, json, named);
    json_end(json);
}

/* Returns true if register i is the last register with its name. A name denotes that
 * register. */
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
        put_register(dap, json, number, (struct register_of){ (uint8_t)i, false });
    }
}

const char *name_of(const struct dap *dap, unsigned number, char text[REGISTER_NAME])
{
    const char *name = object_register_name(dap->object, number, false);
    struct text_cursor cursor = { name };
    struct register_of named;
    snprintf(text, REGISTER_NAME, "r%u", number);
    return *name && debug_register(dap->debugger, &cursor, &named)
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
        struct vector_view vector;
        if (!is_vector(dap, i, &vector))
            continue;
        vector_extent(&vector, &sink);
        json_object(json, NULL);
        json_text(json, "name", name);
        json_text(json, "value", text.text);
        json_number(json, "namedVariables", 2);
        put_word_members(dap, json, (struct register_of){ (uint8_t)i, false });
        json_end(json);
    }
}

/* Writes two further variables that show the elements of a vector as half words and as
 * bits. */
static void put_other_ways(struct json *json, const struct vector_view *vector,
                           size_t number)
{
    put_variable(json, "half words", "", reference_of(OF_HALVES, number));
    json_count(json, "indexedVariables", vector->length);
    json_end(json);
    put_variable(json, "bits", "", reference_of(OF_BITS, number));
    json_count(json, "indexedVariables", vector->length);
    json_end(json);
}

bool vector_of(struct dap *dap, int64_t reference, struct vector_view *vector)
{
    size_t number = number_of(reference);
    switch (kind_of(reference)) {
    case OF_WORDS: *vector = described(dap, number, 64); break;
    case OF_HALVES: *vector = described(dap, number, 32); break;
    case OF_BITS: *vector = described(dap, number, 1); break;
    case OF_OPERAND: return operand_vector(dap, number, vector);
    default: return false;
    }
    return number < C205_REGISTERS;
}

/* ---- Requests ------------------------------------------------------------ */

static void put_scope(struct json *body, const char *name, enum reference_kind kind,
                      const char *hint)
{
    json_object(body, NULL);
    json_text(body, "name", name);
    if (hint)
        json_text(body, "presentationHint", hint);
    json_number(body, "variablesReference", (double)reference_of(kind, 0));
    json_bool(body, "expensive", false);
    json_end(body);
}

bool request_scopes(struct dap *dap)
{
    (void)dap;
    json_array(dap->body, "scopes");
    put_scope(dap->body, "Registers", OF_NAMED, "registers");
    put_scope(dap->body, "Operands", OF_OPERANDS, NULL);
    put_scope(dap->body, "Vectors", OF_VECTORS, NULL);
    put_scope(dap->body, "All registers", OF_REGISTERS, "registers");
    put_scope(dap->body, "Time", OF_TIME, NULL);
    json_end(dap->body);
    return true;
}

static bool wants(const struct json_value *arguments, const char *kind)
{
    const char *filter = json_member_text(arguments, "filter");
    return !filter || strcmp(filter, kind) == 0;
}

static bool read_range(struct dap *dap, size_t *first, size_t *count)
{
    int64_t start = 0, most = 0;
    if (!dap_whole(dap, dap->arguments, "start", &start)
        || !dap_whole(dap, dap->arguments, "count", &most))
        return false;
    if (start < 0 || most < 0)
        return dap_fault(dap, "element numbers must not be negative");
    *first = (size_t)start;
    *count = most == 0 ? SIZE_MAX : (size_t)most;
    return true;
}

static bool put_vector(struct dap *dap, int64_t reference)
{
    struct vector_view vector;
    size_t first = 0, count = 0;
    if (!vector_of(dap, reference, &vector))
        return dap_fault(dap, "unknown variables reference %lld", (long long)reference);
    if (!read_range(dap, &first, &count))
        return false;
    if (kind_of(reference) == OF_WORDS && wants(dap->arguments, "named"))
        put_other_ways(dap->body, &vector, number_of(reference));
    if (wants(dap->arguments, "indexed"))
        put_elements(dap, dap->body, &vector, first, count);
    return true;
}

bool request_variables(struct dap *dap)
{
    int64_t reference = 0;
    bool good = true;
    if (!dap_whole(dap, dap->arguments, "variablesReference", &reference))
        return false;
    json_array(dap->body, "variables");
    switch (kind_of(reference)) {
    case OF_NAMED: put_named(dap, dap->body); break;
    case OF_OPERANDS: put_operands(dap, dap->body); break;
    case OF_VECTORS: put_vectors(dap, dap->body); break;
    case OF_REGISTERS: put_registers(dap, dap->body); break;
    case OF_TIME: put_time(dap, dap->body); break;
    case OF_LAST: put_last(dap, dap->body); break;
    case OF_REGION: put_region(dap, dap->body, number_of(reference)); break;
    default: good = put_vector(dap, reference);
    }
    json_end(dap->body);
    return good;
}

/* ---- Changes ------------------------------------------------------------- */

static bool set_element(struct dap *dap, const struct vector_view *vector,
                        const char *name, const struct value_of *value)
{
    c205_word word;
    size_t number;
    if (!element_number(vector, name, &number)
        || !vector_get(machine_of(dap->debugger), vector, number, 1, &word))
        return dap_fault(dap, "unknown element %.40s", name);
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
    struct text_cursor cursor = { name };
    struct register_of named;
    struct vector_view vector;
    if (vector_of(dap, reference, &vector))
        return set_element(dap, &vector, name, value);
    if ((kind_of(reference) == OF_NAMED || kind_of(reference) == OF_REGISTERS
         || kind_of(reference) == OF_VECTORS)
        && debug_register(dap->debugger, &cursor, &named) && text_cursor_end(&cursor))
        return debug_set_register(dap->debugger, named, value);
    return dap_fault(dap, "'%.40s' cannot be changed", name);
}

/* Writes the member "value": the new value of a variable, in the same text as in the
 * list of variables. */
static void put_new(struct dap *dap, struct json *body, int64_t reference,
                    const char *name)
{
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    struct vector_view vector;
    struct text_cursor cursor = { name };
    struct register_of named;
    size_t number;
    c205_word word;
    if (vector_of(dap, reference, &vector)) {
        if (element_number(&vector, name, &number)
            && vector_get(machine_of(dap->debugger), &vector, number, 1, &word))
            put_bits(word, vector.width, &sink);
    } else if (debug_register(dap->debugger, &cursor, &named)) {
        put_bits(debug_register_word(dap->debugger, named), named.half ? 32 : 64,
                 &sink);
        put_word_members(dap, body, named);
    }
    json_text(body, "value", text.text);
}

bool request_set_variable(struct dap *dap)
{
    const char *name = json_member_text(dap->arguments, "name");
    const char *text = json_member_text(dap->arguments, "value");
    struct text_cursor cursor = { text };
    struct value_of value;
    int64_t reference = 0;
    if (!name || !text)
        return dap_fault(dap, "'name' or 'value' is missing");
    if (!dap_whole(dap, dap->arguments, "variablesReference", &reference)
        || !debug_value(dap->debugger, &cursor, &value)
        || !text_cursor_finish(dap->debugger, &cursor)
        || !set(dap, reference, name, &value))
        return false;
    put_new(dap, dap->body, reference, name);
    return true;
}
