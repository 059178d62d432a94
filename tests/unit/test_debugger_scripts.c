/* test_debugger_scripts.c - random debugger scripts have 40 lines with all commands,
 * for five programs. Their output is compared with a second run, byte for byte, and
 * execution after a restart is compared with its repetition. An output that depends on
 * earlier commands fails here.
 *
 * "test_debugger_scripts draw N PROGRAM" prints script N for a program. Another check
 * (tests/check_replay.sh) runs it in another way.
 */
#include <inttypes.h>

#include "tests/unit/draw.h"
#include "tests/unit/debugger_session.h"
#include "tests/unit/random_debug_program.h"

enum { PROGRAMS = 5, LINES = 40, LINE = 80, ROUNDS = 16 };
/* ---- Programs -------------------------------------------------------------- */

static const char *const examples[] = {
    "asm/examples/dot.s",          "asm/examples/horner.s",
    "asm/examples/lookup.s",       "asm/examples/saxpy_scalar.s",
    "asm/examples/saxpy_linked.s", "asm/examples/sieve.s",
};
static const char drawn[] = "drawn.s";

/* Opens a random program. Two in five programs are random texts. */
static struct object *open_program(const char **name)
{
    char text[DRAWN_TEXT + LINE];
    *name = below(5) < 2 ? drawn : examples[below(COUNT(examples))];
    if (*name != drawn)
        return good_file(*name);
    int length = sprintf(text, "        .equ    n, %d\n", 1 + (int)below(200));
    draw_program(&random_state, text + length);
    return good(text);
}

/* ---- Random lines ------------------------------------------------------- */

typedef char script_line[LINE];

#define PICK(texts) texts[below(COUNT(texts))]

/* Returns a random address of code or data. */
static uint64_t draw_address(const struct object *object, bool code)
{
    size_t count = object->line_count;
    const struct asm_line *line = &object->lines[below(count)];
    while (line->is_code != code)
        line = &object->lines[below(count)];
    return line->address;
}

static void draw_place(const struct object *object, script_line place)
{
    const c205_program *program = &object->program;
    const struct asm_symbol *symbol = &object->symbols[below(object->symbol_count)];
    static const char *const insns[] = { "EXIT", "ADDN",  "LOD", "STO",
                                         "EX",   "MPYSV", "ES",  "LINKV" };
    switch (below(5)) {
    case 0: snprintf(place, LINE, "insn %s", PICK(insns)); break;
    case 1:
        if (program->region_count > 0) {
            snprintf(place, LINE, "region %s", program->regions[0].name);
            break;
        }
        /* fall through */
    case 2:
        if (symbol->is_label) {
            snprintf(place, LINE, "%s", symbol->name);
            break;
        }
        /* fall through */
    default: snprintf(place, LINE, "*%" PRIu64, draw_address(object, true));
    }
}

static void draw_value(const struct object *object, script_line value)
{
    static const char *const values[] = {
        "step",       "clock",          "pc",      "$step % 7 == 0", "r10",
        "h21",        "r50.i",          "r14 + 1", "clock / 3",      "r12 < 4 || r13",
        "!(r15 - 2)", "r50.length * 2",
    };
    if (below(3) == 0)
        snprintf(value, LINE, "[%" PRIu64 "]", draw_address(object, false));
    else
        snprintf(value, LINE, "%s", PICK(values));
}

/* Makes a line with a random command that executes the program forward or back. */
static void draw_motion(const struct object *object, script_line line)
{
    static const char *const plain[] = {
        "",     "continue", "c 2", "reverse-continue", "rc", "run",
        "next", "step",     "rs",  "goto 0",
    };
    static const char *const counted[] = { "step", "next",       "reverse-step",
                                           "goto", "goto clock", "continue" };
    switch (below(5)) {
    case 0:
    case 1: snprintf(line, LINE, "%s", PICK(plain)); break;
    case 2: snprintf(line, LINE, "until *%" PRIu64, draw_address(object, true)); break;
    default:
        snprintf(line, LINE, "%s %d", PICK(counted), (int)below(below(2) ? 20 : 1500));
    }
}

