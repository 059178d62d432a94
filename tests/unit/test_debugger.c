/* test_debugger.c - lines by chance for the debugger: it stands where a plain run from the
 * beginning says that it must; and lines that it cannot do change nothing. */
#include "asm/debug/parts.h"
#include "tests/random.h"
#include "tests/unit/asm_helper.h"
#include "tests/unit/prior_model.h"

enum { STEPS_MOST = 3000, LINES = 300, ROUNDS = 4 };

static const char *const programs[] = {
    "asm/examples/dot.s", "asm/examples/horner.s", "asm/examples/lookup.s",
    "asm/examples/saxpy_scalar.s", "asm/examples/sieve.s"
};
enum { PROGRAMS = sizeof programs / sizeof *programs };

static uint64_t random_state = RANDOM_SEED;

static uint64_t below(uint64_t end)
{
    return xorshift(&random_state) % end;
}

/* ---- A plain run ---------------------------------------------------------- */

/* Before each step. */
struct moment {
    uint64_t pc, clock;
    c205_word registers[C205_REGISTERS];
    c205_word watched;
};

struct plain {
    struct object *object;
    uint64_t watched;       /* a word of memory */
    size_t end;             /* steps until the program ends */
    struct moment *moments; /* [end + 1] */
};

static struct moment moment_of(const c205 *machine, uint64_t watched)
{
    struct moment moment = { .pc = c205_pc(machine),
                             .clock = c205_clock(machine) };

    for (unsigned i = 0; i < C205_REGISTERS; i++)
        moment.registers[i] = c205_register(machine, i);
    c205_read(machine, watched, &moment.watched, 1);
    return moment;
}

static struct plain run_plainly(const char *path)
{
    struct diagnostics errors = { 0 };
    struct plain plain = { .object = assemble_file(path, NULL, &errors) };
    const c205_segment *last;
    c205_error error;
    c205 *machine = c205_new(prior_model, &error);
    c205_stop stop;

    assert_non_null(plain.object);
    diagnostics_free(&errors);
    last = &plain.object->program
                .segments[plain.object->program.segment_count - 1];
    plain.watched = last->address + 64 * below(last->length);
    plain.moments = malloc((STEPS_MOST + 1) * sizeof *plain.moments);
    assert_true(c205_load(machine, &plain.object->program, &error));
    plain.moments[0] = moment_of(machine, plain.watched);
    for (bool goes_on = true; goes_on && plain.end < STEPS_MOST;) {
        goes_on = c205_step(machine, &stop);
        plain.moments[++plain.end] = moment_of(machine, plain.watched);
    }
    assert_true(plain.end < STEPS_MOST);
    c205_free(machine);
    return plain;
}

static void free_plain(struct plain *plain)
{
    object_free(plain->object);
    free(plain->moments);
}

/* ---- What must become of a line ------------------------------------------- */

/* Stops that the debugger was told of; the oracle keeps its own list. */
struct told {
    bool by_watch, by_place;
    uint64_t place;
    size_t every;       /* the place counts at steps that this divides */
    const char *region; /* that is entered; NULL: none */
};

static const char *region_of(const struct plain *plain, uint64_t pc)
{
    const c205_program *program = &plain->object->program;

    for (size_t i = 0; i < program->region_count; i++)
        if (pc >= program->regions[i].begin && pc < program->regions[i].end)
            return program->regions[i].name;
    return "";
}

static bool enters(const struct plain *plain, const char *region, size_t step)
{
    return strcmp(region_of(plain, plain->moments[step].pc), region) == 0
           && strcmp(region_of(plain, plain->moments[step - 1].pc), region)
                  != 0;
}

static bool stops_at(const struct plain *plain, const struct told *told,
                     size_t step)
{
    const struct moment *now = &plain->moments[step];

    if (step == 0 || step == plain->end)
        return false;
    return (told->by_place && now->pc == told->place
            && step % told->every == 0)
           || (told->region && enters(plain, told->region, step))
           || (told->by_watch && now->watched != now[-1].watched);
}

