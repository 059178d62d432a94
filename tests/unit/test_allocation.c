/* test_allocation.c - tasks whose allocations fail are compared with the same tasks
 * with enough memory. Each allocation fails in turn, alone or with all that follow. A
 * crash, a leak, or a result that is neither the same output nor an error fails here.
 *
 * The program is linked with --wrap, so that allocations of the libraries are counted
 * too.
 */
#include "vm/error.h"
#include "tests/unit/asm_helper.h"

#include <errno.h>
#include <unistd.h>

#include "asm/check/expect.h"
#include "asm/lesson/lesson.h"
#include "asm/measure/measure.h"
#include "asm/object/disassemble.h"
#include "asm/object/object_file.h"
#include "asm/view/listing.h"
#include "asm/view/print.h"
#include "asm/view/state.h"
#include "base/accounts.h"
#include "rt/study/speedup_report.h"
#include "rt/study/sweep/sweep_types.h"
#include "web/engine/engine.h"

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
void __real_free(void *old);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
void __wrap_free(void *old);

SCOPED_BY_FREE(speedup_report);

/* ---- The host ------------------------------------------------------------ */

static struct {
    size_t calls;  /* allocations since the start of the task */
    size_t fails;  /* number of the allocation that fails; 0: none */
    bool for_good; /* all later allocations fail, too */
    long living;   /* number of allocations that have not been freed */
} host;

static bool refuses(void)
{
    host.calls++;
    bool refused = host.fails
                   && (host.calls == host.fails
                       || (host.for_good && host.calls > host.fails));
    if (refused)
        errno = ENOMEM;
    return refused;
}

static void *given(void *memory)
{
    host.living += memory != NULL;
    return memory;
}

void *__wrap_malloc(size_t size)
{
    return refuses() ? NULL : given(__real_malloc(size));
}

void *__wrap_calloc(size_t count, size_t size)
{
    return refuses() ? NULL : given(__real_calloc(count, size));
}

void *__wrap_realloc(void *old, size_t size)
{
    if (refuses())
        return NULL;
    void *memory = __real_realloc(old, size);
    host.living += !old && memory;
    return memory;
}

void __wrap_free(void *old)
{
    host.living -= old != NULL;
    __real_free(old);
}

/* ---- A task under a host that fails -------------------------------------- */

/* Writes all of its output and returns true, or sets a message and returns false. */
typedef bool task(FILE *out, c205_error *error);

struct outcome {
    bool done;
    c205_error error;
    char *output; /* allocated by libc, which is not counted */
    size_t length;
};

static struct outcome attempt(task *work, size_t fails, bool for_good)
{
    struct outcome outcome = { false, { "" }, NULL, 0 };
    FILE *out = NON_NULL(open_memstream(&outcome.output, &outcome.length));
    long before = host.living;
    host.calls = 0;
    host.fails = fails;
    host.for_good = for_good;
    outcome.done = work(out, &outcome.error);
    host.fails = 0;
    fclose(out);
    FAIL_IF(host.living != before, "allocation %zu failed, %ld are lost", fails,
            host.living - before);
    return outcome;
}

/* Runs a task once for each of its allocations, which fails. If `once` is set, all
 * later allocations fail, too. Otherwise both cases are run. */
static void exhaust(task *work, bool once)
{
    struct outcome wanted = attempt(work, 0, false);
    size_t calls = host.calls;
    FAIL_IF(!wanted.done, "%s", wanted.error.message);
    assert_true(calls > 0);
    for (size_t fails = 1; fails <= calls; fails++)
        for (int for_good = once; for_good < 2; for_good++) {
            struct outcome outcome = attempt(work, fails, for_good);
            FAIL_IF(!outcome.done && !outcome.error.message[0],
                    "allocation %zu failed without a message", fails);
            FAIL_IF(outcome.done
                        && (outcome.length != wanted.length
                            || memcmp(outcome.output, wanted.output, wanted.length)),
                    "allocation %zu failed, and the output is wrong", fails);
            __real_free(outcome.output);
        }
    __real_free(wanted.output);
}

