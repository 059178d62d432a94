/* instruction.c - writes the next instruction with its operands, and the last
 * instruction with its times.
 */
#include <inttypes.h>

#include "asm/object/disassemble.h"
#include "asm/view/vector_view.h"
#include "base/plural.h"
#include "web/engine/engine_internal.h"

/* ---- The next instruction ------------------------------------------------------ */

static void put_disassembly(const struct engine *engine, const char *key, uint64_t pc,
                            struct json *reply)
{
    char text[DISASSEMBLE_TEXT_SIZE];
    disassemble_one(view_word_at(engine_machine(engine), pc), pc, text);
    json_text(reply, key, text);
}

static void put_vector(const struct vector_view *vector, struct json *reply)
{
    json_object(reply, "vector");
    json_count(reply, "address", vector->address);
    json_count(reply, "count", vector->length);
    json_text(reply, "kind", vector_elements(vector->width));
    if (vector->controlled)
        json_count(reply, "control", vector->control);
    json_end(reply);
}

static void put_operand(const struct engine *engine,
                        const struct instruction_view *view,
                        const struct operand_view *operand, struct json *reply)
{
    struct vector_view vector = vector_of_operand(view, operand);
    char letter[2] = { operand->field, '\0' };
    json_object(reply, NULL);
    json_text(reply, "mnemonic", view->insn->mnemonic);
    json_text(reply, "field", letter);
    json_count(reply, "number", operand->number);
    json_bool(reply, "half", operand->is_half);
    json_text(reply, "name",
              operand->is_half
                  ? ""
                  : object_register_name(engine->object, operand->number, false));
    put_number(reply, "text", operand->word, operand->is_half);
    if (vector_has_elements(operand))
        put_vector(&vector, reply);
    json_end(reply);
}

static void put_operands(const struct engine *engine, struct json *reply)
{
    struct instruction_view views[VIEW_LINKED];
    size_t count = view_at(views, engine_machine(engine),
                           c205_pc(engine_machine(engine)));
    json_array(reply, "operands");
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; views[i].insn && k < views[i].count; k++)
            if (view_is_present(&views[i].operands[k]))
                put_operand(engine, &views[i], &views[i].operands[k], reply);
    json_end(reply);
}

void put_next_insn(const struct engine *engine, struct json *reply)
{
    const c205_stop *halt = debugger_halt(engine->debugger);
    if (halt && halt->trap == C205_TRAP_NONE) {
        json_null(reply, "next");
        return;
    }
    put_disassembly(engine, "next", c205_pc(engine_machine(engine)), reply);
    put_operands(engine, reply);
}

/* ---- The last instruction ------------------------------------------------ */

static void put_term(const struct sink *sink, const char *before, uint64_t clocks,
                     c205_cause cause)
{
    sink_print(sink, "%s%" PRIu64 " %s", before, clocks, c205_cause_name(cause));
}

/* Writes the record of the clock as sums such as "101 = 51 vector start-up + 50 vector
 * stream". */
static bool put_formula(const c205_event *event, struct json *reply, c205_error *error)
{
    const c205_times *record = event->record;
    struct text_buffer text = { .text = NULL };
    struct sink sink = text_buffer_sink(&text);
    sink_print(&sink, "%" PRIu64 " clock%s", event->clocks, plural(event->clocks));
    for (size_t i = 0; i < record->piece_count; i++)
        put_term(&sink, i == 0 ? " = " : " + ", record->piece[i].clocks,
                 record->piece[i].cause);
    if (record->phase_count > 0)
        sink_print(&sink, "; the vector unit works for %" PRIu64,
                   record->phase[record->phase_count - 1].end - record->phase[0].begin);
    for (size_t i = 0; i < record->phase_count; i++)
        put_term(&sink, i == 0 ? " = " : " + ",
                 record->phase[i].end - record->phase[i].begin, record->phase[i].cause);
    if (event->elements > 0)
        sink_print(&sink, ", %zu element%s", event->elements, plural(event->elements));
    return put_buffer(reply, "formula", &text, error);
}

static void put_constant(const c205_constant *constant, struct json *reply)
{
    char source[2] = { constant->source, '\0' };
    json_object(reply, NULL);
    json_text(reply, "name", constant->name);
    json_text(reply, "value", constant->text);
    json_text(reply, "unit", constant->unit);
    json_text(reply, "source", source);
    json_end(reply);
}

static void put_constants(const struct engine *engine, const c205_times *record,
                          struct json *reply)
{
    json_array(reply, "constants");
    for (size_t i = 0; i < record->phase_count; i++) {
        const c205_constant *constant = debugger_constant(engine->debugger,
                                                          record->phase[i].cause);
        if (constant)
            put_constant(constant, reply);
    }
    json_end(reply);
}

static void put_pieces(const struct engine *engine, const c205_times *record,
                       const char *key, struct json *reply)
{
    json_array(reply, key);
    for (size_t i = 0; i < record->piece_count; i++) {
        struct text_line wait = { .length = 0 };
        struct sink sink = text_line_sink(&wait);
        show_wait(engine->debugger, &record->piece[i], &sink);
        json_object(reply, NULL);
        json_count(reply, "clocks", record->piece[i].clocks);
        json_text(reply, "cause", c205_cause_name(record->piece[i].cause));
        json_text(reply, "wait", wait.text);
        json_count(reply, "line", program_line(engine, record->piece[i].pc));
        json_end(reply);
    }
    json_end(reply);
}

static void put_phases(const c205_times *record, struct json *reply)
{
    json_array(reply, "phases");
    for (size_t i = 0; i < record->phase_count; i++)
        put_clocks(reply, record->phase[i].begin, record->phase[i].end,
                   record->phase[i].cause);
    json_end(reply);
}

bool put_last_insn(const struct engine *engine, struct json *reply, c205_error *error)
{
    const c205_event *last = debugger_last(engine->debugger);
    const c205_times *end = debugger_end(engine->debugger);
    bool good;
    if (!last) {
        json_null(reply, "last");
        return true;
    }
    json_object(reply, "last");
    put_disassembly(engine, "text", last->pc, reply);
    json_count(reply, "line", program_line(engine, last->pc));
    json_text(reply, "mnemonic", last->insn->mnemonic);
    json_text(reply, "effect", last->insn->effect);
    json_text(reply, "unit", c205_unit_name(last->insn->unit));
    json_count(reply, "elements", last->elements);
    json_count(reply, "clocks", last->clocks);
    json_count(reply, "arrived", last->record->arrived);
    json_count(reply, "issued", last->record->issued);
    json_count(reply, "waited", last->record->issued - last->record->arrived);
    json_count(reply, "ready", last->record->ready);
    json_count(reply, "unit_free", last->record->unit_free);
    good = put_formula(last, reply, error);
    put_constants(engine, last->record, reply);
    put_pieces(engine, last->record, "pieces", reply);
    put_phases(last->record, reply);
    if (end)
        put_pieces(engine, end, "in_flight", reply);
    json_end(reply);
    return good;
}