/* Makes a line with a random command that prints the state of the program. */
static void draw_view(const struct object *object, script_line line)
{
    static const char *const plain[] = {
        "where",          "list",         "disassemble",   "why",
        "account",        "info pages",   "info operands", "info regions",
        "info registers", "info symbols", "help",
    };
    static const char formats[] = "fixhb";
    script_line value;
    switch (below(6)) {
    case 0:
        draw_value(object, value);
        snprintf(line, LINE, "print %.60s", value);
        break;
    case 1:
        snprintf(line, LINE, "x/%d%c %" PRIu64, 1 + (int)below(8), formats[below(5)],
                 draw_address(object, below(2)));
        break;
    case 2:
        snprintf(line, LINE, "%s *%" PRIu64 ", %d", below(2) ? "list" : "disassemble",
                 draw_address(object, true), 1 + (int)below(6));
        break;
    default: snprintf(line, LINE, "%s", PICK(plain));
    }
}

/* Makes a line that sets a breakpoint. */
static void draw_stop(const struct object *object, script_line line)
{
    script_line place, value;
    draw_place(object, place);
    draw_value(object, value);
    if (below(3) == 0)
        snprintf(line, LINE, "watch %" PRIu64 ", %d", draw_address(object, false),
                 1 + (int)below(3));
    else if (below(3) == 0)
        snprintf(line, LINE, "break %.30s if %.30s", place, value);
    else
        snprintf(line, LINE, "break %.60s", place);
}

/* Makes a line that changes other parts of the session. */
static void draw_change(const struct object *object, script_line line)
{
    script_line place;
    draw_place(object, place);
    switch (below(5)) {
    case 0: snprintf(line, LINE, "tbreak %.60s", place); break;
    case 1: snprintf(line, LINE, "delete %d", 1 + (int)below(4)); break;
    case 2:
        snprintf(line, LINE, "set r%d = %d", 10 + (int)below(50), (int)below(1000));
        break;
    case 3:
        snprintf(line, LINE, "set [%" PRIu64 "] = %d.5", draw_address(object, false),
                 (int)below(100));
        break;
    default: strcpy(line, below(4) ? "info breaks" : "delete");
    }
}

static void draw_line(const struct object *object, script_line line)
{
    script_line value;
    switch (below(10)) {
    case 0: draw_change(object, line); break;
    case 1:
    case 2: draw_stop(object, line); break;
    case 3:
        draw_value(object, value);
        snprintf(line, LINE, "assert %.60s", value);
        break;
    case 4:
    case 5:
    case 6: draw_view(object, line); break;
    default: draw_motion(object, line);
    }
}

/* ---- Sessions -------------------------------------------------------------- */

static struct debugger *begin(const struct object *object, const char *name,
                              struct text_buffer *said)
{
    struct debugger_setup setup = { .object = object,
                                    .name = name,
                                    .model = prior_model,
                                    .out = text_buffer_sink(said),
                                    .clocks_most = 10000000 };
    struct debugger *debugger = NON_NULL(debugger_new(&setup, &failure));
    debugger_greet(debugger);
    return debugger;
}

static void obey(struct debugger *debugger, struct text_buffer *said, const char *line)
{
    struct sink sink = text_buffer_sink(said);
    sink_print(&sink, "(c205) %s\n", line);
    assert_true(debugger_obey(debugger, line));
}

/* Runs a script. Returns its complete output, which the caller frees. */
static struct text_buffer play(const struct object *object, const char *name,
                               script_line *lines, size_t count)
{
    struct text_buffer said = { 0 };
    SCOPED(debugger) *debugger = begin(object, name, &said);
    for (size_t i = 0; i < count; i++)
        obey(debugger, &said, lines[i]);
    assert_false(said.failed);
    return said;
}

