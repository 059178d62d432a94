/* trace_event.c - writes a timeline as trace events for Perfetto and chrome://tracing:
 * complete events "X" in a thread for each row of a lane. A clock is written as one
 * microsecond. Source: Trace Event Format, Google.
 */
#include <inttypes.h>

#include "asm/timeline/timeline_lanes.h"
#include "base/json.h"

/* Returns the thread number of a row for the trace viewer. The rows of all lanes are
 * numbered consecutively. */
static unsigned thread_of(const struct lanes *lanes, enum lane lane, unsigned row)
{
    unsigned number = 1 + row;
    for (int i = 0; i < (int)lane; i++)
        number += lanes->rows[i];
    return number;
}

static void put_threads(const struct lanes *lanes, const struct sink *sink)
{
    for (int lane = 0; lane < LANES; lane++)
        for (unsigned row = 0; row < lanes->rows[lane]; row++) {
            unsigned thread = thread_of(lanes, (enum lane)lane, row);
            sink_print(sink,
                       "{\"name\":\"thread_name\",\"ph\":\"M\",\"pid\":1,"
                       "\"tid\":%u,\"args\":{\"name\":\"%s\"}},\n",
                       thread, lane_name((enum lane)lane));
            sink_print(sink,
                       "{\"name\":\"thread_sort_index\",\"ph\":\"M\","
                       "\"pid\":1,\"tid\":%u,\"args\":{\"sort_index\":%u}},\n",
                       thread, thread);
        }
}

static void put_span(const struct lanes *lanes, const struct timed_span *span,
                     const struct sink *sink)
{
    const char *cause = span->piece ? c205_cause_name(span->piece->cause) : "work";
    sink_put(sink, "{\"name\":");
    json_string(sink, span->lane == LANE_CHARGED ? cause : span->insn->insn->mnemonic);
    sink_print(sink,
               ",\"cat\":\"%s\",\"ph\":\"X\",\"pid\":1,\"tid\":%u,"
               "\"ts\":%" PRIu64 ",\"dur\":%" PRIu64 ",\"args\":{\"pc\":\"%" PRIX64
               "\",\"elements\":%zu,\"instruction\":",
               cause, thread_of(lanes, span->lane, span->row), span->begin,
               span->end - span->begin, span->insn->pc, span->insn->elements);
    json_string(sink, span->insn->text);
    if (*span->insn->line) {
        sink_put(sink, ",\"line\":");
        json_string(sink, span->insn->line);
    }
    sink_put(sink, "}}");
}

bool timeline_trace_events(const struct timeline *timeline, const struct sink *sink)
{
    struct arena arena = { NULL, false };
    struct lanes lanes = { 0 };
    bool good = lanes_make(timeline, &arena, &lanes);
    sink_put(sink, "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n");
    if (good)
        put_threads(&lanes, sink);
    sink_put(sink, "{\"name\":\"process_name\",\"ph\":\"M\",\"pid\":1,"
                   "\"args\":{\"name\":\"c205\"}}");
    for (size_t i = 0; good && i < lanes.count; i++) {
        sink_put(sink, ",\n");
        put_span(&lanes, &lanes.spans[i], sink);
    }
    sink_put(sink, "\n]}\n");
    arena_free(&arena);
    return good;
}