/* ---- Tasks --------------------------------------------------------------- */

static const c205_model *model;
static const struct object *object;

static bool no_memory(c205_error *error)
{
    return error_set(error, "out of memory");
}

static bool find_models(FILE *out, c205_error *error)
{
    static const char text[] = "title Slow\nlike cyber205-2pipe-prior\n"
                               "latency.load 99 clk R\n";
    SCOPED(c205_model) *parsed = c205_model_parse("slow", text, error);
    SCOPED(c205_model) *read = parsed
                                   ? c205_model_find("vm/models/cyber205-2pipe.model",
                                                     error)
                                   : NULL;
    if (read)
        fprintf(out, "%s, %s\n", c205_model_title(parsed), c205_model_title(read));
    return read;
}

static const char program_text[] =
    "        .include \"print.s\"\n"
    "        .equ    size, 3\n"
    "        .macro  twice register\n"
    "        ADDN    \\register, \\register, \\register\n"
    "        .endm\n"
    "        .data\n"
    "a:      .word   1.5, 2.0, X'FFD2 4000 0000 0000'\n"
    "b:      .space  size\n"
    "text:   .text   \"sum \"\n"
    "        .code\n"
    "        .reg    sum, r12\n"
    "        .kernel add\n"
    "        EX      r10, a\n"
    "        ELEN    r10, size\n"
    "        EX      r11, b\n"
    "        ELEN    r11, size\n"
    "        ADDNV   [r10], [r10], [r11]\n"
    "        VREVV   [r11], [r11]\n"
    "        .endkernel\n"
    "        SUMV    [r11], sum\n"
    "        twice   sum\n"
    "        print_number sum\n"
    "        EXIT\n"
    "; expect: [b] = 2.0, 4.0, 2.0\n"
    "; expect-print: 16\n";

/* Copies the message of the first error in a list. Without an entry, the error could
 * not be allocated. */
static void print_first(const struct diagnostics *errors, c205_error *error)
{
    error_set(error, "%.200s",
              errors->count ? errors->items[0].message : "out of memory");
}

static struct object *assembled(const char *text, c205_error *error)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    struct object *made = assemble_text("test.s", text, NULL, &errors);
    assert_int_equal(made == NULL, errors.errors > 0);
    if (!made)
        print_first(&errors, error);
    return made;
}

static bool assemble_one(FILE *out, c205_error *error)
{
    struct sink sink = stream_sink(out);
    SCOPED(object) *made = assembled(program_text, error);
    if (!made)
        return false;
    object_write(made, &sink);
    listing(made, &sink);
    return true;
}

/* A label with this length shifts the following allocations in its block of memory, so
 * that a different allocation needs the next block. */
enum { MAX_LABEL = 65000, LABEL_STEP = 47 };
static const char more_text[] =
    "        .regs   r40, one, two, three\n"
    "        .macro  fill value, count=2\n"
    "        .rept   \\count\n"
    "        .word   \\value + \\+\n"
    "        .endr\n"
    "        .endm\n"
    "        .data\n"
    "        fill    5\n"
    "        fill    -a + 7 * (size << 2), 3\n"
    "        .vector list, 4, 1.0, -2.5\n"
    "        .bitvector bits, 70, \"1 01\"\n"
    "        .descriptor 4, list\n"
    "        .half   1, 2\n"
    "        .if     size == 3\n"
    "        .ifdef  nothing\n"
    "        .error  \"wrong\"\n"
    "        .else\n"
    "        .equ    late, 5\n"
    "        .endif\n"
    "        .endif\n"
    "        .org    0x20000000\n"
    "        .code\n"
    "        .entry  begin\n"
    "begin:  IBXLT   one, two, three, begin, one\n"
    "        CFPGE   one, two, [three]\n"
    "        ADDNV   -|[one, two]|, three, [r60, r61] ? [r70]\n"
    "        .kernel \"a b\"\n"
    "        BIM     begin\n"
    "        .endkernel\n"
    "; expect: r10 = -late\n"
    "; expect: [list + 64] = 1.0, X'FFD2 4000 0000 0000'\n"
    "; expect-bits: [bits] = 101\n"
    "; expect-flags: 0\n"
    "; expect-clocks: 5\n"
    "; expect-trap: bad-link\n";
