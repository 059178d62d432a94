/* info.c - the verb info, which prints tables of registers, breakpoints, regions, pages
 * and symbols. */
#include <inttypes.h>
#include <stdio.h>

#include "asm/debug/debug_internal.h"
#include "asm/view/trap_report.h"
#include "asm/view/word_text.h"
#include "base/plural.h"

static void put_register(const struct debugger *debugger, unsigned number,
                         c205_word word)
{
    struct word_text text = word_text(word, false);
    char length[12] = "";
    unsigned elements = (unsigned)c205_descriptor_length(word);
    if (elements > 0)
        snprintf(length, sizeof length, "%u", elements);
    sink_print(&debugger->out, "r%-3u %-12s X'%s' %-22s %6s %12" PRIX64 "\n", number,
               object_register_name(debugger->setup.object, number, false), text.hex,
               text.number, length, c205_descriptor_address(word));
}

/* Lists the registers that are not 0. */
static bool info_registers(struct debugger *debugger)
{
    bool headed = false;
    for (unsigned i = 1; i < C205_REGISTERS; i++) {
        c205_word word = c205_register(machine_of(debugger), i);
        if (word == 0)
            continue;
        if (!headed)
            sink_print(&debugger->out, "%-17s %-22s %-22s %6s %12s\n", "register",
                       "word", "number", "length", "address");
        headed = true;
        put_register(debugger, i, word);
    }
    return true;
}

static bool info_breaks(struct debugger *debugger)
{
    if (debugger->breakpoint_count == 0)
        sink_put(&debugger->out, "no breakpoints or watchpoints\n");
    for (size_t i = 0; i < debugger->breakpoint_count; i++) {
        const struct breakpoint *stop = &debugger->breakpoints[i];
        sink_print(&debugger->out, "%zu %s %s%s%s%s, hit %" PRIu64 " time%s\n",
                   stop->number, stop->kind == BREAK_WATCH ? "watch" : "break",
                   stop->text, *stop->condition ? " if " : "", stop->condition,
                   stop->once ? ", once" : "", stop->hits, plural(stop->hits));
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
        if (!symbol->is_label)
            continue;
        sink_print(&debugger->out, "%6" PRIX64 "  %s", (uint64_t)symbol->value,
                   symbol->name);
        if (symbol->contents == ASM_CODE)
            sink_put(&debugger->out, ", code");
        else if (symbol->contents != ASM_NOTHING)
            sink_print(&debugger->out, ", %" PRIu64 " %s", symbol->count,
                       asm_contents_name(symbol->contents));
        sink_put(&debugger->out, "\n");
    }
    return true;
}

static bool info_operands(struct debugger *debugger)
{
    trap_report_operands(debugger->setup.object, machine_of(debugger),
                         c205_pc(machine_of(debugger)), &debugger->out);
    return true;
}

bool verb_info(struct debugger *debugger, struct text_cursor *cursor)
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
        if (text_cursor_begin(cursor, topics[i].name))
            return text_cursor_finish(debugger, cursor) && topics[i].show(debugger);
    return debug_fault(
        debugger, "expected registers, operands, breaks, regions, pages or symbols");
}
