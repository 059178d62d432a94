/* test_shown_line.c - random programs with nested macros in several files, with
 * operations in both forms, formulas and repetitions. The test computes the line and
 * the form of each instruction from the definition of the rule, and compares those of
 * the assembler, the profile, the timeline and the debugger with them. */
#include "asm/debug/execution_control.h"
#include "asm/measure/line_profile.h"
#include "asm/timeline/timeline.h"
#include "tests/unit/debugger_session.h"
#include "tests/unit/draw.h"
#include "vm/text.h"

enum {
    PROGRAMS = 300,
    MACROS = 12,
    ITEMS = 4,               /* of a macro */
    MAX_EXPANSION_SIZE = 60, /* instructions of a macro */
    MAX_INSNS = 1000,
    MAX_DEPTH = MACROS + 2,
    FILE_TEXT = 16384
};

/* ---- Random programs -------------------------------------------------------- */

/* The files of a program. Macros of the last two are operations, and also those of the
 * first in every second program. */
enum { MAIN, PART, OTHER, SCALAR_OPERATIONS, VECTOR_OPERATIONS, FILES };
static const char *names[FILES] = { NULL, "part.s", "kernels/other.s",
                                    "kernels/lanes_scalar.s", "forms_vector.s" };

enum item_kind {
    INSTRUCTION,
    CALL,      /* of a macro of the program */
    OPERATION, /* of forms.s */
    SERIES,    /* call of a macro of series.s, which calls operations */
    LIBRARY,   /* call of a macro of core.s */
    KINDS
};

struct item {
    enum item_kind kind;
    size_t called; /* macro; or the form of the operations, 1: vector */
    size_t times;  /* number of repetitions */
    size_t line;
    char text[60]; /* source line */
};

struct random_macro {
    size_t file, count, size;
    struct item items[ITEMS];
};

static struct {
    char text[FILES][FILE_TEXT];
    size_t line[FILES]; /* lines so far */
    struct random_macro macros[MACROS];
    struct item top[3 * ITEMS];
    size_t top_count;
} program;

static void add(size_t file, const char *line)
{
    char *text = program.text[file];
    assert_true(strlen(text) + strlen(line) + 2 < FILE_TEXT);
    strcat(strcat(text, line), "\n");
    program.line[file]++;
}

/* Returns the number of instructions of one repetition. */
static size_t size_of(const struct item *item)
{
    switch (item->kind) {
    case CALL: return program.macros[item->called].size;
    case SERIES: return item->called ? 6 * 3 : 6 * 2;
    case LIBRARY: return 2;
    default: return 1;
    }
}

/* Makes an item of a macro, or of the program's text, that calls one of the first
 * `callable` macros. */
static struct item draw_item(size_t callable, const char *operand)
{
    static const char *const operations[] = { "number_plus r20, r21, r22",
                                              "vector_plus r30, r31, r32" };
    static const char *const series[] = { "sine_polynomial number_, r20, r21",
                                          "sine_polynomial vector_, r30, r31" };
    struct item item = { .kind = (enum item_kind)below(KINDS),
                         .times = below(4) ? 1 : 2 };
    if (item.kind == CALL && callable == 0)
        item.kind = INSTRUCTION;
    item.called = item.kind == CALL ? below(callable) : below(2);
    if (item.kind == CALL)
        snprintf(item.text, sizeof item.text, "  m%zu %s", item.called, operand);
    else if (item.kind == OPERATION)
        snprintf(item.text, sizeof item.text, "  %s", operations[item.called]);
    else if (item.kind == SERIES)
        snprintf(item.text, sizeof item.text, "  %s", series[item.called]);
    else if (item.kind == LIBRARY)
        snprintf(item.text, sizeof item.text, "  descriptor %s, 0, 0", operand);
    else
        snprintf(item.text, sizeof item.text, "  ADDX r24, %s, r25", operand);
    return item;
}

static void add_item(size_t file, struct item *item)
{
    if (item->times > 1)
        add(file, "  .rept 2");
    add(file, item->text);
    item->line = program.line[file];
    if (item->times > 1)
        add(file, "  .endr");
}

static void draw_macro(size_t number)
{
    struct random_macro *macro = &program.macros[number];
    char head[40];
    *macro = (struct random_macro){ .file = below(FILES) };
    snprintf(head, sizeof head, "  .macro m%zu a", number);
    add(macro->file, head);
    for (size_t i = 1 + below(ITEMS); i > 0; i--) {
        struct item item = draw_item(number, "\\a");
        size_t size = item.times * size_of(&item);
        if (macro->size + size > MAX_EXPANSION_SIZE)
            continue;
        add_item(macro->file, &item);
        macro->size += size;
        macro->items[macro->count++] = item;
    }
    add(macro->file, "  .endm");
}