static char long_text[MAX_LABEL + sizeof program_text + sizeof more_text];

static bool assemble_long(FILE *out, c205_error *error)
{
    SCOPED(object) *made = assembled(long_text, error);
    if (!made)
        return false;
    fprintf(out, "%zu symbols\n", made->symbol_count);
    return true;
}

/* A text with errors is rejected, whether or not memory is exhausted. */
static bool assemble_wrong(FILE *out, c205_error *error)
{
    struct object *made = assembled("        NOPE\n        ADDN r1, nowhere, r3\n"
                                    "        .if 1\n        .include \"missing.s\"\n",
                                    error);
    fputs("refused", out);
    assert_null(made);
    return true;
}

static bool read_object(FILE *out, c205_error *error)
{
    SCOPED_VALUE(text_buffer) buffer = { NULL, 0, 0, false };
    struct sink text = text_buffer_sink(&buffer), sink = stream_sink(out);
    object_write(object, &text);
    SCOPED(object) *copy = buffer.failed
                               ? (no_memory(error), NULL)
                               : object_read(buffer.text, buffer.length, error);
    if (copy)
        object_write(copy, &sink);
    return copy;
}

static bool disassemble_object(FILE *out, c205_error *error)
{
    struct sink sink = stream_sink(out);
    return disassemble(object, &sink) || no_memory(error);
}

static bool show(struct table *table, FILE *out, c205_error *error)
{
    bool done = table && table_print(table, out);
    table_free(table);
    return done || no_memory(error);
}

static bool run_to(c205 *machine, uint64_t limit, c205_error *error)
{
    c205_stop stop = c205_run(machine, limit);
    if (stop.trap == C205_TRAP_NONE || stop.trap == C205_TRAP_CLOCK_LIMIT)
        return true;
    c205_describe_stop(machine, &stop, error);
    return false;
}

static bool run_and_show(c205 *machine, FILE *out, c205_error *error)
{
    struct printer printer = { stream_sink(out) };
    c205_listen(machine, printer_listen, &printer);
    SCOPED_VALUE(accounts) accounts = { .model = model };
    return run_to(machine, C205_NO_LIMIT, error)
           && (accounts_add(&accounts, machine) || no_memory(error))
           && show(accounts_by_cause(&accounts), out, error)
           && show(accounts_by_region(&accounts), out, error);
}

static c205 *loaded(const struct object *program, c205_error *error)
{
    c205 *machine = c205_new(model, error);
    if (machine && !c205_load(machine, &program->program, error)) {
        c205_free(machine);
        return NULL;
    }
    return machine;
}

static bool run_object(FILE *out, c205_error *error)
{
    SCOPED(c205) *machine = loaded(object, error);
    return machine && run_and_show(machine, out, error);
}

/* Runs a program of gathers and scatters, for which the machine allocates memory while
 * it runs. */
static bool run_example(FILE *out, c205_error *error)
{
    SCOPED_VALUE(diagnostics) errors = { 0 };
    SCOPED(object) *made = assemble_file("asm/examples/lookup.s", NULL, &errors);
    if (!made)
        print_first(&errors, error);
    SCOPED(c205) *machine = made ? loaded(made, error) : NULL;
    return machine && run_and_show(machine, out, error);
}

static bool save_and_restore(FILE *out, c205_error *error)
{
    char path[] = "/tmp/c205_state_XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    SCOPED(c205) *machine = loaded(object, error);
    bool saved = machine && run_to(machine, 1100, error)
                 && state_save(machine, path, error);
    SCOPED(c205) *other = saved ? state_load(path, model, error) : NULL;
    unlink(path);
    return other && run_and_show(other, out, error);
}

