/* fuzz_debugger.c - reads any bytes as lines for the debugger of a small program. The
 * accounts must sum to the clock, and moving backward must reach step 0. */
#include <string.h>

#include "asm/debug/debug_internal.h"
#include "asm/text/assemble.h"
#include "tests/fuzz/fuzz.h"

bool fuzz_accepted;

enum { MAX_LINES = 8, MAX_ASKED = 20 };

static const char text[] = "        .include \"vectors.s\"\n"
                           "        .regs r16, a, b, turns, to\n"
                           "        words a, 1.5, -2.0, 3.0, 4.0\n"
                           "        words b\n"
                           "        ES    turns, 5\n"
                           "        EX    to, again\n"
                           "        .kernel loop\n"
                           "again:  ADDNV [a], [a], [b]\n"
                           "        LINKV\n"
                           "        MPYSV [a], [b], [b]\n"
                           "        ADDNV [b], [a], [b]\n"
                           "        DBNZ  turns, [to]\n"
                           "        .endkernel\n"
                           "        EXIT  turns, r0, 2\n"
                           "        EXIT\n";

static void ignore(void *context UNUSED, const char *said UNUSED, size_t length UNUSED)
{
}

/* The number of checks for an interruption. It limits programs that run forever because
 * a line has changed them. */
static unsigned asked;

static bool is_enough(void *unused UNUSED)
{
    return ++asked > MAX_ASKED;
}

static void check_clock(struct debugger *debugger)
{
    const c205 *machine = machine_of(debugger);
    uint64_t sum = 0;
    for (size_t i = 0; i < c205_account_count(machine); i++)
        for (int cause = 0; cause < C205_CAUSES; cause++)
            sum += c205_account_at(machine, i)->clocks[cause];
    must(sum == c205_clock(machine));
    fuzz_accepted = fuzz_accepted || sum > 0;
}

static void obey_lines(struct debugger *debugger, char *lines)
{
    size_t count = 0;
    for (char *line = strtok(lines, "\n"); line && count < MAX_LINES;
         line = strtok(NULL, "\n"), count++) {
        asked = 0;
        if (!debugger_obey(debugger, line))
            break;
        check_clock(debugger);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct object *object;
    struct diagnostics errors = { 0 };
    struct debugger_setup setup = { .model = fuzz_model(),
                                    .name = "fuzz.s",
                                    .out = { ignore, NULL },
                                    .clocks_most = 1000000,
                                    .interrupted = is_enough };
    c205_error error;
    FREED char *lines = malloc(size + 1);
    must(lines != NULL);
    memcpy(lines, data, size);
    lines[size] = '\0';
    if (!object)
        object = assemble_text("fuzz.s", text, NULL, &errors);
    must(object);
    setup.object = object;
    SCOPED(debugger) *debugger = debugger_new(&setup, &error);
    must(debugger != NULL);
    obey_lines(debugger, lines);
    debugger_obey(debugger, "goto 0");
    must(c205_clock(machine_of(debugger)) == 0);
    return 0;
}