static void draw_texts(void)
{
    memset(&program, 0, sizeof program);
    add(MAIN, "  .include \"core.s\"");
    add(MAIN, "  .include \"forms.s\"");
    add(MAIN, "  .include \"series.s\"");
    add(MAIN, "  .regs r50, sine_0, sine_1, sine_2, sine_3, sine_4, sine_5, sine_6");
    add(MAIN, "  scalar_form number_");
    add(MAIN, "  vector_form vector_, r40");
    for (size_t file = PART; file < FILES; file++) {
        char line[60];
        snprintf(line, sizeof line, "  .include \"%s\"", names[file]);
        add(MAIN, line);
    }
    for (size_t i = 0; i < MACROS; i++)
        draw_macro(i);
    for (size_t i = 1 + below(COUNT(program.top)); i > 0; i--) {
        struct item item = draw_item(MACROS, "r28");
        add_item(MAIN, &item);
        program.top[program.top_count++] = item;
    }
    add(MAIN, "  EXIT");
}

static struct object *assemble(void)
{
    static const char *lines[FILES][2];
    static struct text files[FILES + 1];
    static const struct text *const texts[] = { files, NULL };
    const struct asm_options options = { .texts = texts, .sealed = true };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    for (size_t i = PART; i < FILES; i++) {
        lines[i][0] = program.text[i];
        files[i - PART] = (struct text){ names[i], lines[i] };
    }
    struct object *object = assemble_text(names[MAIN], program.text[MAIN], &options,
                                          &reports);
    FAIL_IF(!object, "%s: %s", program.text[MAIN], reports.items[0].message);
    return object;
}

/* ---- The rule ---------------------------------------------------------------- */

static bool has_operations(const struct item *item)
{
    return item->kind == OPERATION || item->kind == SERIES;
}

static unsigned form_of_file(size_t file)
{
    return strstr(names[file], "_scalar.s")   ? ASM_SCALAR_FORM
           : strstr(names[file], "_vector.s") ? ASM_VECTOR_FORM
                                              : 0;
}

/* Returns the forms of the operations that a macro calls, itself or through macros of
 * its file or of the library. A macro of a file for one form has none. */
static unsigned forms_of(size_t number)
{
    const struct random_macro *macro = &program.macros[number];
    unsigned forms = 0;
    for (size_t i = 0; !form_of_file(macro->file) && i < macro->count; i++) {
        const struct item *item = &macro->items[i];
        size_t file = item->kind == CALL ? program.macros[item->called].file : 0;
        if (has_operations(item))
            forms |= item->called ? ASM_VECTOR_FORM : ASM_SCALAR_FORM;
        else if (item->kind == CALL && file == macro->file)
            forms |= forms_of(item->called);
        else if (item->kind == CALL)
            forms |= form_of_file(file);
    }
    return forms;
}

/* A line of the expansion: the outermost first. */
struct place {
    const struct item *item;
    size_t macro; /* macro that contains it; MACROS: none */
    size_t expansion;
};

struct expected_insn {
    size_t file, line, expansion;     /* where it is shown */
    size_t inner_file, inner_line;    /* innermost line; FILES: a file of the library */
    size_t call_line, call_expansion; /* outermost line */
    const char *source;
    unsigned forms;
    bool is_step; /* false for the instructions of a LINKV, which executes them */
};

static struct {
    struct expected_insn insns[MAX_INSNS];
    size_t count, expansions;
    struct place stack[MAX_DEPTH];
    size_t depth;
} expected;

static size_t file_of(const struct place *place)
{
    return place->macro == MACROS ? MAIN : program.macros[place->macro].file;
}

