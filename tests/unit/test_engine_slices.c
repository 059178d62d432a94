/* test_engine_slices.c - requests that are executed in slices are compared with the
 * same requests in one piece, and endless programs with their limit. A slice that
 * repeats or skips a step, or a program that never stops, fails here. */
#include "tests/unit/draw.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/random_stepping.h"
#include "tests/unit/engine_client.h"

/* A program of about 200,000 steps, with subroutine calls. */
static const char long_program[] = "        .include \"core.s\"\n"
                                   "        .regs r16, turns, to, link, place\n"
                                   "        .regs r24, inner, back, n\n"
                                   "        ES turns, 6\n"
                                   "        EX to, again\n"
                                   "again:  call long, link, place\n"
                                   "        IS n, 1\n"
                                   "        EXIT n, r0, 2\n"
                                   "        DBNZ turns, [to]\n"
                                   "        EXIT\n"
                                   "long:   EX inner, 16000\n"
                                   "        EX back, here\n"
                                   "here:   IS n, 3\n"
                                   "        DBNZ inner, [back]\n"
                                   "        return link\n";

/* Compares the replies to slices of at most `clocks`. Returns the slices' number. */
static size_t ask_both(struct talk *whole, struct talk *sliced, const char *request,
                       uint64_t clocks)
{
    size_t slices = 0;
    talk_ask(whole, "%s}", request);
    talk_ask(sliced, "%s, 'clocks': %d}", request, 1 + (int)below(clocks));
    while (!json_member_truth(sliced->reply, "done", true)) {
        slices++;
        if (below(4) == 0)
            talk_ask(sliced, "{'do': 'about'}");
        talk_ask(sliced, "{'do': 'more', 'clocks': %d}", 1 + (int)below(clocks));
    }
    assert_string_equal(sliced->text, whole->text);
    talk_refused(sliced, "no work is left", "{'do': 'more'}");
    return slices;
}

TEST(slices)
{
    static const char *const requests[] = {
        "{'do': 'go', 'how': 'end'",
        "{'do': 'go', 'how': 'continue'",
        "{'do': 'go', 'how': 'reverse-continue'",
        "{'do': 'go', 'how': 'next'",
        "{'do': 'go', 'how': 'next', 'n': 5",
        "{'do': 'go', 'how': 'start'",
        "{'do': 'profile'",
        "{'do': 'timeline', 'most': 100",
    };
    enum { REQUESTS = COUNT(requests), ROUNDS = 50 };
    SCOPED_VALUE(talk) whole = talk_with(long_program, "");
    SCOPED_VALUE(talk) sliced = talk_with(long_program, "");
    talk_ask(&whole, "{'do': 'breaks', 'lines': [8]}");
    talk_ask(&sliced, "{'do': 'breaks', 'lines': [8]}");
    for (size_t i = 0; i < ROUNDS; i++) {

        const char *jump = formatted("{'do': 'go', 'how': '%s', 'n': %d",
                                     below(2) ? "step-to" : "step", (int)below(200000));
        if (below(2))
            ask_both(&whole, &sliced, jump, 30000);
        ask_both(&whole, &sliced, requests[below(REQUESTS)], 30000);
        talk_ask(&whole, "{'do': 'view'}");
        talk_ask(&sliced, "{'do': 'view'}");
        assert_string_equal(sliced.text, whole.text);
    }
}

/* A sweep and a comparison in slices give the same replies. */
TEST(other_work)
{
    static const char *const requests[] = {
        "{'do': 'sweep', " SWEEP,
        "{'do': 'compare', 'texts': [{'name': 'a', 'text': ' ES r10, 5000\\n EX r11, "
        "on\\non: IS r12, 1\\n DBNZ r10, [r11]\\n EXIT\\n'}, {'name': 'b', 'text': ' "
        "EXIT\\n'}]",
    };
    SCOPED_VALUE(talk) whole = talk_with(NULL, "");
    SCOPED_VALUE(talk) sliced = talk_with(NULL, "");
    for (size_t i = 0; i < COUNT(requests); i++)
        assert_true(ask_both(&whole, &sliced, requests[i], 1) > 0);
    talk_ask(&whole, "%s}", requests[1]);
    assert_non_null(strstr(whole.text, "The second takes"));
}

/* The limit stops an endless program, which can then be continued. */
TEST(limit)
{
    static const char text[] = " EX r10, on\non: IBNZ r11, [r10]\n EX r11, 1\n EXIT\n";
    SCOPED_VALUE(talk) talk = talk_with(text, "");
    for (int i = 0; i < 2; i++) {
        talk_ask(&talk, "{'do': 'go', 'how': 'end', 'limit': 100000}");
        assert_string_equal(text_of(talk.reply, "why"), "limit");
    }
    engine_bound(talk.engine, 1000000);
    talk_ask(&talk, "{'do': 'go', 'how': 'end'}");
    assert_string_equal(text_of(talk.reply, "why"), "limit");
    talk_ask(&talk, "{'do': 'say', 'line': 'continue'}");
    assert_non_null(strstr(text_of(talk.reply, "text"), "interrupted"));
    talk_ask(&talk, "{'do': 'compare', 'texts': [{'text': 'on: BIM on\\n'}, {'text': "
                    "' EXIT'}], 'limit': 262145, 'clocks': 1}");
    talk_refused(&talk, "the clock limit is reached", "{'do': 'more', 'clocks': 1}");
}