static bool begins_with_stop(const struct plain *plain,
                             const struct told *told)
{
    uint64_t pc = plain->moments[0].pc;

    return (told->by_place && pc == told->place)
           || (told->region
               && strcmp(region_of(plain, pc), told->region) == 0);
}

static size_t on_from(const struct plain *plain, const struct told *told,
                      size_t step, uint64_t count)
{
    while (step < plain->end && count-- > 0)
        if (stops_at(plain, told, ++step))
            break;
    return step;
}

static size_t back_from(const struct plain *plain, const struct told *told,
                        size_t step)
{
    while (step > 0 && !stops_at(plain, told, --step))
        continue;
    return step;
}

static size_t to_clock(const struct plain *plain, size_t step, uint64_t clock)
{
    if (plain->moments[step].clock >= clock)
        step = 0;
    while (step < plain->end && plain->moments[step].clock < clock)
        step++;
    return step;
}

static size_t to_place(const struct plain *plain, const struct told *told,
                       size_t step, uint64_t place)
{
    while (step < plain->end) {
        step++;
        if (plain->moments[step].pc == place || stops_at(plain, told, step))
            break;
    }
    return step;
}

/* ---- Lines by chance ------------------------------------------------------ */

struct session {
    const struct plain *plain;
    struct debugger *debugger;
    struct text_buffer said;
    struct told told;
    size_t step;
};

static void obey(struct session *session, const char *line)
{
    text_buffer_free(&session->said);
    session->said = (struct text_buffer){ 0 };
    assert_true(debugger_obey(session->debugger, line));
}

static void choose_place(struct session *session)
{
    char line[80];

    session->told.by_place = true;
    session->told.place = session->plain->moments[below(session->plain->end)]
                              .pc;
    session->told.every = 1 + below(below(2) ? 3 : 97);
    obey(session, "delete");
    session->told.by_watch = false;
    session->told.region = NULL;
    snprintf(line, sizeof line, "break *%llu if $step %% %zu == 0",
             (unsigned long long)session->told.place, session->told.every);
    obey(session, line);
}

static void choose_region(struct session *session)
{
    const c205_program *program = &session->plain->object->program;
    char line[80];

    if (session->told.region || program->region_count == 0)
        return;
    session->told.region = program->regions[below(program->region_count)]
                               .name;
    snprintf(line, sizeof line, "break region %s", session->told.region);
    obey(session, line);
}

static void choose_watch(struct session *session)
{
    char line[80];

    if (session->told.by_watch)
        return;
    session->told.by_watch = true;
    snprintf(line, sizeof line, "watch *%llu",
             (unsigned long long)session->plain->watched);
    obey(session, line);
}

/* A line, and where the program must stand behind it. */
static size_t draw_line(struct session *session, char line[80])
{
    const struct plain *plain = session->plain;
    const struct told *told = &session->told;
    size_t step = session->step;
    uint64_t number;

    switch (below(8)) {
    case 0:
        number = 1 + below(40);
        snprintf(line, 80, "step %llu", (unsigned long long)number);
        return on_from(plain, told, step, number);
    case 1:
        number = 1 + below(40);
        snprintf(line, 80, "reverse-step %llu", (unsigned long long)number);
        return step > number ? step - (size_t)number : 0;
    case 2: strcpy(line, "c"); return on_from(plain, told, step, UINT64_MAX);
    case 3: strcpy(line, "rc"); return back_from(plain, told, step);
    case 4:
        number = below(plain->end + 1);
        snprintf(line, 80, "goto %llu", (unsigned long long)number);
        return (size_t)number;
    case 5:
        number = below(plain->moments[plain->end].clock + 1);
        snprintf(line, 80, "goto clock %llu", (unsigned long long)number);
        return to_clock(plain, step, number);
    case 6:
        strcpy(line, "run");
        return begins_with_stop(plain, told)
                   ? 0
                   : on_from(plain, told, 0, UINT64_MAX);
    default:
        number = plain->moments[below(plain->end)].pc;
        snprintf(line, 80, "until *%llu", (unsigned long long)number);
        return to_place(plain, told, step, number);
    }
}