static bool measure_one(FILE *out, c205_error *error)
{
    struct measurement measurement;
    if (!measure(model, "ADDNV", &measurement, error))
        return false;
    fprintf(out, "%.17g %.17g\n", measurement.startup, measurement.per_element);
    return true;
}

static bool check_object(FILE *out, c205_error *error)
{
    SCOPED_VALUE(text_buffer) printed = { NULL, 0, 0, false };
    struct printer printer = { text_buffer_sink(&printed) };
    struct sink report = stream_sink(out);
    SCOPED(c205) *machine = loaded(object, error);
    if (!machine)
        return no_memory(error);
    c205_listen(machine, printer_listen, &printer);
    c205_stop stop = c205_run(machine, C205_NO_LIMIT);
    if (stop.trap == C205_TRAP_NO_MEMORY || printed.failed)
        return no_memory(error);
    assert_true(
        expect_check(object, machine, &stop, printed.text, object->warned, &report));
    return true;
}

/* A correct answer can only fail because memory was exhausted before it was graded. */
static bool grade_answer(FILE *out, c205_error *error)
{
    static const char test[] = "; test: one\n; goals: gold 1, silver 2, "
                               "bronze 90000\n        .equ    n, 1\n"
                               "x:      .word   2.0\nwant_y: .word 2.0\n";
    static const char fresh[] = "; test: fresh\n"
                                "        .ifdef  test_n\n        .equ    n, test_n\n"
                                "        .endif\n"
                                "x:      .word   draw * 2.0\nwant_y: .space 1\n";
    static const char answer[] = "        .data\nx:      .word   1.0\n"
                                 "y:      .word   0.0\n        .code\n"
                                 "        EX      r10, x\n"
                                 "        LOD     [r10], r11\n"
                                 "        EX      r10, y\n"
                                 "        STO     [r10], r11\n"
                                 "        EXIT\n";
    struct sink sink = stream_sink(out);
    SCOPED_VALUE(lesson) lesson = { 0 };
    SCOPED_VALUE(lesson_verdict) verdict = { 0 };
    bool done = lesson_begin(&lesson, "1-it", error)
                && lesson_take(&lesson, "lesson.md", "# A\n", 4, error)
                && lesson_take(&lesson, "start.s", "", 0, error)
                && lesson_take(&lesson, "test-a.s", test, strlen(test), error)
                && lesson_take(&lesson, "fresh.s", fresh, strlen(fresh), error)
                && lesson_take(&lesson, "solution.s", answer, strlen(answer), error)
                && lesson_end(&lesson, error)
                && lesson_grade(&verdict, &lesson,
                                (struct lesson_draws){ thorough(), 1 }, "my.s", answer,
                                strlen(answer), error);
    if (done && verdict.passed)
        lesson_verdict_put(&verdict, &sink);
    return done && (verdict.passed || no_memory(error));
}

/* Returns true only if the reply is complete. If memory is exhausted, printed text is
 * truncated, or breakpoints are missing. */
static bool reply_to(struct engine *engine, const char *request, FILE *out,
                     c205_error *error)
{
    FREED char *reply = engine_answer(engine, request, strlen(request));
    bool good = reply && strncmp(reply, "{\"ok\": true", 11) == 0
                && !strstr(reply, "\"printed_cut\": true")
                && !strstr(reply, "out of memory");
    if (good)
        fprintf(out, "%s\n", reply);
    return good || no_memory(error);
}

