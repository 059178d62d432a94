/* test_breakpoints.c - random addresses and lines for break, until and the protocol of
 * editors are compared with the starts of a program's instructions. An address is
 * accepted if and only if an instruction begins there. Any other verdict fails here. */
#include <inttypes.h>

#include "tests/unit/draw.h"
#include "tests/unit/dap_session.h"
#include "tests/unit/debugger_session.h"
#include "tests/unit/plain_run.h"

enum { PLACES = 1000, REQUESTS = 200 };

static const char *const programs[] = { "asm/examples/dot.s", "asm/examples/horner.s",
                                        "asm/examples/saxpy_linked.s",
                                        "asm/examples/saxpy_scalar.s",
                                        "asm/examples/sieve.s" };
enum { PROGRAMS = COUNT(programs) };

/* Returns a random address in, near or far from the code and the data. Most addresses
 * are multiples of a half word. */
static uint64_t draw_address(const struct object *object)
{
    const c205_program *program = &object->program;
    const c205_segment *segment = &program->segments[below(program->segment_count)];
    uint64_t half = segment->address / 32 + below(2 * segment->length + 8);
    switch (below(8)) {
    case 0: return below(2) * 32;
    case 1: return below(UINT64_C(1) << 48);
    case 2: return 32 * half + below(32);
    default: return 32 * half;
    }
}

static bool is_instruction(const struct object *object, uint64_t address)
{
    for (size_t i = 0; i < object->line_count; i++)
        if (object->lines[i].is_code && object->lines[i].address == address)
            return true;
    return false;
}

static void check_line(struct debug_session *session, const char *line, bool good,
                       const char *said)
{
    size_t stops = session->debugger->breakpoint_count;
    session_obey(session, line);
    FAIL_IF(session->debugger->breakpoint_count != stops + good
                || !session_says(session, said),
            "%s: %s", line, session->said.text);
    session_obey(session, "delete");
}

/* ---- Addresses ------------------------------------------------------------ */

/* The debugger has only the words, as from an object file, if `stripped` is set. */
static void check_addresses(const char *path, bool stripped)
{
    struct object *whole = good_file(path), *object = good_file(path);
    FREED_BY(session_end) struct debug_session session;

    if (stripped)
        object->line_count = 0;
    session_begin(&session, object, path);
    for (size_t i = 0; i < PLACES; i++) {
        uint64_t address = draw_address(whole);
        bool good = is_instruction(whole, address);
        const char *line = formatted("%s *0x%" PRIX64, below(2) ? "break" : "tbreak",
                                     address);
        check_line(&session, line, good,
                   good ? "break " : "error: no instruction begins at ");
    }
    object_free(whole);
}

TEST(addresses)
{
    for (size_t i = 0; i < PROGRAMS; i++) {
        check_addresses(programs[i], false);
        check_addresses(programs[i], true);
    }
}

/* Every address that a run reaches is accepted. */
TEST(visited)
{
    for (size_t i = 0; i < PROGRAMS; i++) {
        struct plain plain = run_plainly(good_file(programs[i]), &random_state);
        FREED_BY(session_end) struct debug_session session;

        session_begin(&session, plain.object, programs[i]);
        for (size_t k = 0; k < plain.end; k++) {
            const char *line = formatted("break *0x%" PRIX64, plain.moments[k].pc);
            check_line(&session, line, true, "break ");
        }
        free(plain.moments);
    }
}

/* ---- Lines ---------------------------------------------------------------- */

/* Returns the first line from `number` on that has or shows code, or whose macro call
 * contains code. Returns 0 if there is none. */
static size_t next_line(const struct object *object, const char *file, size_t number)
{
    size_t found = SIZE_MAX;
    for (size_t i = 0; i < object->line_count; i++) {
        const struct asm_line *line = &object->lines[i];
        if (!line->is_code)
            continue;
        if (strcmp(line->file, file) == 0 && line->number >= number
            && line->number < found)
            found = line->number;
        if (strcmp(line->shown.file, file) == 0 && line->shown.number >= number
            && line->shown.number < found)
            found = line->shown.number;
        if (strcmp(line->call.file, file) == 0 && line->call.number >= number
            && line->call.number < found)
            found = line->call.number;
    }
    return number == 0 || found == SIZE_MAX ? 0 : found;
}