static void check_place(const struct session *session, const char *line)
{
    const struct moment *expected = &session->plain->moments[session->step];
    struct moment found = moment_of(machine_of(session->debugger),
                                    session->plain->watched);

    if (c205_history_step(session->debugger->history) != session->step
        || memcmp(&found, expected, sizeof found) != 0)
        fail_msg(
            "'%s' (watch %d, place %d every %zu, region %s): step %llu, not %zu, or another state; it said %s",
            line, session->told.by_watch, session->told.by_place,
            session->told.every,
            session->told.region ? session->told.region : "none",
            (unsigned long long)c205_history_step(session->debugger->history),
            session->step, session->said.text);
}

static void move(struct session *session)
{
    char line[80];

    session->step = draw_line(session, line);
    obey(session, line);
    check_place(session, line);
}

static void begin(struct session *session, const struct plain *plain,
                  const char *name)
{
    c205_error error;

    *session = (struct session){ .plain = plain };
    session->debugger =
        debugger_new(&(struct debugger_setup){ .object = plain->object,
                                               .name = name,
                                               .model = prior_model,
                                               .out = text_buffer_sink(
                                                   &session->said) },
                     &error);
    assert_non_null(session->debugger);
}

static void end(struct session *session)
{
    text_buffer_free(&session->said);
    debugger_free(session->debugger);
}

static void test_movements(void **state)
{
    (void)state;
    for (size_t i = 0; i < ROUNDS * PROGRAMS; i++) {
        struct plain plain = run_plainly(programs[i % PROGRAMS]);
        struct session session;

        begin(&session, &plain, programs[i % PROGRAMS]);
        for (size_t k = 0; k < LINES; k++) {
            if (below(20) == 0)
                choose_place(&session);
            if (below(20) == 0)
                choose_watch(&session);
            if (below(20) == 0)
                choose_region(&session);
            move(&session);
        }
        assert_int_equal(debugger_faults(session.debugger), 0);
        end(&session);
        free_plain(&plain);
    }
}

/* One stop, and from each step behind it the way back. */
static void test_far_back(void **state)
{
    enum { STOP = 150, FAR = 400 };
    struct plain plain = run_plainly("asm/examples/saxpy_scalar.s");
    struct session session;
    char line[80];

    (void)state;
    begin(&session, &plain, "saxpy_scalar.s");
    snprintf(line, sizeof line, "break *%llu if $step == %d",
             (unsigned long long)plain.moments[STOP].pc, STOP);
    obey(&session, line);
    for (session.step = STOP + 1; session.step < STOP + FAR; session.step++) {
        snprintf(line, sizeof line, "goto %zu", session.step);
        obey(&session, line);
        check_place(&session, line);
        obey(&session, "rc");
        assert_int_equal(c205_history_step(session.debugger->history), STOP);
    }
    end(&session);
    free_plain(&plain);
}

/* ---- Values --------------------------------------------------------------- */

static const char text[] = "        .include \"vectors.s\"\n"
                           "        .regs r16, a, b, count\n"
                           "        .equ  n, 4\n"
                           "        words a, 1.5, -2.0, 3.0\n"
                           "        words b\n"
                           "        .regs r20, bits\n"
                           "        .data\n"
                           "mask:   .word X'A000 0000 0000 0000'\n"
                           "        .code\n"
                           "        descriptor bits, mask, n\n"
                           "        ES    count, 7\n"
                           "here:   ADDNV [a], [a], [b] ? [bits]\n"
                           "        LODH  [r0], h99\n"
                           "        EXIT\n";

struct line_said {
    const char *line, *said; /* a part of it */
};

static struct plain plain_of(void)
{
    return (struct plain){ .object = good(text) };
}

static void check_lines(struct session *session,
                        const struct line_said *lines, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        obey(session, lines[i].line);
        if (!strstr(session->said.text ? session->said.text : "",
                    lines[i].said))
            fail_msg("%s: %s", lines[i].line, session->said.text);
    }
}

