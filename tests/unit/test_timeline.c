/* test_timeline.c - the sums of a timeline are compared with the machine's accounts,
 * its spans with each other, and its log for Konata with the rules of the format, over
 * all examples and random programs. A lost clock, or two spans of a row that overlap,
 * fails here. */
#include "asm/timeline/timeline_lanes.h"
#include "tests/random.h"
#include "tests/unit/random_debug_program.h"
#include "tests/unit/kanata_log.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/saved_machine.h"

enum { MAX_INSNS = 3000, TEXT_LENGTH = 300 };

static uint64_t random_state = RANDOM_SEED;

/* ---- Runs ----------------------------------------------------------------- */

/* Runs a program for MAX_INSNS instructions, to an instruction boundary. */
static c205 *run(const struct object *object, struct timeline *timeline)
{
    c205 *machine = machine_with(&object->program, prior_model);
    c205_stop stop;
    assert_true(c205_listen(machine, timeline_listen, timeline));
    for (size_t i = 0; i < MAX_INSNS && c205_step(machine, &stop); i++)
        continue;
    assert_true(timeline_is_good(timeline) && !timeline->full);
    return machine;
}

/* ---- Sums ----------------------------------------------------------------- */

static void check_sums(const struct timeline *timeline, const c205 *machine,
                       const char *path)
{
    uint64_t clocks[C205_CAUSES] = { 0 }, at = 0;
    for (size_t i = 0; i < timeline->piece_count; i++) {
        const struct timed_piece *piece = &timeline->pieces[i];
        assert_int_equal(piece->begin, at);
        clocks[piece->cause] += piece->end - piece->begin;
        at = piece->end;
    }
    assert_int_equal(at, c205_clock(machine));
    for (int cause = 0; cause < C205_CAUSES; cause++)
        FAIL_IF(clocks_of_cause(machine, (c205_cause)cause) != clocks[cause], "%s: %s",
                path, c205_cause_name((c205_cause)cause));
}

static void check_rows(const struct timeline *timeline)
{
    enum { ROWS = 64 };
    static uint64_t ends[LANES][ROWS];
    SCOPED_VALUE(arena) arena = { NULL, false };
    struct lanes lanes = { 0 };
    memset(ends, 0, sizeof ends);
    assert_true(lanes_make(timeline, &arena, &lanes));
    for (size_t i = 0; i < lanes.count; i++) {
        const struct timed_span *span = &lanes.spans[i];
        assert_true(span->row < lanes.rows[span->lane] && span->row < ROWS);
        assert_true(span->begin >= ends[span->lane][span->row]);
        assert_true(span->end > span->begin && span->begin >= timeline->from
                    && span->end <= timeline->to);
        ends[span->lane][span->row] = span->end;
    }
    assert_true(lanes.rows[LANE_CHARGED] <= 1);
}

/* ---- Konata's format ------------------------------------------------------ */

struct reader {
    const struct timeline *timeline;
    uint64_t clock;
    size_t next; /* the next instruction to be declared */
    struct shown {
        bool there, retired;
        char stage[16]; /* current stage; "": no stage */
        uint64_t since, worked;
        unsigned labels;
    } shown[MAX_INSNS + 2];
};

static void take_stage(struct reader *reader, struct shown *shown, char kind,
                       const char *stage)
{
    if (kind == 'S') {
        assert_string_equal(shown->stage, "");
        snprintf(shown->stage, sizeof shown->stage, "%s", stage);
        shown->since = reader->clock;
        return;
    }
    assert_string_equal(shown->stage, stage);
    assert_true(reader->clock > shown->since);
    if (strcmp(stage, "W") != 0)
        shown->worked += reader->clock - shown->since;
    shown->stage[0] = '\0';
}