/* The programs contain no LINKV, so that breakpoints stay at their lines. */
TEST(lines)
{
    static const char *const paths[] = { "asm/examples/dot.s",
                                         "asm/examples/saxpy_scalar.s",
                                         "asm/examples/sieve.s" };
    for (size_t i = 0; i < COUNT(paths); i++) {
        struct object *object = good_file(paths[i]);
        FREED_BY(session_end) struct debug_session session;

        session_begin(&session, object, paths[i]);
        for (long number = -3; number < 100; number++) {
            size_t wanted = number < 0 ? 0 : (size_t)number;
            size_t found = next_line(object, paths[i], wanted);
            char line[80], said[200] = "error: ";
            snprintf(line, sizeof line, "break %ld", number);
            if (found == wanted && found > 0)
                snprintf(said, sizeof said, ": %zu\n", found);
            else if (found > 0)
                snprintf(said, sizeof said, ": %zu (at %s:%zu)\n", wanted, paths[i],
                         found);
            check_line(&session, line, found > 0, said);
        }
    }
}

/* A breakpoint that is moved is shown and listed at its new line. */
TEST(moved)
{
    static const char text[] = "        ES   r10, 5\n"
                               "; a remark\n"
                               "        .data\n"
                               "datum:  .word 1.0\n"
                               "        .code\n"
                               "        LINKV\n"
                               "        MPYSV [r11], r10, [r11]\n"
                               "pair:   ADDNV [r11], r10, [r11]\n"
                               "        EXIT\n"
                               "behind:\n";
    static const struct line_said lines[] = {
        { "break 2 if r10 == 5", "break 1: 2 (at test.s:6) if r10 == 5" },
        { "info breaks", "1 break 2 (at test.s:6) if r10 == 5, hit 0" },
        { "c", "break 1: 2 (at test.s:6)\n" },
        { "break 8", "break 2: 8 (at test.s:6)\n" },
        { "break pair", "break 3: pair (at test.s:6)\n" },
        { "break 6", "break 4: 6\n" },
        { "break datum", "error: no instruction begins at 800000\n" },
        { "break behind", "error: no instruction begins at " },
        { "break 10", "error: test.s has no code at line 10 or after it" },
        { "break test.s:0", "error: lines are counted from 1" },
        { "break test.s:-1", "error: " },
        { "tbreak -1", "error: a place cannot begin with '-'" },
        { "until datum", "error: no instruction begins at 800000\n" },
        { "until 0", "error: lines are counted from 1" },
        { "list 0", "error: lines are counted from 1" },
    };
    check_session(text, lines, COUNT(lines), 9);
}

/* ---- The protocol of editors ---------------------------------------------- */

static void check_verified(struct dap_client *client, const char *request,
                           const char *stop, bool good)
{
    const struct json_value *list =
        the(client_ask(client, request,
                       "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [%s]}",
                       client_path, stop),
            "breakpoints");
    FAIL_IF(json_member_truth(list->first, "verified", !good) != good
                || !*the_text(list->first, "message"),
            "%s %s", request, stop);
}

TEST(protocol)
{
    SCOPED(object) *object = good(client_program);
    FREED_BY(client_leave) struct dap_client client;
    char stop[100];

    client_enter(&client, client_program);
    for (size_t i = 0; i < REQUESTS; i++) {
        uint64_t address = draw_address(object);
        snprintf(stop, sizeof stop, "{\"instructionReference\": \"0x%" PRIX64 "\"}",
                 address);
        check_verified(&client, "setInstructionBreakpoints", stop,
                       is_instruction(object, address));
    }
    for (int line = -2; line < 60; line++) {
        snprintf(stop, sizeof stop, "{\"line\": %d}", line);
        check_verified(&client, "setBreakpoints", stop,
                       line > 0 && next_line(object, "test.s", (size_t)line) > 0);
    }
    check_verified(&client, "setFunctionBreakpoints", "{\"name\": \"0\"}", false);
    check_verified(&client, "setFunctionBreakpoints", "{\"name\": \"a.words\"}", false);
    check_verified(&client, "setFunctionBreakpoints", "{\"name\": \"again\"}", true);
}
