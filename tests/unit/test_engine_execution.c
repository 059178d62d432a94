/* test_engine_execution.c - replies of the engine after random moves, forwards and
 * backwards, are compared with machines that run to the same step. Profiles, timelines
 * and output are compared, too. State that remains from an earlier move fails here. */
#include "asm/measure/line_profile.h"
#include "asm/view/print.h"
#include "base/accounts.h"
#include "tests/unit/draw.h"
#include "tests/unit/engine_client.h"
#include "tests/unit/plain_run.h"
#include "tests/unit/random_stepping.h"
#include "tests/unit/saved_machine.h"

/* ---- A separate machine -------------------------------------------------------- */

struct fresh {
    c205 *machine;
    bool has_last;
    c205_event last; /* its pointer `record` is invalid */
    struct text_buffer printed;
    struct printer printer;
};

static void keep_last(void *context, const c205 *machine UNUSED,
                      const c205_event *event)
{
    struct fresh *fresh = context;
    if (event->kind != C205_EVENT_INSTRUCTION && event->kind != C205_EVENT_REQUEST)
        return;
    fresh->has_last = true;
    fresh->last = *event;
}

/* Runs a new machine for `steps` steps from the beginning. */
static void fresh_run(struct fresh *fresh, const struct object *object, uint64_t steps)
{
    c205_stop stop;
    *fresh = (struct fresh){ .machine = machine_with(&object->program, prior_model) };
    fresh->printer.sink = text_buffer_sink(&fresh->printed);
    assert_true(c205_listen(fresh->machine, printer_listen, &fresh->printer));
    assert_true(c205_listen(fresh->machine, keep_last, fresh));
    for (; steps > 0; steps--)
        c205_step(fresh->machine, &stop);
}

static void fresh_free(struct fresh *fresh)
{
    c205_free(fresh->machine);
    text_buffer_free(&fresh->printed);
}

static void check_registers(const struct json_value *view, const struct fresh *fresh)
{
    const c205 *machine = fresh->machine;
    const struct json_value *item = json_member_first(view, "registers");
    unsigned i = 0;
    for (; item; item = item->next, i++) {
        char hex[C205_TEXT_SIZE], text[C205_TEXT_SIZE];
        c205_word word = c205_register(machine, i);
        c205_to_hex(word, hex);
        c205_to_text(word, text);
        assert_true(number_of(item, "number") == i);
        assert_string_equal(text_of(item, "hex"), hex);
        assert_string_equal(text_of(item, "text"), text);
        assert_true(number_of(item, "integer") == (double)c205_to_integer(word));
        assert_int_equal(json_member_truth(item, "changed", false),
                         fresh->last.written[i / 64] >> i % 64 & 1);
    }
    assert_int_equal(i, C205_REGISTERS);
}

static void check_last(const struct json_value *view, const struct fresh *fresh)
{
    const struct json_value *last = json_member(view, "last");
    const struct json_value *piece = json_member_first(last, "pieces");
    double clocks = 0;
    assert_int_equal(last != NULL, fresh->has_last);
    if (!last)
        return;
    for (; piece; piece = piece->next) {
        clocks += number_of(piece, "clocks");
        assert_true(number_of(piece, "line") >= 0);
    }
    assert_true(clocks == (double)fresh->last.clocks);
    assert_true(number_of(last, "clocks") == clocks);
    assert_true(number_of(last, "issued") == (double)fresh->last.issued);
    assert_true(number_of(last, "elements") == (double)fresh->last.elements);
    assert_string_equal(text_of(last, "mnemonic"), fresh->last.insn->mnemonic);
}

