/* time.c - the verbs why and account, which show the causes of the clocks of an
 * instruction and of a run. */
#include <inttypes.h>
#include <stdio.h>

#include "asm/debug/debug_internal.h"
#include "base/accounts.h"
#include "base/plural.h"

/* ---- The last instruction ------------------------------------------------- */

void show_wait(const struct debugger *debugger, const c205_piece *piece,
               const struct sink *sink)
{
    const char *name;
    switch (piece->wait) {
    case C205_WAIT_REGISTER:
        name = object_register_name(debugger->setup.object, piece->number, false);
        sink_print(sink, "waits for r%u%s%s", piece->number, *name ? ", " : "", name);
        break;
    case C205_WAIT_UNIT:
        sink_print(sink, "the %s unit is busy",
                   c205_unit_name((c205_unit)piece->number));
        break;
    case C205_WAIT_LOADS: sink_put(sink, "waits for loads"); break;
    case C205_WAIT_RESULTS: sink_put(sink, "waits for all results"); break;
    case C205_WAIT_VECTOR: sink_put(sink, "the vector unit is busy"); break;
    default: break;
    }
}

static void put_pieces(const struct debugger *debugger, const c205_times *record)
{
    c205 *machine = machine_of(debugger);
    for (size_t i = 0; i < record->piece_count; i++) {
        const c205_piece *piece = &record->piece[i];
        const char *region = c205_account_at(machine, piece->region)->name;
        sink_print(&debugger->out, "%10" PRIu64 "  %-16s", piece->clocks,
                   c205_cause_name(piece->cause));
        if (piece->wait != C205_WAIT_NONE)
            sink_put(&debugger->out, "  ");
        show_wait(debugger, piece, &debugger->out);
        if (piece->pc != record->pc)
            sink_print(&debugger->out, "  with the work of %" PRIX64 "%s%s", piece->pc,
                       *region ? ", region " : "", region);
        sink_put(&debugger->out, "\n");
    }
}

const c205_constant *debugger_constant(const struct debugger *debugger,
                                       c205_cause phase)
{
    const char *kind = phase == C205_VECTOR_STARTUP  ? "startup"
                       : phase == C205_VECTOR_STREAM ? "stream"
                                                     : NULL;
    char name[80];
    if (!kind || !debugger->has_last)
        return NULL;
    snprintf(name, sizeof name, "%s.%s", kind,
             c205_timing_name(debugger->last.insn->timing));
    return c205_model_lookup(debugger->setup.model, name);
}

static void put_constant(const struct debugger *debugger, c205_cause phase)
{
    const c205_constant *constant = debugger_constant(debugger, phase);
    if (constant)
        sink_print(&debugger->out, "  %s = %s %s (%c)", constant->name, constant->text,
                   constant->unit, constant->source);
}

static void put_phases(const struct debugger *debugger)
{
    const c205_times *record = &debugger->record;
    for (size_t i = 0; i < record->phase_count; i++) {
        uint64_t begin = record->phase[i].begin, end = record->phase[i].end;
        c205_cause cause = record->phase[i].cause;
        sink_print(&debugger->out, "%10" PRIu64 "  %-16s  %" PRIu64 " .. %" PRIu64,
                   end - begin, c205_cause_name(cause), begin, end);
        if (cause == C205_VECTOR_STREAM)
            sink_print(&debugger->out, "  %zu element%s", debugger->last.elements,
                       plural(debugger->last.elements));
        put_constant(debugger, cause);
        sink_put(&debugger->out, "\n");
    }
}

bool verb_why(struct debugger *debugger, struct text_cursor *cursor)
{
    const c205_times *record = &debugger->record;
    if (!text_cursor_finish(debugger, cursor))
        return false;
    if (!debugger->has_last)
        return debug_fault(debugger, "no instruction has been executed: step first");
    show_instruction(debugger, debugger->last.pc, "   ");
    sink_print(&debugger->out,
               "arrived at clock %" PRIu64 ", issued at %" PRIu64
               ", its result at %" PRIu64 ", its unit free at %" PRIu64 "\n",
               record->arrived, record->issued, record->ready, record->unit_free);
    sink_print(&debugger->out, "%10" PRIu64 "  clocks, of these\n",
               debugger->last.clocks);
    put_pieces(debugger, record);
    if (debugger->has_end && debugger->end.piece_count > 0) {
        sink_put(&debugger->out, "and until all work in flight was finished\n");
        put_pieces(debugger, &debugger->end);
    }
    if (record->phase_count > 0) {
        sink_put(&debugger->out, "the vector unit continues\n");
        put_phases(debugger);
    }
    return true;
}

/* ---- The whole run -------------------------------------------------------- */

static void put_account(const struct debugger *debugger, const c205_account *account)
{
    uint64_t sum = accounts_clocks(account);
    if (sum == 0 && account->instructions == 0)
        return;
    sink_print(&debugger->out,
               "%s: %" PRIu64 " clock%s, %" PRIu64 " instruction%s, %" PRIu64
               " of them vector, %" PRIu64 " element%s\n",
               *account->name ? account->name : "outside regions", sum, plural(sum),
               account->instructions, plural(account->instructions),
               account->vector_instructions, account->elements,
               plural(account->elements));
    for (int i = 0; i < C205_CAUSES; i++)
        if (account->clocks[i] > 0)
            sink_print(&debugger->out, "%10" PRIu64 "  %s\n", account->clocks[i],
                       c205_cause_name((c205_cause)i));
}

bool verb_account(struct debugger *debugger, struct text_cursor *cursor)
{
    c205 *machine = machine_of(debugger);
    if (!text_cursor_finish(debugger, cursor))
        return false;
    for (size_t i = 0; i < c205_account_count(machine); i++)
        put_account(debugger, c205_account_at(machine, i));
    sink_print(&debugger->out, "%" PRIu64 " clock%s in all\n", c205_clock(machine),
               plural(c205_clock(machine)));
    return true;
}
