/* test_dap_execution.c - the states that an editor reaches with random execution
 * requests in random programs are compared with a plain run of the same program. A stop
 * at another step, or for another reason, fails here. */
#include <unistd.h>

#include <inttypes.h>

#include "asm/object/object_file.h"
#include "tests/unit/dap_session.h"
#include "tests/unit/draw.h"
#include "tests/unit/plain_run.h"
#include "tests/unit/random_stepping.h"

/* ---- Random requests
 * -------------------------------------------------------------------- */

struct walk {
    struct dap_client client;
    struct plain plain;
    struct plain_stops stops;
    size_t step;
};

static void check_moment(struct walk *walk, const char *request)
{
    const struct moment *moment = &walk->plain.moments[walk->step];
    const struct json_value *item, *time = client_variables(&walk->client, "Time");
    size_t i = 0;
    FAIL_IF(strtoull(value_of(time, "step"), NULL, 10) != walk->step
                || strtoull(value_of(time, "clock"), NULL, 10) != moment->clock
                || client_pc(&walk->client) != moment->pc,
            "%s: step %s at clock %s, not %zu at %" PRIu64, request,
            value_of(time, "step"), value_of(time, "clock"), walk->step, moment->clock);
    item = client_variables(&walk->client, "All registers")->first;
    for (; item; item = item->next, i++)
        assert_true(word_in(the_text(item, "value")) == moment->registers[i]);
    assert_int_equal(i, C205_REGISTERS);
    const char *watched = formatted("[%" PRIu64 "]", walk->plain.watched);
    assert_true(word_in(client_print(&walk->client, watched)) == moment->watched);
}

static void choose_stops(struct walk *walk)
{
    walk->stops.place = walk->plain.moments[below(walk->plain.end)].pc;
    walk->stops.by_place = below(3) > 0;
    walk->stops.by_watch = below(2);
    client_ask(&walk->client, "setInstructionBreakpoints",
               walk->stops.by_place ? "{\"breakpoints\": "
                                      "[{\"instructionReference\": \"0x%" PRIX64 "\"}]}"
                                    : "{\"breakpoints\": []}",
               walk->stops.place);
    client_ask(&walk->client, "setDataBreakpoints",
               walk->stops.by_watch ? "{\"breakpoints\": [{\"dataId\": "
                                      "\"0x%" PRIX64 ", 1\"}]}"
                                    : "{\"breakpoints\": []}",
               walk->plain.watched);
}

/* Returns the expected reason of a stop: of two breakpoints the first that was set. */
static const char *reason_for(const struct walk *walk, const char *request, size_t from)
{
    bool steps_back = strcmp(request, "stepBack") == 0;
    if (walk->step == walk->plain.end)
        return "end";
    if (walk->step == 0)
        return steps_back && from > 0 ? "step" : "entry";
    if (steps_back || !plain_stops_at(&walk->plain, &walk->stops, walk->step))
        return "step";
    return walk->stops.by_place
                   && walk->plain.moments[walk->step].pc == walk->stops.place
               ? "instruction breakpoint"
               : "data breakpoint";
}

static void move_to(struct walk *walk, const char *request, size_t step)
{
    size_t from = walk->step;
    walk->step = step;
    client_ask(&walk->client, request,
               "{\"threadId\": 1, \"granularity\": \"instruction\"}");
    client_stopped(&walk->client, reason_for(walk, request, from));
    check_moment(walk, request);
}

/* Makes a random move. A program that has ended can only move backwards. */
static void move(struct walk *walk)
{
    size_t step = walk->step, end = walk->plain.end;
    switch (step == end ? 2 + below(2) : below(5)) {
    case 0:
        step = plain_on(&walk->plain, &walk->stops, step, UINT64_MAX);
        move_to(walk, "continue", step);
        break;
    case 1:
    case 4: move_to(walk, "stepIn", step + 1); break;
    case 2: move_to(walk, "stepBack", step > 0 ? step - 1 : 0); break;
    default:
        step = plain_back(&walk->plain, &walk->stops, step);
        move_to(walk, "reverseContinue", step);
    }
}

/* The instructions before an address are found by disassembling from the beginning. */
static void check_disassembly(struct walk *walk)
{
    enum { MAX = 60 };
    const struct json_value *all = client_disassembled(&walk->client, 0x400000, 0, MAX);
    int here = (int)below(MAX), before = (int)below((uint64_t)here + 1);
    const struct json_value *item = all->first, *from = all->first, *part;
    for (int i = 0; i < here; i++)
        item = item->next;
    for (int i = 0; i < here - before; i++)
        from = from->next;
    part = client_disassembled(&walk->client,
                               strtoull(the_text(item, "address"), NULL, 16), -before,
                               before + 1)
               ->first;
    for (; part; part = part->next, from = from->next)
        assert_string_equal(the_text(part, "address"), the_text(from, "address"));
}

TEST(motions)
{
    enum { ROUNDS = 12, MOVES = 60 };
    for (size_t i = 0; i < ROUNDS; i++) {
        struct walk walk = { .step = 0 };
        SCOPED_VALUE(text_buffer) text;
        draw_walk(&random_state, &text);
        walk.plain = run_plainly(good(text.text), &random_state);
        client_launch(&walk.client, text.text,
                      ", \"stopOnEntry\": true, \"stopOnEnd\": true, "
                      "\"model\": \"cyber205-2pipe-prior\"");
        client_ask(&walk.client, "configurationDone", NULL);
        client_stopped(&walk.client, "entry");
        for (size_t k = 0; k < MOVES; k++) {
            if (below(8) == 0)
                choose_stops(&walk);
            move(&walk);
        }
        check_disassembly(&walk);
        client_leave(&walk.client);
        object_free(walk.plain.object);
        free(walk.plain.moments);
    }
}

/* An object has no line table; its instructions are disassembled from the beginning. */
TEST(objects)
{
    enum { ROUNDS = 6 };
    client_write("");
    for (size_t i = 0; i < ROUNDS; i++) {
        struct walk walk = { .step = 0 };
        SCOPED_VALUE(text_buffer) text;
        draw_walk(&random_state, &text);
        SCOPED(object) *object = good(text.text);
        assert_true(object_save(object, client_path, &failure));
        client_launch_file(&walk.client, ", \"stopOnEntry\": true");
        client_ask(&walk.client, "configurationDone", NULL);
        client_stopped(&walk.client, "entry");
        assert_null(json_member(client_frames(&walk.client)->first, "source"));
        for (size_t k = 0; k < 20; k++)
            check_disassembly(&walk);
        client_leave(&walk.client);
    }
}