static void check_causes(const struct json_value *owner, const c205_account *account)
{
    const struct json_value *causes = json_member(owner, "causes");
    for (int i = 0; i < C205_CAUSES; i++) {
        const struct json_value *item = causes ? causes->first : NULL;
        uint64_t sum = 0;
        for (; item; item = item->next)
            if (strcmp(text_of(item, "cause"), c205_cause_name((c205_cause)i)) == 0)
                sum += (uint64_t)number_of(item, "clocks");
        assert_int_equal(sum, account->clocks[i]);
    }
    assert_true(number_of(owner, "clocks") == (double)accounts_clocks(account));
    assert_true(number_of(owner, "instructions") == (double)account->instructions);
    assert_true(number_of(owner, "elements") == (double)account->elements);
}

static void check_accounts(const struct json_value *view, const c205 *machine)
{
    const struct json_value *reported = json_member(view, "accounts");
    const struct json_value *region = json_member_first(reported, "regions");
    SCOPED_VALUE(accounts) accounts = { .model = prior_model };
    assert_true(accounts_add(&accounts, machine));
    c205_account all = accounts_together(&accounts);
    check_causes(reported, &all);
    for (size_t i = 0; i < accounts.count; i++) {
        if (accounts_clocks(&accounts.items[i]) == 0)
            continue;
        assert_string_equal(text_of(region, "region"),
                            accounts_region(&accounts.items[i]));
        check_causes(region, &accounts.items[i]);
        region = region->next;
    }
    assert_null(region);
}

static void check_vectors(const struct json_value *view, const struct object *object,
                          const c205 *machine)
{
    const struct json_value *vector = json_member_first(view, "vectors");
    for (; vector; vector = vector->next) {
        const struct asm_symbol *symbol = object_symbol(object,
                                                        text_of(vector, "label"));
        const struct json_value *value = json_member_first(vector, "values");
        uint64_t at = (uint64_t)symbol->value;
        assert_string_equal(text_of(vector, "kind"), "words");
        assert_true(number_of(vector, "count") == (double)symbol->count);
        for (; value; value = value->next, at += 64) {
            char text[C205_TEXT_SIZE];
            c205_word word;
            assert_true(c205_read(machine, at, &word, 1));
            c205_to_text(word, text);
            assert_string_equal(value->text, text);
        }
        assert_int_equal((at - (uint64_t)symbol->value) / 64, symbol->count);
    }
}

/* ---- Walks ----------------------------------------------------------------------- */

struct walk {
    struct talk talk;
    struct plain plain;
    uint64_t step, known;
    struct plain_stops stops;
};

static void check_place(struct walk *walk, const char *asked)
{
    const struct json_value *view = talk_ask(&walk->talk,
                                             "{'do': 'view', 'all-registers': true}");
    SCOPED_VALUE(fresh) fresh;
    fresh_run(&fresh, walk->plain.object, walk->step);
    FAIL_IF(number_of(view, "step") != (double)walk->step, "%s: step %g, not %llu",
            asked, number_of(view, "step"), (unsigned long long)walk->step);
    assert_true(number_of(view, "steps") == (double)walk->known);
    assert_true(number_of(view, "clock") == (double)c205_clock(fresh.machine));
    assert_true(number_of(view, "pc") == (double)c205_pc(fresh.machine));
    assert_int_equal(json_member_truth(view, "ended", false),
                     walk->step == walk->plain.end);
    assert_string_equal(text_of(view, "printed"),
                        fresh.printed.text ? fresh.printed.text : "");
    check_registers(view, &fresh);
    check_last(view, &fresh);
    check_accounts(view, fresh.machine);
    check_vectors(view, walk->plain.object, fresh.machine);
}

static const char *why_at(const struct walk *walk, uint64_t step)
{
    return step == walk->plain.end                            ? "end"
           : plain_stops_at(&walk->plain, &walk->stops, step) ? "breakpoint"
                                                              : "moved";
}