static bool answer_requests(FILE *out, c205_error *error)
{
    static const char *const requests[] = {
        "{\"do\": \"load\", \"text\": \" .data\\nx: .word 1.0, 2.0\\n "
        ".code\\n EX r10, x\\n ELEN r10, 2 * n\\n ADDNV [r10], [r10], "
        "[r10]\\n EXIT r10, r0, 6\\n EXIT\\n\", \"defines\": {\"n\": 1}, "
        "\"files\": {\"a\": \"\"}}",
        "{\"do\": \"breaks\", \"lines\": [6, 90]}",
        "{\"do\": \"go\", \"how\": \"continue\"}",
        "{\"do\": \"go\", \"how\": \"end\"}",
        "{\"do\": \"view\"}",
        "{\"do\": \"say\", \"line\": \"why\"}",
        "{\"do\": \"profile\"}",
        "{\"do\": \"timeline\"}",
        "{\"do\": \"timeline\", \"file\": \"x.json\"}",
        "{\"do\": \"accounts\"}",
        "{\"do\": \"sweep\", \"constant\": \"n\", \"from\": 1, \"to\": 2, "
        "\"text\": \" ES r10, n\\n EXIT\\n\", \"other\": \" EXIT\\n\"}",
        "{\"do\": \"compare\", \"texts\": [{\"text\": \" EXIT\\n\"}, "
        "{\"text\": \" EXIT\\n\"}]}",
    };
    SCOPED(engine) *engine = engine_new();
    bool done = engine || no_memory(error);
    for (size_t i = 0; done && i < COUNT(requests); i++)
        done = reply_to(engine, requests[i], out, error);
    return done;
}

static bool write_json(FILE *out UNUSED, c205_error *error)
{
    struct json *json = json_open("/dev/null", error);
    if (!json)
        return false;
    json_text(json, "model", c205_model_name(model));
    return json_close(json, error);
}

static bool report_speedups(FILE *out, c205_error *error)
{
    static const struct speedup_view view = { .distance = 5, .angle = 37 };
    static const struct speedup_measure measures[TRACE_FORMS] = {
        { .total = 9, .rays = 1 }, { .total = 3, .rays = 1 }
    };
    SCOPED(speedup_report) *report = speedup_report_new(model);
    struct json *json = report ? json_open_stream(out, NULL, error) : NULL;
    for (size_t i = 0; report && i < speedup_subject_count; i++)
        speedup_report_add(report, &speedup_subjects[i], &view, measures);
    if (json && speedup_report_json(report, json))
        return json_close(json, error) || no_memory(error);
    if (json)
        json_discard(json);
    return no_memory(error);
}

static bool report_pipes(FILE *out, c205_error *error)
{
    struct sweep_measure measures[6];
    struct sweep sweep = { .measures = measures, .count = 6 };
    SCOPED_VALUE(sweep_report) report = { .part_count = 0 };
    for (size_t i = 0; i < 6; i++)
        measures[i] = (struct sweep_measure){
            .rays = 1, .forms = { { .total = 9 }, { .total = 3 } }
        };
    return (sweep_pipes.report(&sweep, &report, error)
            && sweep_report_write(&report, TABLE_MARKDOWN, out))
           || no_memory(error);
}

/* ---- The tests ----------------------------------------------------------- */

TEST_CALL(find_models, exhaust(find_models, false))
TEST_CALL(assemble_one, exhaust(assemble_one, false))
TEST_CALL(assemble_wrong, exhaust(assemble_wrong, false))
TEST_CALL(read_object, exhaust(read_object, false))
TEST_CALL(disassemble_object, exhaust(disassemble_object, false))
TEST_CALL(run_object, exhaust(run_object, false))
TEST_CALL(run_example, exhaust(run_example, false))
TEST_CALL(save_and_restore, exhaust(save_and_restore, false))
TEST_CALL(check_object, exhaust(check_object, false))
TEST_CALL(measure_one, exhaust(measure_one, false))
TEST_CALL(grade_answer, exhaust(grade_answer, false))
TEST_CALL(answer_requests, exhaust(answer_requests, false))
TEST_CALL(write_json, exhaust(write_json, false))
TEST_CALL(report_speedups, exhaust(report_speedups, false))
TEST_CALL(report_pipes, exhaust(report_pipes, false))

