/* kanata.c - writes a timeline in the format Kanata 0004 of the viewer Konata. Each
 * command is a line of words separated by tabs.
 *
 *   Kanata 0004      C= CLOCK         the clock at the start
 *   C N              N clocks pass
 *   I ID NUMBER 0    an instruction arrives
 *   L ID 0|1 TEXT    its text; 1: additional text
 *   S ID 0 STAGE     it enters a stage;  E ID 0 STAGE  it leaves the stage
 *   R ID NUMBER 0    it retires; NUMBER counts retired instructions
 *
 * Stages of scalar instructions: W waits to issue, X executes. Stages of vector
 * instructions: Su start-up, Tm translation misses, Pf page faults, Bc bank conflicts,
 * St stream. Source: Shioya, Konata's own description of the format.
 */
#include <inttypes.h>
#include <stdlib.h>

#include "asm/timeline/timeline.h"
#include "base/plural.h"

/* The kinds of events. Events at the same clock are written in the order of their
 * instructions. */
enum { LEAVES, RETIRES, APPEARS, ENTERS };

struct happening {
    uint64_t clock;
    size_t insn;
    int kind;
    size_t order; /* position in the order of additions */
    const char *stage;
};

struct log {
    struct happening *items;
    size_t count, capacity;
    struct arena *arena;
};

static const char *stage_of(c205_cause cause)
{
    switch (cause) {
    case C205_VECTOR_STARTUP: return "Su";
    case C205_TRANSLATION_MISS: return "Tm";
    case C205_PAGE_FAULT: return "Pf";
    case C205_BANK_CONFLICT: return "Bc";
    default: return "St";
    }
}

static bool add_event(struct log *log, uint64_t clock, size_t insn, int kind,
                      const char *stage)
{
    struct happening happening = { clock, insn, kind, log->count, stage };
    return arena_add(log->arena, &log->items, &log->count, &log->capacity, &happening,
                     sizeof happening);
}

/* Adds the events of a stage. A stage of no clocks is omitted. */
static bool add_stage(struct log *log, size_t insn, uint64_t begin, uint64_t end,
                      const char *stage)
{
    return begin == end
           || (add_event(log, begin, insn, ENTERS, stage)
               && add_event(log, end, insn, LEAVES, stage));
}

static bool add_insn(struct log *log, const struct timeline *timeline, size_t i)
{
    const struct timed_insn *insn = &timeline->insns[i];
    bool good = add_event(log, insn->arrived, i, APPEARS, NULL)
                && add_stage(log, i, insn->arrived, insn->issued, "W");
    for (size_t k = 0; good && k < insn->phase_count; k++) {
        const struct timed_piece *phase = &timeline->phases[insn->first_phase + k];
        good = add_stage(log, i, phase->begin, phase->end, stage_of(phase->cause));
    }
    if (good && insn->phase_count == 0)
        good = add_stage(log, i, insn->issued, insn->ready, "X");
    return good && add_event(log, insn->done, i, RETIRES, NULL);
}

static int compare(const void *a, const void *b)
{
    const struct happening *one = a, *other = b;
    if (one->clock != other->clock)
        return one->clock < other->clock ? -1 : 1;
    return (one->order > other->order) - (one->order < other->order);
}

static void put(const struct timeline *timeline, const struct happening *item,
                size_t *retired, const struct sink *sink)
{
    const struct timed_insn *insn = &timeline->insns[item->insn];
    size_t id = item->insn;
    switch (item->kind) {
    case APPEARS:
        sink_print(sink, "I\t%zu\t%zu\t0\n", id, id);
        sink_print(sink, "L\t%zu\t0\t%" PRIX64 ": %s\n", id, insn->pc, insn->text);
        sink_print(sink,
                   "L\t%zu\t1\tissued %" PRIu64 ", result %" PRIu64
                   ", %zu element%s%s%s\n",
                   id, insn->issued, insn->ready, insn->elements,
                   plural(insn->elements), *insn->line ? "; " : "", insn->line);
        break;
    case ENTERS: sink_print(sink, "S\t%zu\t0\t%s\n", id, item->stage); break;
    case LEAVES: sink_print(sink, "E\t%zu\t0\t%s\n", id, item->stage); break;
    default: sink_print(sink, "R\t%zu\t%zu\t0\n", id, (*retired)++); break;
    }
}

bool timeline_kanata(const struct timeline *timeline, const struct sink *sink)
{
    struct arena arena = { NULL, false };
    struct log log = { .arena = &arena };
    bool good = true;
    uint64_t clock;
    size_t retired = 0;
    for (size_t i = 0; good && i < timeline->insn_count; i++)
        good = !timeline->insns[i].insn || add_insn(&log, timeline, i);
    if (good && log.count > 0)
        qsort(log.items, log.count, sizeof *log.items, compare);
    clock = good && log.count > 0 ? log.items[0].clock : timeline->from;
    sink_print(sink, "Kanata\t0004\nC=\t%" PRIu64 "\n", clock);
    for (size_t i = 0; good && i < log.count; i++) {
        if (log.items[i].clock > clock)
            sink_print(sink, "C\t%" PRIu64 "\n", log.items[i].clock - clock);
        clock = log.items[i].clock;
        put(timeline, &log.items[i], &retired, sink);
    }
    arena_free(&arena);
    return good;
}