/* Sets a breakpoint at a random line. It moves to the next line that has code. */
static void choose_stop(struct walk *walk)
{
    const struct object *object = walk->plain.object;
    size_t wanted = 1 + below(60), found = 0;
    for (size_t i = 0; i < object->line_count; i++) {
        const struct asm_line *each = &object->lines[i];
        if (each->is_code && strcmp(each->shown.file, "program.s") == 0
            && each->shown.number >= wanted
            && (found == 0 || each->shown.number < found)) {
            found = each->shown.number;
            walk->stops.place = each->address;
        }
    }
    const struct json_value
        *line = json_member_first(talk_ask(&walk->talk,
                                           "{'do': 'breaks', 'lines': [%zu]}", wanted),
                                  "lines");
    assert_true(number_of(line, "wanted") == (double)wanted);
    walk->stops.by_place = found > 0;
    if (found > 0)
        assert_true(number_of(line, "line") == (double)found);
    else
        assert_true(*text_of(line, "message"));
}

static void go(struct walk *walk, const char *how, uint64_t n, uint64_t step,
               const char *why)
{
    const struct json_value *reply = talk_ask(&walk->talk,
                                              "{'do': 'go', 'how': '%s', 'n': %llu}",
                                              how, (unsigned long long)n);
    walk->step = step;
    walk->known = step > walk->known ? step : walk->known;
    assert_true(json_member_truth(reply, "done", false));
    FAIL_IF(strcmp(text_of(reply, "why"), why) != 0, "%s %llu: %s, not %s", how,
            (unsigned long long)n, walk->talk.text, why);
    check_place(walk, how);
}

/* Moves forwards to a stop, by at least one step and at most n steps. */
static void go_on(struct walk *walk, const char *how, uint64_t n)
{
    uint64_t step = plain_on(&walk->plain, &walk->stops, walk->step, n);
    go(walk, how, n, step, why_at(walk, step));
}

/* Steps over a call, to the instruction after the call. */
static void go_next(struct walk *walk)
{
    const struct plain *plain = &walk->plain;
    uint64_t pc = plain->moments[walk->step].pc, step = walk->step + 1;
    const struct asm_line *line = object_line(plain->object, pc);
    if (strstr(line->source, "BSAVE"))
        while (step < plain->end && !plain_stops_at(plain, &walk->stops, step)
               && plain->moments[step].pc != pc + 32 * line->halves)
            step++;
    go(walk, "next", 1, step, why_at(walk, step));
}

static void move(struct walk *walk)
{
    const struct plain *plain = &walk->plain;
    uint64_t end = plain->end, n = 1 + below(20), step;
    switch (below(10)) {
    case 0: go_on(walk, "continue", UINT64_C(1) << 40); break;
    case 1: go_on(walk, "step", 1 + below(200)); break;
    case 2:
        if (walk->step > 0)
            go(walk, "back", n, walk->step > n ? walk->step - n : 0, "moved");
        break;
    case 3:
        step = plain_back(plain, &walk->stops, walk->step);
        go(walk, "reverse-continue", 1, step, step > 0 ? "breakpoint" : "start");
        break;
    case 4:
        n = below(end + 1);
        go(walk, "step-to", n, n, n == end ? "end" : "moved");
        break;
    case 5:
        n = 1 + below(plain->moments[end].clock);
        step = plain_to_clock(plain, 0, n);
        go(walk, "clock-to", n, step, step == end ? "end" : "moved");
        break;
    case 6: go(walk, "end", 1, end, "end"); break;
    case 7: go_next(walk); break;
    case 8:
        for (n = 0; n < 12 && walk->step < end; n++)
            go_next(walk);
        break;
    default: go(walk, "start", 1, 0, "moved"); break;
    }
}

/* Makes random moves. A program that has ended first moves backwards. */
static void walk_by_chance(struct walk *walk, size_t moves)
{
    for (size_t i = 0; i < moves; i++) {
        if (below(6) == 0)
            choose_stop(walk);
        if (walk->step == walk->plain.end)
            go(walk, "back", 7, walk->step - 7, "moved");
        move(walk);
    }
}

