/* time.c - shows the clocks of regions and of the last instruction as variables. */
#include <inttypes.h>

#include "asm/dap/variables.h"
#include "base/plural.h"
#include "vm/error.h"

PRINTF_FORMAT(4, 5)
static void put_plain(struct json *json, const char *name, int64_t reference,
                      const char *format, ...)
{
    char text[200];
    PRINTF_TEXT(text, format);
    put_variable(json, name, text, reference);
    json_end(json);
}

void put_time(struct dap *dap, struct json *json)
{
    c205 *machine = machine_of(dap->debugger);
    put_plain(json, "step", 0, "%" PRIu64, step_of(dap->debugger));
    put_plain(json, "clock", 0, "%" PRIu64, c205_clock(machine));
    if (dap->debugger->has_last)
        put_plain(json, "last instruction", reference_of(OF_LAST, 0),
                  "%" PRIu64 " clock%s", dap->debugger->last.clocks,
                  plural(dap->debugger->last.clocks));
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);
        put_plain(json, *account->name ? account->name : "outside regions",
                  reference_of(OF_REGION, i), "%" PRIu64 " instruction%s",
                  account->instructions, plural(account->instructions));
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
        put_plain(json, c205_cause_name((c205_cause)i), 0, "%" PRIu64,
                  account->clocks[i]);
    put_plain(json, "instructions", 0, "%" PRIu64, account->instructions);
    put_plain(json, "of them vector", 0, "%" PRIu64, account->vector_instructions);
    put_plain(json, "elements", 0, "%" PRIu64, account->elements);
    put_plain(json, "operations", 0, "%" PRIu64, account->operations);
    put_plain(json, "entries", 0, "%" PRIu64, account->entries);
}

static void put_piece(struct dap *dap, struct json *json, const c205_piece *piece)
{
    struct text_line text = { .length = 0 };
    struct sink sink = text_line_sink(&text);
    sink_print(&sink, "%" PRIu64 " clock%s", piece->clocks, plural(piece->clocks));
    if (piece->wait != C205_WAIT_NONE)
        sink_put(&sink, ", ");
    show_wait(dap->debugger, piece, &sink);
    put_plain(json, c205_cause_name(piece->cause), 0, "%s", text.text);
}

/* Shows when the last instruction arrived and issued, its waits, and its remaining
 * phases in the vector unit. */
void put_last(struct dap *dap, struct json *json)
{
    const c205_times *record = &dap->debugger->record;
    if (!dap->debugger->has_last)
        return;
    put_plain(json, "arrived", 0, "%" PRIu64, record->arrived);
    put_plain(json, "issued", 0, "%" PRIu64, record->issued);
    put_plain(json, "its result", 0, "%" PRIu64, record->ready);
    put_plain(json, "its unit free", 0, "%" PRIu64, record->unit_free);
    for (size_t i = 0; i < record->piece_count; i++)
        put_piece(dap, json, &record->piece[i]);
    for (size_t i = 0; i < record->phase_count; i++)
        put_plain(json, c205_cause_name(record->phase[i].cause), 0,
                  "from clock %" PRIu64 " to %" PRIu64, record->phase[i].begin,
                  record->phase[i].end);
}
