/* time.c - the clocks of regions and of the last instruction as variables. */
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>

#include "asm/dap/variables.h"
#include "base/plural.h"

static void put_plain(struct json *json, const char *name, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

static void put_plain(struct json *json, const char *name, const char *format, ...)
{
    char text[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    put_variable(json, name, text, 0);
    json_end(json);
}

void put_time(struct dap *dap, struct json *json)
{
    c205 *machine = machine_of(dap->debugger);
    put_plain(json, "step", "%" PRIu64, step_of(dap->debugger));
    put_plain(json, "clock", "%" PRIu64, c205_clock(machine));
    if (dap->debugger->has_last) {
        char text[40];
        snprintf(text, sizeof text, "%" PRIu64 " clock%s", dap->debugger->last.clocks,
                 plural(dap->debugger->last.clocks));
        put_variable(json, "last instruction", text, reference_of(OF_LAST, 0));
        json_end(json);
    }
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);
        char text[60];
        snprintf(text, sizeof text, "%" PRIu64 " instruction%s", account->instructions,
                 plural(account->instructions));
        put_variable(json, *account->name ? account->name : "outside regions", text,
                     reference_of(OF_REGION, i));
        json_end(json);
    }
}

void put_region(struct dap *dap, struct json *json, size_t number)
{
    c205 *machine = machine_of(dap->debugger);
    const c205_account *account;
    if (number >= c205_account_count(machine))
        return;
    account = c205_account_at(machine, number);
    for (int i = 0; i < C205_CAUSES; i++)
        put_plain(json, c205_cause_name((c205_cause)i), "%" PRIu64, account->clocks[i]);
    put_plain(json, "instructions", "%" PRIu64, account->instructions);
    put_plain(json, "of them vector", "%" PRIu64, account->vector_instructions);
    put_plain(json, "elements", "%" PRIu64, account->elements);
    put_plain(json, "operations", "%" PRIu64, account->operations);
    put_plain(json, "entries", "%" PRIu64, account->entries);
}

static void put_piece(struct dap *dap, struct json *json, const c205_piece *piece)
{
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    sink_print(&sink, "%" PRIu64 " clock%s", piece->clocks, plural(piece->clocks));
    if (piece->wait != C205_WAIT_NONE)
        sink_put(&sink, ", ");
    show_wait(dap->debugger, piece, &sink);
    put_plain(json, c205_cause_name(piece->cause), "%s", text.text);
}

/* Shows when the instruction arrived and issued, its waits, and the remaining phases in
 * the vector unit. */
void put_last(struct dap *dap, struct json *json)
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
                  "from clock %" PRIu64 " to %" PRIu64, record->phase[i].begin,
                  record->phase[i].end);
}