static struct walk new_walk(void)
{
    SCOPED_VALUE(text_buffer) text;
    SCOPED_VALUE(diagnostics) said = { 0 };
    draw_walk(&random_state, &text);
    struct walk walk = { .talk = talk_with(text.text, AND_PRIOR) };
    walk.plain = run_plainly(assemble_text("program.s", text.text, NULL, &said),
                             &random_state);
    return walk;
}

static void walk_free(struct walk *walk)
{
    talk_free(&walk->talk);
    object_free(walk->plain.object);
    free(walk->plain.moments);
}

TEST(walks)
{
    enum { ROUNDS = 10, MOVES = 40 };
    for (size_t i = 0; i < ROUNDS; i++) {
        SCOPED_VALUE(walk) walk = new_walk();
        check_place(&walk, "load");
        walk_by_chance(&walk, MOVES);
    }
}

/* ---- Profiles and timelines ------------------------------------------------------ */

static void check_same_view(struct talk *talk, const char *before)
{
    talk_ask(talk, "{'do': 'view'}");
    assert_string_equal(talk->text, before);
}

/* The charged intervals of the timeline must be adjacent, up to the last known step. */
static void check_timeline(struct walk *walk)
{
    const struct json_value *reply = talk_ask(&walk->talk,
                                              "{'do': 'timeline', 'most': 50000}");
    uint64_t clock = 0, by_cause[C205_CAUSES] = { 0 };
    SCOPED_VALUE(fresh) fresh;
    assert_false(json_member_truth(reply, "full", true));
    for (const struct json_value *piece = json_member_first(reply, "charged"); piece;
         piece = piece->next) {
        int cause = 0;

        assert_true(number_of(piece, "begin") == (double)clock);
        while (strcmp(c205_cause_name((c205_cause)cause), text_of(piece, "cause")) != 0)
            cause++;
        by_cause[cause] += (uint64_t)number_of(piece, "end") - clock;
        clock = (uint64_t)number_of(piece, "end");
    }
    fresh_run(&fresh, walk->plain.object, walk->known);
    assert_int_equal(clock, c205_clock(fresh.machine));
    for (int cause = 0; cause < C205_CAUSES; cause++)
        assert_int_equal(by_cause[cause],
                         clocks_of_cause(fresh.machine, (c205_cause)cause));
    reply = talk_ask(&walk->talk, "{'do': 'timeline', 'file': 'x.svg'}");
    assert_non_null(strstr(text_of(reply, "file"), "<svg"));
}

/* Profiles and timelines, complete or not, must not move the program. */
TEST(replays)
{
    enum { ROUNDS = 10, MOVES = 6 };
    for (size_t i = 0; i < ROUNDS; i++) {
        SCOPED_VALUE(walk) walk = new_walk();
        for (size_t k = 0; k < MOVES; k++) {
            walk_by_chance(&walk, 3);
            talk_ask(&walk.talk, "{'do': 'view'}");
            FREED char *before = NON_NULL(strdup(walk.talk.text));
            SCOPED_VALUE(fresh) fresh;
            const struct json_value *rows, *row;

            fresh_run(&fresh, walk.plain.object, walk.step);
            rows = json_member(talk_ask(&walk.talk, "{'do': 'profile'}"), "lines");
            for (int cause = 0; cause < C205_CAUSES; cause++) {
                uint64_t sum = 0;
                for (row = rows->first; row; row = row->next)
                    sum += (uint64_t)number_of(row, accounts_cause_columns[cause].key);
                assert_int_equal(sum,
                                 clocks_of_cause(fresh.machine, (c205_cause)cause));
            }
            check_same_view(&walk.talk, before);
            check_timeline(&walk);
            check_same_view(&walk.talk, before);
            talk_ask(&walk.talk, "{'do': '%s', 'ms': 0}",
                     below(2) ? "profile" : "timeline");
            check_same_view(&walk.talk, before);
        }
    }
}