static void take_command(struct reader *reader, const char *line)
{
    char kind = *line, word[16] = "", rest[TEXT_LENGTH] = "";
    unsigned long id = 0, second = 0;
    assert_true(sscanf(line + 1, "\t%lu", &id) == 1);
    if (kind == 'C') {
        assert_true(id > 0);
        reader->clock += id;
        return;
    }
    assert_true(id < MAX_INSNS + 2);
    struct shown *shown = &reader->shown[id];
    if (kind == 'I') {
        assert_int_equal(sscanf(line, "I\t%lu\t%lu\t0%15s", &id, &second, word), 2);
        assert_int_equal(id, reader->next++);
        assert_int_equal(reader->clock, reader->timeline->insns[id].arrived);
        shown->there = true;
        return;
    }
    assert_true(shown->there && !shown->retired);
    if (kind == 'L') {
        assert_int_equal(sscanf(line, "L\t%lu\t%lu\t%299[^\n]", &id, &second, rest), 3);
        assert_int_equal(second, shown->labels++);
    } else if (kind == 'R') {
        assert_string_equal(shown->stage, "");
        assert_int_equal(shown->labels, 2);
        assert_int_equal(reader->clock, reader->timeline->insns[id].done);
        assert_int_equal(shown->worked, reader->timeline->insns[id].ready
                                            - reader->timeline->insns[id].issued);
        shown->retired = true;
    } else {
        assert_true(kind == 'S' || kind == 'E');
        assert_int_equal(sscanf(line + 1, "\t%lu\t%lu\t%7s", &id, &second, word), 3);
        assert_int_equal(second, 0);
        take_stage(reader, shown, kind, word);
    }
}

static void check_kanata(const struct timeline *timeline)
{
    static struct reader reader;
    SCOPED_VALUE(text_buffer) text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    unsigned long begin;
    size_t number;
    reader = (struct reader){ .timeline = timeline };
    assert_true(timeline_kanata(timeline, &sink));
    const char *fault = kanata_fault(text.text, &number);
    FAIL_IF(fault, "line %zu: %s", number, fault);
    char *line = strtok(text.text, "\n");
    assert_string_equal(line, "Kanata\t0004");
    line = strtok(NULL, "\n");
    assert_int_equal(sscanf(line, "C=\t%lu", &begin), 1);
    reader.clock = begin;
    while ((line = strtok(NULL, "\n")) != NULL)
        take_command(&reader, line);
    for (size_t i = 0; i < reader.next; i++)
        assert_true(reader.shown[i].retired);
    assert_true(reader.next + 1 >= timeline->insn_count);
}

/* ---- Other cases ---------------------------------------------------------- */

/* The texts contain one event and one closed box for each span. Each row of a lane has
 * a thread with the name of the lane. */
static void check_texts(const struct timeline *timeline)
{
    SCOPED_VALUE(arena) arena = { NULL, false };
    struct lanes lanes = { 0 };
    SCOPED_VALUE(text_buffer) svg = { 0 };
    SCOPED_VALUE(text_buffer) events = { 0 };
    struct sink svg_sink = text_buffer_sink(&svg);
    struct sink events_sink = text_buffer_sink(&events);
    assert_true(lanes_make(timeline, &arena, &lanes));
    assert_true(timeline_svg(timeline, "a < b & c", &svg_sink)
                && timeline_trace_events(timeline, &events_sink));
    assert_int_equal(count_of(svg.text, "<g>"), lanes.count);
    assert_int_equal(count_of(svg.text, "</g>"), lanes.count);
    assert_int_equal(count_of(svg.text, "<title>"), lanes.count);
    assert_int_equal(count_of(svg.text, "a &lt; b &amp; c"), 1);
    assert_int_equal(count_of(events.text, "\"ph\":\"X\""), lanes.count);
    assert_int_equal(count_of(events.text, "{"), count_of(events.text, "}"));
    for (int lane = 0; lane < LANES; lane++)
        assert_int_equal(count_of(events.text, formatted("\"args\":{\"name\":\"%s\"}",
                                                         lane_name((enum lane)lane))),
                         lanes.rows[lane]);
}

/* ---- Tests ---------------------------------------------------------------- */