static void test_values(void **state)
{
    static const struct line_said lines[] = {
        { "print n * 2 + 1", "9  X'9'" },
        { "until here", "here:" },
        { "print count", "number 7  address 7" },
        { "p count.i % 4", "3" },
        { "p a.length == n && !(count < 7)", "1" },
        { "p r18 - 0.5", "6.5" },
        { "p [a + 0] * 2", "is no address; that of a descriptor is NAME.i" },
        { "p [-64]", "error: there is no word at FFFFFFFFFFC0" },
        { "p [X'FFFFFFFFFFFFFFC0']", "error: there is no word at" },
        { "p [a.i] * 2", "3" },
        { "p [a.i+64] < -1 || 0", "1" },
        { "p X'FFD2 4000 0000 0000'", "number 1" },
        { "p -(2 - 5) / 2", "1" },
        { "p 7 / 2.0", "3.5" },
        { "x /2x a", "FFD2 6000 0000 0000" },
        { "x a ? bits", "  1             1.5  0              -2  1" },
        { "x/3b mask", "101" },
        { "step", "LODH" },
        { "step", "trap unmapped-address" },
        { "why", "vector start-up" },
        { "x b", "3" },
        { "set r18 = 9", "" },
        { "p count", "number 9" },
        { "set h37 = 2.5", "" },
        { "p h37", "number 2.5" },
        { "p (h37)", "number 2.5" },
        { "set r30 = h37", "" },
        { "p r30", "number 2.5" },
        { "set h50 = X'EC500000'", "" },
        { "p h50 == X'EC500000' && h50 == 5 && h50 + 1 == 6", "1" },
        { "set r31 = 5", "" },
        { "set r32 = 5.0", "" },
        { "p r31 == r32", "1" },
        { "set [b.i] = X'0000000500000005'", "" },
        { "x/2hi b.i", "             5               5" },
        { "set [b.i] = 3.0", "" },
        { "p 010 + 08", "18" },
        { "p h36", "number 0" },
        { "set [b.i + 64] = -4", "" },
        { "p [b.i + 64]", "number -4" },
        { "rs", "here:" },
        { "why", "ES r18, 7" },
        { "p count", "number 7" },
        { "info breaks", "there are none" },
        { "tbreak insn ADDNV if count == 8", "break 1: insn ADDNV if" },
        { "info breaks", "1 break insn ADDNV if count == 8, once, met 0" },
        { "info pages", "read and written" },
        { "info symbols", "here" },
        { "info operands", "[r20]: bits from" },
        { "list here, 1", "here:" },
        { "disassemble here, 2", "LODH" },
        { "help", "reverse-continue" },
    };
    struct plain plain = plain_of();
    struct session session;

    (void)state;
    begin(&session, &plain, "-");
    session.plain = &plain;
    check_lines(&session, lines, sizeof lines / sizeof *lines);
    assert_int_equal(debugger_faults(session.debugger), 3);
    end(&session);
    free_plain(&plain);
}

/* What it cannot do it says, and stands where it stood. */
static void test_faults(void **state)
{
    static const struct line_said lines[] = {
        { "stpe", "there is no 'stpe': was it step?" },
        { "!", "there is no '!'" },
        { "step 1 2", "what is '2' to mean?" },
        { "step -1", "-1 is no count" },
        { "break", "where? a label, a line" },
        { "break nowhere", "nothing is called 'nowhere'" },
        { "break 1000", "has no code at line 1000" },
        { "break other.s:3", "other.s has no code at line 3" },
        { "break here if", "expected a value" },
        { "break here when 3", "what is 'when 3' to mean?" },
        { "break insn ADD", "no instruction is called 'ADD'" },
        { "break region none", "no region is called 'none'" },
        { "watch *8000000000", "there are no words at" },
        { "watch mask, 65", "1 to 64 words are watched" },
        { "delete 3", "there is no stop 3" },
        { "print", "expected a value" },
        { "print (1", "a ) is missing" },
        { "print [mask", "a ] is missing" },
        { "print 1 / 0", "a division by 0" },
        { "print 1z", "'1z' is no number" },
        { "print X'12G'", "a word is X' and up to 16 hex digits" },
        { "print [1]", "there is no word at 1" },
        { "x/3q mask", "after / stand a count and f, i, x, h or b" },
        { "x mask ? 3", "behind ? stands the register" },
        { "x/4 8000000000", "no memory is mapped there" },
        { "info colours", "info is of registers, operands" },
        { "set count", "set REGISTER = VALUE" },
        { "set 3 = 4", "set REGISTER = VALUE" },
        { "set [1] = 4", "there is no word at 1" },
        { "set r0 = 4", "register 0 stays what it is" },
        { "set r9 = 140737488355328", "more than the 48 bits of an integer" },
        { "set r9 = 1e400", "is too large" },
        { "p 99999999999999999999", "is too large" },
        { "x/100000000 mask", "a count of at most 65535" },
        { "disassemble , 100001", "at most 100000 instructions are shown" },
        { "why", "no instruction has been executed" },
        { "assert 1 == 2", "it does not hold: 1 == 2" },
        { "goto nowhere", "nothing is called 'nowhere'" },
        { "until *1.5", "1.5 is no address" },
    };
    enum { COUNT = sizeof lines / sizeof *lines };
    struct plain plain = plain_of();
    struct session session;

    (void)state;
    begin(&session, &plain, "-");
    check_lines(&session, lines, COUNT);
    assert_int_equal(debugger_faults(session.debugger), COUNT);
    assert_int_equal(c205_history_step(session.debugger->history), 0);
    assert_int_equal(session.debugger->stop_count, 0);
    assert_false(debugger_obey(session.debugger, "quit"));
    end(&session);
    free_plain(&plain);
}