/* After a change of a register, the profile belongs to the changed run. */
TEST(changed)
{
    SCOPED_VALUE(talk) talk =
        talk_with("        ES r10, 100\n        EX r11, on\non:     IS r12, 1\n"
                  "        DBNZ r10, [r11]\n        EXIT\n",
                  AND_PRIOR);
    const struct json_value *rows, *account;
    talk_ask(&talk, "{'do': 'go', 'how': 'step', 'n': 10}");
    talk_ask(&talk, "{'do': 'say', 'line': 'set r10 = 5'}");
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    account = json_member(talk_ask(&talk, "{'do': 'view'}"), "accounts");
    double clocks = number_of(account, "clocks");
    rows = json_member_first(talk_ask(&talk, "{'do': 'profile'}"), "lines");
    for (; rows; rows = rows->next)
        clocks -= number_of(rows, "clocks");
    assert_true(clocks == 0);
}

/* The page shows the program's output separately. An incomplete line in it therefore
 * causes no newline before the debugger's output. */
TEST(open_line)
{
    static const char text[] = "        ES r10, 9\n"
                               "        EXIT r10, r0, 2\n"
                               "        EXIT\n";
    static const char *const lines[] = { "step 2", "account", "continue", "where" };
    SCOPED_VALUE(talk) talk = talk_with(text, "");
    for (size_t i = 0; i < COUNT(lines); i++) {
        talk_ask(&talk, "{'do': 'say', 'line': '%s'}", lines[i]);
        assert_true(*text_of(talk.reply, "text") > ' ');
    }
    talk_ask(&talk, "{'do': 'view'}");
    assert_string_equal(text_of(talk.reply, "printed"), "9");
}

/* After a change of a register, the output belongs to the changed run. */
TEST(changed_prints)
{
    static const struct {
        const char *requests[2], *printed;
    } rows[] = {
        { { "{'do': 'go', 'how': 'end'}", "{'do': 'go', 'how': 'step-to', 'n': 6}" },
          "9\n8" },
        { { "{'do': 'say', 'line': 'set r10 = 2'}", "{'do': 'go', 'how': 'step'}" },
          "9\n8\n" },
        { { "{'do': 'say', 'line': 'set r10 = 2'}", "{'do': 'go', 'how': 'end'}" },
          "9\n8\n1\n" },
    };
    static const char text[] = "        ES r10, 9\n        EX r11, on\n"
                               "on:     EXIT r10, r0, 2\n"
                               "        EXIT r0, r0, 5\n"
                               "        DBNZ r10, [r11]\n        EXIT\n";
    SCOPED_VALUE(talk) talk = talk_with(text, AND_PRIOR);
    for (size_t i = 0; i < COUNT(rows); i++) {
        talk_ask(&talk, "%s", rows[i].requests[0]);
        talk_ask(&talk, "%s", rows[i].requests[1]);
        talk_ask(&talk, "{'do': 'view'}");
        assert_string_equal(text_of(talk.reply, "printed"), rows[i].printed);
    }
}

/* The engine stores up to a million characters of the output of each run. */
TEST(cut)
{
    static const char text[] =
        "        EX r10, 70000\n        EX r11, on\n"
        "        EX r12, 100000000000000\n"
        "on:     EXIT r12, r0, 2\n        DBNZ r10, [r11]\n        EXIT\n";
    SCOPED_VALUE(talk) talk = talk_with(text, "");
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    talk_ask(&talk, "{'do': 'view'}");
    assert_true(json_member_truth(talk.reply, "printed_cut", false));
    assert_true(strlen(text_of(talk.reply, "printed")) > 1 << 19);
    talk_ask(&talk, "{'do': 'go', 'how': 'step-to', 'n': 5}");
    talk_ask(&talk, "{'do': 'view'}");
    assert_false(json_member_truth(talk.reply, "printed_cut", true));
    talk_ask(&talk, "{'do': 'say', 'line': 'set r10 = 1'}");
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    talk_ask(&talk, "{'do': 'view'}");
    assert_false(json_member_truth(talk.reply, "printed_cut", true));
    assert_string_equal(text_of(talk.reply, "printed"),
                        "100000000000000100000000000000");
}