static void check_object(const struct object *object, const char *path)
{
    SCOPED_VALUE(timeline) timeline = { .object = object, .to = UINT64_MAX };
    SCOPED_VALUE(timeline) part = { .object = object };
    SCOPED(c205) *machine = run(object, &timeline);
    check_sums(&timeline, machine, path);
    check_rows(&timeline);
    check_kanata(&timeline);
    part.from = xorshift(&random_state) % (c205_clock(machine) + 1);
    part.to = part.from + 1 + xorshift(&random_state) % 400;
    c205_free(run(object, &part));
    check_rows(&part);
    check_kanata(&part);
    check_texts(&part);
}

static void check_program(const char *path)
{
    SCOPED(object) *object = good_file(path);
    check_object(object, path);
}

TEST(programs)
{
    static const char *const patterns[] = { "asm/examples/*.s", "tests/programs/*.s",
                                            "tests/programs/traps/*.s" };
    for (size_t i = 0; i < COUNT(patterns); i++)
        each_file(patterns[i], check_program);
}

TEST(drawn)
{
    for (int i = 0; i < 200; i++) {
        char text[DRAWN_TEXT + 40];
        int length = sprintf(text, "        .equ n, %d\n",
                             1 + (int)(xorshift(&random_state) % 150));
        draw_program(&random_state, text + length);
        SCOPED(object) *object = good(text);
        check_object(object, "drawn.s");
    }
}

/* The reader of the format accepts exactly what its description allows. */
TEST(reader)
{
#define BEGIN "Kanata\t0004\nC=\t7\n"
#define THERE BEGIN "I\t0\t5\t0\n"
#define GONE "R\t0\t0\t0\n"
    static const char *const right[] = {
        BEGIN,
        THERE GONE,
        THERE "S\t0\t0\tF\nC\t1\nS\t0\t0\tX\nS\t0\t1\tstall\nC\t2\n" GONE,
        THERE "L\t0\t0\ta b\nL\t0\t1\tc\nL\t0\t1\td\n" GONE,
        THERE "I\t1\t5\t3\nW\t1\t0\t0\nR\t1\t9\t1\n" GONE,
    };
    static const struct {
        const char *text;
        size_t line;
    } wrong[] = {
        { "", 0 },
        { "Kanata\t0003\nC=\t7\n", 1 },
        { "Kanata\t0004\n", 1 },
        { "Kanata\t0004\nC\t7\n", 2 },
        { BEGIN "C=\t9\n", 3 },
        { BEGIN "I\t1\t0\t0\n", 3 },
        { BEGIN "C\t-1\n", 3 },
        { BEGIN "S\t0\t0\tF\n", 3 },
        { BEGIN "C\t1\t2\n", 3 },
        { THERE "I\t0\t1\t0\n", 4 },
        { BEGIN "X\t1\n", 3 },
        { THERE "L\t0\t2\ta\n" GONE, 4 },
        { BEGIN "\n", 3 },
        { THERE "L\t0\t0\t\n" GONE, 4 },
        { BEGIN "C\t1", 3 },
        { THERE "S\t0\t0\tF\nE\t0\t0\tX\n" GONE, 5 },
        { THERE GONE GONE, 5 },
        { THERE "S\t0\t0\tF\nE\t0\t1\tF\n" GONE, 5 },
        { THERE "R\t0\t1\t0\n", 4 },
        { THERE GONE "L\t0\t0\ta\n", 5 },
        { THERE "R\t0\t0\t2\n", 4 },
        { THERE "W\t0\t1\t0\n" GONE, 4 },
        { THERE, 3 },
    };
    size_t line;

    for (size_t i = 0; i < COUNT(right); i++)
        assert_null(kanata_fault(right[i], &line));
    for (size_t i = 0; i < COUNT(wrong); i++) {
        assert_non_null(kanata_fault(wrong[i].text, &line));
        assert_int_equal(line, wrong[i].line);
    }
}