/* What a program prints is printed once, however often it is gone through. */
static void test_printed(void **state)
{
    struct plain plain = { .object = good("        ES  r10, 5\n"
                                          "        EXIT r10, r0, 2\n"
                                          "        EXIT r0, r0, 5\n"
                                          "        ES  r10, 6\n"
                                          "        EXIT\n") };
    struct session session;

    (void)state;
    begin(&session, &plain, "-");
    obey(&session, "step 3");
    assert_non_null(strstr(session.said.text, "5\n"));
    obey(&session, "goto 0");
    obey(&session, "step 4");
    assert_null(strstr(session.said.text, "5\n"));
    obey(&session, "");
    assert_non_null(strstr(session.said.text, "ended with status 0"));
    end(&session);
    free_plain(&plain);
}

/* A call is one for next; a break at an instruction of a linked pair is one at its
 * LINKV. */
static void test_calls_and_links(void **state)
{
    static const struct line_said lines[] = {
        { "next 2", "BSAVE" },
        { "next", "=> 400080" },
        { "print step", "6" },
        { "break first", "break 1" },
        { "break second", "break 2" },
        { "run", "break 1: first" },
        { "print pc == linked", "1" },
        { "delete 1", "" },
        { "run", "break 2: second" },
        { "print pc == linked", "1" },
        { "step", "EXIT" },
    };
    struct plain plain = { .object = good(
                               "        .include \"vectors.s\"\n"
                               "        .regs r16, a, link\n"
                               "        .code\n"
                               "        EX   r20, routine\n"
                               "        ES   r22, 3\n"
                               "        BSAVE link, [r20]\n"
                               "        words a, 1.0, 2.0, 3.0, 4.0\n"
                               "linked: LINKV\n"
                               "first:  MPYSV [a], [a], [a]\n"
                               "second: ADDNV [a], [a], [a]\n"
                               "        EXIT\n"
                               "routine: ES  r21, 1\n"
                               "        ES   r21, 2\n"
                               "        BIM  0, link\n") };
    struct session session;

    (void)state;
    begin(&session, &plain, "test.s");
    check_lines(&session, lines, sizeof lines / sizeof *lines);
    assert_int_equal(debugger_faults(session.debugger), 0);
    end(&session);
    free_plain(&plain);
}

static bool has(const struct session *session, const char *part)
{
    return session->said.text && strstr(session->said.text, part);
}