static void expect_insn(bool is_step)
{
    struct expected_insn *insn = &expected.insns[expected.count++];
    const struct item *innermost = expected.stack[expected.depth - 1].item;
    size_t at = expected.depth - 1, shown;
    assert_true(expected.count < MAX_INSNS);
    while (file_of(&expected.stack[at]) != MAIN && !forms_of(expected.stack[at].macro))
        at--;
    shown = at;
    *insn = (struct expected_insn){ .file = file_of(&expected.stack[at]),
                                    .line = expected.stack[at].item->line,
                                    .expansion = expected.stack[at].expansion,
                                    .inner_file = FILES,
                                    .call_line = expected.stack[0].item->line,
                                    .call_expansion = expected.stack[0].expansion,
                                    .source = expected.stack[at].item->text,
                                    .is_step = is_step };
    if (innermost->kind == INSTRUCTION) {
        insn->inner_file = file_of(&expected.stack[expected.depth - 1]);
        insn->inner_line = innermost->line;
    }
    if (has_operations(innermost))
        insn->forms = innermost->called ? ASM_VECTOR_FORM : ASM_SCALAR_FORM;
    for (at = expected.depth - 1; !insn->forms && at > shown; at--) {
        size_t file = file_of(&expected.stack[at]);
        if (file_of(&expected.stack[at - 1]) != file)
            insn->forms = form_of_file(file);
    }
    if (!insn->forms && shown > 0)
        insn->forms = forms_of(expected.stack[shown].macro);
}

static void expand(const struct item *items, size_t count, size_t macro)
{
    assert_true(expected.depth < MAX_DEPTH);
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < items[i].times; k++) {
            expected.stack[expected.depth++] = (struct place){ &items[i], macro,
                                                               expected.expansions++ };
            if (items[i].kind == CALL) {
                const struct random_macro *called = &program.macros[items[i].called];
                expand(called->items, called->count, items[i].called);
            } else {
                for (size_t n = size_of(&items[i]); n > 0; n--)
                    expect_insn(items[i].kind != SERIES || !items[i].called
                                || n % 3 == 0);
            }
            expected.depth--;
        }
}

/* ---- Comparisons --------------------------------------------------------------- */

static bool is_row_of(const struct profile_row *row, const struct asm_line *line)
{
    return row->file && row->number == line->shown.number && row->form == line->form
           && strcmp(row->file, line->shown.file) == 0;
}

/* Compares the lines of an object with the expected ones. The last line is EXIT. */
static void check_lines(const struct object *object)
{
    assert_int_equal(object->line_count, expected.count + 1);
    for (size_t i = 0; i < expected.count; i++) {
        const struct expected_insn *insn = &expected.insns[i];
        const struct asm_line *line = &object->lines[i];
        FAIL_IF(!asm_place_is(&line->shown, names[insn->file], insn->line)
                    || line->form != (insn->forms == 3 ? 0 : insn->forms),
                "%zu: %s:%zu %s, not %s:%zu %u\n%s\n%s", i, line->shown.file,
                line->shown.number, asm_form_name(line->form), names[insn->file],
                insn->line, insn->forms, program.text[MAIN], program.text[insn->file]);
        assert_string_equal(line->shown.source, insn->source);
        assert_int_equal(line->shown.begins,
                         i == 0 || insn->expansion != insn[-1].expansion);
    }
}

/* Each line has one row, with the executions of its instructions. */
static void check_profile(const struct object *object,
                          const struct line_profile *profile)
{
    for (size_t i = 0; i < expected.count; i++) {
        uint64_t executions = 0;
        size_t rows = 0;
        for (size_t k = 0; k < expected.count; k++)
            executions += expected.insns[k].is_step
                          && asm_place_is(&object->lines[k].shown,
                                          object->lines[i].shown.file,
                                          object->lines[i].shown.number)
                          && object->lines[k].form == object->lines[i].form;
        for (size_t k = 0; k < line_profile_count(profile); k++) {
            const struct profile_row *row = line_profile_row(profile, k);
            if (!is_row_of(row, &object->lines[i]))
                continue;
            rows++;
            assert_int_equal(row->executions, executions);
        }
        assert_int_equal(rows, 1);
    }
}

/* Writes the start of the text for a line, as in "part.s:7 (scalar): ". */
static void put_shown(const struct asm_line *line, char text[80])
{
    const char *slash = strrchr(line->shown.file, '/');
    snprintf(text, 80, line->form ? "%s:%zu (%s): " : "%s:%zu: ",
             slash ? slash + 1 : line->shown.file, line->shown.number,
             asm_form_name(line->form));
}

static void check_timeline(const struct object *object, const struct timeline *timeline)
{
    const struct timed_insn *insn = timeline->insns;
    for (size_t i = 0; i < expected.count; i++) {
        const struct asm_line *line = &object->lines[i];
        const char *said = insn->line;
        char text[80] = "";
        if (!expected.insns[i].is_step)
            continue;
        assert_int_equal(insn++->pc, line->address);
        if (asm_place_is(&line->call, line->file, line->number))
            assert_string_equal(said, "");
        else {
            put_shown(line, text);
            assert_memory_equal(said, text, strlen(text));
        }
    }
}