static void check_same(const struct text_buffer *one, const struct text_buffer *other,
                       const char *name)
{
    FAIL_IF(one->length != other->length
                || memcmp(one->text, other->text, one->length) != 0,
            "%s:\n%s\nand again:\n%s", name, one->text, other->text);
}

/* Two debuggers run the script in turn. They must not affect each other. */
static void check_in_turn(const struct object *object, const char *name,
                          script_line *lines, const struct text_buffer *expected)
{
    struct text_buffer said[2] = { { 0 }, { 0 } };
    struct debugger *debugger[2];
    for (int k = 0; k < 2; k++)
        debugger[k] = begin(object, name, &said[k]);
    for (size_t i = 0; i < LINES; i++)
        for (int k = 0; k < 2; k++)
            obey(debugger[k], &said[k], lines[i]);
    for (int k = 0; k < 2; k++) {
        check_same(expected, &said[k], name);
        text_buffer_free(&said[k]);
        debugger_free(debugger[k]);
    }
}

/* At most a third of the lines are invalid. */
TEST(scripts)
{
    size_t all = 0, faults = 0;
    for (size_t i = 0; i < ROUNDS * PROGRAMS; i++) {
        static script_line lines[LINES];
        const char *name;
        SCOPED(object) *object = open_program(&name);
        for (size_t k = 0; k < LINES; k++)
            draw_line(object, lines[k]);
        SCOPED_VALUE(text_buffer) said = play(object, name, lines, LINES);
        SCOPED_VALUE(text_buffer) again = play(object, name, lines, LINES);
        check_same(&said, &again, name);
        check_in_turn(object, name, lines, &said);
        all += LINES;
        faults += count_of(said.text, "\nerror: ");
    }
    assert_true(faults > 0 && faults * 3 < all);
}

/* Runs the program once, because its own output is printed only the first time, and
 * sets breakpoints. Then a random list of debugger commands is executed twice, each
 * time from step 0. Both executions must print the same. */
static void check_anew(const struct object *object, const char *name)
{
    enum { STOPS = 3 };
    struct text_buffer before = { 0 }, said[2] = { { 0 }, { 0 } };
    struct sink sink[2] = { text_buffer_sink(&said[0]), text_buffer_sink(&said[1]) };
    static script_line lines[LINES];
    SCOPED(debugger) *debugger = begin(object, name, &before);
    obey(debugger, &before, "run");
    for (int i = 0; i < STOPS; i++) {
        draw_stop(object, lines[i]);
        obey(debugger, &before, lines[i]);
    }
    for (size_t i = 0; i < LINES; i++)
        if (below(2) || i == 0)
            draw_view(object, lines[i]);
        else
            draw_motion(object, lines[i]);
    strcpy(lines[0], below(2) ? "goto 0" : "run");
    strcpy(lines[1], "step"); /* the command that an empty line repeats */
    for (int k = 0; k < 2; k++) {
        debugger->out = sink[k];
        for (size_t i = 0; i < LINES; i++)
            obey(debugger, &said[k], lines[i]);
    }
    check_same(&said[0], &said[1], name);
    text_buffer_free(&before);
    text_buffer_free(&said[0]);
    text_buffer_free(&said[1]);
}

TEST(again)
{
    for (size_t i = 0; i < ROUNDS * PROGRAMS; i++) {
        const char *name;
        SCOPED(object) *object = open_program(&name);
        check_anew(object, name);
    }
}

/* ---- Printed scripts ------------------------------------------------------- */

static int print_script(const char *number, const char *path)
{
    SCOPED(object) *object = good_file(path);
    script_line line;
    random_state ^= strtoull(number, NULL, 10) << 20;
    for (int i = 0; i < LINES; i++) {
        draw_line(object, line);
        puts(line);
    }
    return 0;
}

ARGUMENTS(argc, argv)
{
    if (argc == 4 && strcmp(argv[1], "draw") == 0)
        exit(print_script(argv[2], argv[3]));
}