/* A page is allocated on its first access. If the allocation fails, a trap reports the
 * reason. When memory is available, the page is mapped. */
TEST(untouched_page)
{
    static const char text[] = "        .entry first\n"
                               "first:  EX r4, 0x50000000\n"
                               "        STO [r4], r4\n"
                               "        EXIT\n";
    c205_error error = { "" };
    SCOPED(object) *program = assembled(text, &error);
    size_t lacked = 0;
    for (size_t fails = 1;; fails++) {
        SCOPED(c205) *machine = NON_NULL(loaded(program, &error));
        c205_word word;
        assert_true(c205_map(machine, 0x50000000, 1, C205_WHEN_TOUCHED, &error));
        host.calls = 0;
        host.fails = fails;
        c205_stop stop = c205_run(machine, UINT64_MAX);
        bool failed = host.calls >= fails;
        host.fails = 0;
        c205_describe_stop(machine, &stop, &error);
        if (stop.trap == C205_TRAP_UNMAPPED_ADDRESS)
            assert_non_null(strstr(error.message, "out of memory"));
        else
            assert_int_equal(stop.trap, C205_TRAP_NONE);
        assert_true(c205_read(machine, 0x50000000, &word, 1));
        assert_int_equal(word, stop.trap == C205_TRAP_NONE ? 0x50000000 : 0);
        if (!failed)
            break;
        lacked += stop.trap != C205_TRAP_NONE;
    }
    assert_true(lacked > 0);
}

/* Runs a loop whose history cannot grow after step 16. Returns its allocation attempts. */
static size_t calls_without_memory(const char *loop, size_t steps)
{
    SCOPED(object) *program = NON_NULL(assembled(loop, &failure));
    c205_stop stop;
    SCOPED(c205_history) *history = NON_NULL(
        c205_history_new(loaded(program, &failure), SIZE_MAX, &failure));
    while (c205_history_step(history) < 16)
        assert_true(c205_history_forward(history, &stop));
    host.calls = 0;
    host.fails = 1;
    host.for_good = true;
    while (c205_history_step(history) < steps)
        assert_true(c205_history_forward(history, &stop));
    host.fails = 0;
    return host.calls;
}

/* After a snapshot fails, the next attempt is after twice as many instructions (scalar
 * loops) or clocks (vector loops). Sixteen times as many steps therefore add four
 * attempts of two allocations each. */
TEST(snapshots)
{
    static const char *const loops[] = {
        "        EX      r11, loop\n"
        "loop:   IBXEQ   r0, r0, r0, loop, r12\n",
        "        .data\n"
        "a:      .space  60000\n"
        "        .code\n"
        "        EX      r10, a\n"
        "        ELEN    r10, 60000\n"
        "loop:   ADDNV   [r10], [r10], [r10]\n"
        "        IBXEQ   r0, r0, r0, loop, r12\n",
    };
    for (size_t i = 0; i < COUNT(loops); i++) {
        size_t few = calls_without_memory(loops[i], 10000);
        size_t many = calls_without_memory(loops[i], 160000);
        assert_in_range(few, 2, 16);
        assert_in_range(many, few + 1, few + 10);
    }
}

TEST(any_block)
{
    for (size_t length = 0; length < MAX_LABEL; length += LABEL_STEP) {
        memset(long_text, 'x', length);
        sprintf(long_text + length, "%s%s%s", length ? ":\n" : "", program_text,
                more_text);
        exhaust(assemble_long, true);
    }
}

FIXTURE(prepare)
{
    c205_error error = { "" };
    model = c205_model_find("cyber205-2pipe-prior", &error);
    object = assembled(program_text, &error);
    fputs(error.message, stderr);
    return model && object ? 0 : -1;
}

FIXTURE(tidy)
{
    object_free((struct object *)object);
    c205_model_free((c205_model *)model);
    return 0;
}

GROUP(prepare, tidy);