/* Frees the object. */
static void check_debugger(struct object *object)
{
    FREED_BY(session_end) struct debug_session session;
    session_begin(&session, object, names[MAIN]);
    for (int i = 0; i < 20; i++) {
        const struct asm_line *line = &object->lines[below(object->line_count)];
        char text[80], command[80], listed[120];
        put_shown(line, text);
        snprintf(command, sizeof command, "disassemble *0x%llX, 1",
                 (unsigned long long)line->address);
        session_obey(&session, command);
        const char *said = strstr(session.said.text, "  ; ");
        assert_non_null(said);
        assert_memory_equal(said + 4, text, strlen(text));
        snprintf(command, sizeof command, "list *0x%llX, 1",
                 (unsigned long long)line->address);
        snprintf(listed, sizeof listed, "%s:%zu%s%s\t%s\n", line->shown.file,
                 line->shown.number, line->form ? " " : "", asm_form_name(line->form),
                 line->shown.source);
        session_obey(&session, command);
        FAIL_IF(!session_says(&session, listed), "%s: %s", listed, session.said.text);
    }
}

/* Returns true if a breakpoint at a line stops at an instruction: at each of the line
 * itself, and at the first of an expansion that the line calls or shows. */
static bool is_stop(size_t i, size_t file, size_t line)
{
    const struct expected_insn *insn = &expected.insns[i],
                               *before = i > 0 ? insn - 1 : NULL;
    if (!insn->is_step)
        return false;
    if (insn->inner_file == file && insn->inner_line == line)
        return true;
    if (file == MAIN && insn->call_line == line)
        return !before || before->call_expansion != insn->call_expansion;
    return insn->file == file && insn->line == line
           && (!before || before->expansion != insn->expansion);
}

/* Counts the stops of a run with a breakpoint at a line. The first instruction is
 * executed before it can stop. */
static void check_stops(struct object *object)
{
    FREED_BY(session_end) struct debug_session session;
    const struct expected_insn *at = &expected.insns[below(expected.count)];
    size_t file = below(2) ? at->file : MAIN, stops = 0;
    size_t line = file == at->file ? at->line : at->call_line;
    char command[80];
    session_begin(&session, object, names[MAIN]);
    for (size_t i = 1; i < expected.count; i++)
        stops += is_stop(i, file, line);
    snprintf(command, sizeof command, "break %s:%zu", names[file], line);
    session_obey(&session, command);
    while (!session.debugger->halted) {
        session_obey(&session, "continue");
        if (session_says(&session, "break 1: "))
            FAIL_IF(stops-- == 0, "%s: %s", command, session.said.text);
    }
    FAIL_IF(stops > 0, "%s: %zu stops are missing", command, stops);
}

/* Steps over lines to the end, and back to the beginning. */
static void check_steps(struct object *object)
{
    FREED_BY(session_end) struct debug_session session;
    size_t lines = 1, steps = 0;
    session_begin(&session, object, names[MAIN]);
    for (size_t i = 1; i < expected.count; i++)
        lines += expected.insns[i].expansion != expected.insns[i - 1].expansion;
    for (; execution_line(session.debugger) == EXECUTION_COMPLETE; steps++)
        continue;
    assert_true(session.debugger->halted);
    assert_int_equal(steps, lines);
    /* One step back goes to EXIT. */
    for (steps = 0; step_of(session.debugger) > 0; steps++)
        assert_int_equal(execution_back_line(session.debugger), EXECUTION_COMPLETE);
    assert_int_equal(steps, lines + 1);
}

TEST(drawn)
{
    for (int i = 0; i < PROGRAMS; i++) {
        c205_stop stop;
        names[MAIN] = i % 2 ? "program.s" : "program_vector.s";
        draw_texts();
        memset(&expected, 0, sizeof expected);
        expand(program.top, program.top_count, MACROS);
        struct object *object = assemble();
        SCOPED(line_profile) *profile = line_profile_new(object);
        SCOPED_VALUE(timeline) timeline = { .object = object, .to = UINT64_MAX };
        SCOPED(c205) *machine = c205_new(prior_model, &failure);
        REQUIRE(machine && c205_load(machine, &object->program, &failure));
        assert_true(c205_listen(machine, line_profile_listen, profile)
                    && c205_listen(machine, timeline_listen, &timeline));
        stop = c205_run(machine, C205_NO_LIMIT);
        assert_int_equal(stop.trap, C205_TRAP_NONE);
        check_lines(object);
        check_profile(object, profile);
        check_timeline(object, &timeline);
        check_debugger(object);
        check_stops(assemble());
        check_steps(assemble());
    }
}