/* Behind its end a program does not go on, whatever is asked. */
static void test_end(void **state)
{
    static const char *const lines[] = { "step",     "rs 0",
                                         "goto 4",   "c",
                                         "until *0", "goto clock 100000" };
    struct plain plain = { .object = good("        ES  r10, 5\n"
                                          "        ES  r11, 6\n"
                                          "        DIVS r10, r11, r12\n"
                                          "        EXIT\n") };
    struct session session;

    (void)state;
    begin(&session, &plain, "-");
    obey(&session, "run");
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        obey(&session, lines[i]);
        if (!has(&session, "ended with status 0"))
            fail_msg("%s: %s", lines[i], session.said.text);
    }
    obey(&session, "set r10 = 3");
    assert_true(has(&session, "go back first"));
    obey(&session, "why");
    assert_true(has(&session, "and until all in flight was done"));
    assert_true(has(&session, "operand wait"));
    end(&session);
    free_plain(&plain);
}

/* What a run prints that somebody has changed is printed. */
static void test_printed_again(void **state)
{
    struct plain plain = { .object = good("        ES  r10, 5\n"
                                          "        EXIT r10, r0, 2\n"
                                          "        EXIT\n") };
    struct session session;

    (void)state;
    begin(&session, &plain, "-");
    obey(&session, "run");
    assert_true(has(&session, "5\n"));
    obey(&session, "goto 1");
    obey(&session, "set r10 = 77");
    obey(&session, "c");
    assert_true(has(&session, "77\n"));
    end(&session);
    free_plain(&plain);
}

/* Stops at lines: of a macro's call at its first instruction, of a line in a macro at each of
 * its calls, of data behind them; several at one step are all told. */
static void test_lines_and_several(void **state)
{
    static const struct line_said lines[] = {
        { "break 9", "break 1: 9" },
        { "break 11", "break 2: 11" },
        { "break test.s:4", "break 3: test.s:4" },
        { "run", "break 1: 9" },
        { "print $step", "1" },
        { "c", "break 2: 11\nbreak 3: test.s:4" },
        { "print $step", "3" },
        { "c", "break 3: test.s:4" },
        { "print $step", "5" },
        { "delete", "" },
        { "tbreak insn DIVS", "break 4" },
        { "tbreak here", "break 5" },
        { "run", "break 4: insn DIVS\nbreak 5: here" },
        { "info breaks", "there are none" },
        { "tbreak *here", "break 6" },
        { "goto 0", "" },
        { "c 2", "ended" },
        { "info breaks", "there are none" },
    };
    struct plain plain = { .object = good("        .data\n"
                                          "datum:  .word 1.0\n"
                                          "        .macro twice r\n"
                                          "        ADDX \\r, r9, \\r\n"
                                          "        ADDX \\r, r9, \\r\n"
                                          "        .endm\n"
                                          "        .code\n"
                                          "        ES   r9, 1\n"
                                          "        ES   r10, 5\n"
                                          "        ES   r11, 5\n"
                                          "        twice r10\n"
                                          "        twice r11\n"
                                          "here:   DIVS r10, r11, r12\n"
                                          "        EXIT\n") };
    struct session session;

    (void)state;
    begin(&session, &plain, "test.s");
    check_lines(&session, lines, sizeof lines / sizeof *lines);
    assert_int_equal(debugger_faults(session.debugger), 0);
    end(&session);
    free_plain(&plain);
}

/* An endless program ends no script. */
static void test_endless(void **state)
{
    struct plain plain = { .object = good(
                               "        .include \"vectors.s\"\n"
                               "        .data\n"
                               "v:      .space 65000\n"
                               "        .code\n"
                               "        descriptor r10, v, 65000\n"
                               "loop:   DIVSV [r10], [r10], [r10]\n"
                               "        BIM loop\n") };
    struct session session;

    (void)state;
    begin(&session, &plain, "test.s");
    obey(&session, "c");
    assert_true(has(&session, "1000000000 clocks have passed"));
    end(&session);
    free_plain(&plain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_movements),
        cmocka_unit_test(test_far_back),
        cmocka_unit_test(test_values),
        cmocka_unit_test(test_faults),
        cmocka_unit_test(test_printed),
        cmocka_unit_test(test_calls_and_links),
        cmocka_unit_test(test_end),
        cmocka_unit_test(test_printed_again),
        cmocka_unit_test(test_lines_and_several),
        cmocka_unit_test(test_endless),
    };

    return cmocka_run_group_tests(tests, set_up_model, tear_down_model);
}
