/* test_dap_heard.c - what an editor may say while a program runs, and what it may not
 * say at all.
 */
#include "asm/dap/message.h"
#include "tests/unit/dap_session.h"
#include "tests/unit/prior_model.h"

/* ---- While it runs ----------------------------------------------------------------------------- */

static const char endless[] = "        EX r10, again\n"
                              "again:  IBNZ r11, [r10]\n"
                              "        EX r11, 1\n"
                              "        EXIT\n";

TEST(running)
{
    struct dap_client client;

    client_launch(&client, endless, "");
    client_ask(&client, "configurationDone", NULL);
    client_ask(&client, "threads", NULL);
    client_refused(&client, "pause it", "stackTrace", "{\"threadId\": 1}");
    client_refused(&client, "pause it", "continue", "{\"threadId\": 1}");
    client_ask(&client, "pause", "{\"threadId\": 1}");
    client_stopped(&client, "pause");
    assert_int_equal(client_pc(&client), 0x400040);
    client_ask(&client, "continue", "{\"threadId\": 1}");
    client_ask(&client, "setBreakpoints",
               "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [{\"line\": "
               "2}]}",
               client_path);
    client_stopped(&client, "breakpoint");
    client_ask(&client, "setBreakpoints",
               "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": []}", client_path);
    client_ask(&client, "reverseContinue", "{\"threadId\": 1}");
    client_stopped(&client, "entry");
    client_ask(&client, "continue", "{\"threadId\": 1}");
    client_ask(&client, "restart", NULL);
    client_ask(&client, "pause", "{\"threadId\": 1}");
    client_stopped(&client, "pause");
    assert_true(client_step(&client) > 0);
    client_leave(&client);
}

/* A line for the debugger that does not end: others are heard meanwhile. */
TEST(running_line)
{
    struct dap_client client;

    client_launch(&client, endless, ", \"stopOnEntry\": true");
    client_ask(&client, "configurationDone", NULL);
    client_stopped(&client, "entry");
    client_tell(&client, "evaluate", "{\"expression\": \"c\", \"context\": \"repl\"}");
    client_ask(&client, "pause", "{\"threadId\": 1}");
    client.sent -= 3;
    assert_non_null(strstr(the_text(the(client_response(&client), "body"), "result"),
                           "interrupted"));
    client.sent += 3;
    client_stopped(&client, "goto");
    client_ask(&client, "continue", "{\"threadId\": 1}");
    client_ask(&client, "terminate", NULL);
    client_event(&client, "terminated");
    client_ask(&client, "restart", NULL);
    client_stopped(&client, "entry");
    client_ask(&client, "continue", "{\"threadId\": 1}");
    client_leave(&client);
}

/* Without debugging there is no stop. */
TEST(no_debug)
{
    struct dap_client client;

    client_launch(&client, "        STO [r0], r1\n",
                  ", \"noDebug\": true, \"stopOnEntry\": true");
    client_ask(&client, "configurationDone", NULL);
    assert_int_equal(the_whole(client_event(&client, "exited"), "exitCode"), 1);
    client_event(&client, "terminated");
    assert_non_null(strstr(client.output.text, "trap unmapped-address"));
    client_leave(&client);
}

/* ---- What is wrong -------------------------------------------------------------------------------- */

TEST(wrong_order)
{
    struct dap_client client;

    client_begin(&client, NULL);
    client_refused(&client, "initialize comes first", "launch", NULL);
    client_refused(&client, "there is no request 'attach'", "attach", NULL);
    client_refused(&client, "of the format 'uri'", "initialize",
                   "{\"pathFormat\": \"uri\"}");
    client_ask(&client, "initialize",
               "{\"linesStartAt1\": false, \"columnsStartAt1\": false}");
    client_refused(&client, "launch comes first", "threads", NULL);
    client_refused(&client, "launch comes first", "terminate", NULL);
    client_refused(&client, "'program' is missing", "launch", NULL);
    client_refused(&client, "from stdin", "launch", "{\"program\": \"-\"}");
    client_refused(&client, "names with integers", "launch",
                   "{\"program\": \"x.s\", \"defines\": {\"N\": \"8\"}}");
    client_refused(&client, "no list of texts", "launch",
                   "{\"program\": \"x.s\", \"include\": [8]}");
    client_refused(&client, "missing.s", "launch", "{\"program\": \"missing.s\"}");
    client_refused(&client, "no_such_model", "launch",
                   "{\"program\": \"asm/examples/dot.s\", \"model\": "
                   "\"no_such_model\"}");
    client_write("        ADDN r1\n");
    client_refused(&client, "1:16: error", "launch", "{\"program\": \"%s\"}",
                   client_path);
    assert_non_null(strstr(client.output.text, "1:16: error"));
    client_write(client_program);
    client_ask(&client, "launch", "{\"program\": \"%s\"}", client_path);
    client_event(&client, "initialized");
    client_refused(&client, "launched already", "launch", "{\"program\": \"%s\"}",
                   client_path);
    client_refused(&client, "configurationDone comes first", "continue",
                   "{\"threadId\": 1}");
    assert_int_equal(the_whole(the(client_ask(&client, "setBreakpoints",
                                              "{\"source\": {\"path\": \"%s\"}, "
                                              "\"breakpoints\": [{\"line\": 5}]}",
                                              client_path),
                                   "breakpoints")
                                   ->first,
                               "line"),
                     5); /* the sixth, counted from 0 */
    client_ask(&client, "configurationDone", NULL);
    client_stopped(&client, "breakpoint");
    assert_int_equal(the_whole(client_frames(&client)->first, "line"), 5);
    assert_int_equal(the_whole(client_frames(&client)->first, "column"), 0);
    client_leave(&client);
}

static void check_stop(struct dap_client *client, const char *request, const char *stop,
                       const char *why)
{
    const struct json_value *list =
        the(client_ask(client, request,
                       "{\"source\": {\"path\": \"%s\"}, \"breakpoints\": [%s]}",
                       client_path, stop),
            "breakpoints");

    assert_int_equal(length_of(list), 1);
    if (json_member_truth(list->first, "verified", true)
        || !strstr(the_text(list->first, "message"), why))
        fail_msg("%s: %s", stop, json_member_text(list->first, "message"));
}

TEST(wrong_stops)
{
    static const struct {
        const char *request, *stop, *why;
    } wrong[] = {
        { "setBreakpoints", "{\"line\": 1000}", "no code at line 1000" },
        { "setBreakpoints", "{\"line\": 9, \"condition\": \"1 +\"}",
          "expected a value" },
        { "setBreakpoints", "{\"line\": 9, \"condition\": \"1 2\"}", "to mean" },
        { "setBreakpoints", "{\"line\": 9, \"hitCondition\": \"many\"}", "to mean" },
        { "setBreakpoints", "{\"line\": 9, \"logMessage\": \"x\"}", "no log points" },
        { "setBreakpoints", "{\"line\": \"x\"}", "no integer" },
        { "setFunctionBreakpoints", "{\"name\": \"nobody\"}", "nothing is called" },
        { "setFunctionBreakpoints", "{}", "missing" },
        { "setInstructionBreakpoints", "{\"instructionReference\": \"x\"}",
          "no address" },
        { "setInstructionBreakpoints", "{}", "missing" },
        { "setDataBreakpoints", "{\"dataId\": \"64, 1\"}", "there are no words" },
        { "setDataBreakpoints", "{\"dataId\": \"a.words, 65\"}", "1 to 64 words" },
        { "setDataBreakpoints", "{\"dataId\": \"a.words\", \"accessType\": \"read\"}",
          "only what is written" },
    };
    struct dap_client client;

    client_enter(&client, client_program);
    for (size_t i = 0; i < COUNT(wrong); i++)
        check_stop(&client, wrong[i].request, wrong[i].stop, wrong[i].why);
    client_refused(&client, "no filter but", "setExceptionBreakpoints",
                   "{\"filters\": [\"all\"]}");
    client_refused(&client, "no variables", "variables", "{\"variablesReference\": 0}");
    client_refused(&client, "counted from 0", "variables",
                   "{\"variablesReference\": 262, \"start\": -1}");
    client_refused(&client, "'count' is", "readMemory",
                   "{\"memoryReference\": \"0\", \"count\": -1}");
    client_refused(&client, "no byte begins", "readMemory",
                   "{\"memoryReference\": \"1\", \"count\": 1}");
    client_refused(&client, "no instruction begins", "disassemble",
                   "{\"memoryReference\": \"8\", \"instructionCount\": 1}");
    client_leave(&client);
}

/* What is no JSON is told and passed over; without a frame nobody knows where the next one
 * begins. */
TEST(broken)
{
    static const char *const frames_of[] = {
        "Hello\r\n\r\n",
        "Content-Length: x\r\n\r\n",
        "Content-Length: 99999999\r\n\r\n",
        "Content-Length: 5\n\n",
        "Content-Type: text\r\n\r\n",
        "Content-Length: \r\n\r\n",
    };
    static const char json[] = "Content-Length: 5\r\n\r\nhello";
    static const char half[] = "Content-Length: 50\r\n\r\nhello";
    struct dap_client client;

    for (size_t i = 0; i < COUNT(frames_of); i++) {
        client_begin(&client, NULL);
        client_send(&client, frames_of[i], strlen(frames_of[i]));
        assert_int_equal(client_end(&client), 1);
    }
    client_begin(&client, NULL);
    client_send(&client, half, strlen(half));
    assert_int_equal(client_end(&client), 1);
    client_begin(&client, NULL);
    client_send(&client, json, strlen(json));
    client_ask(&client, "initialize", NULL);
    assert_non_null(strstr(client.output.text, "no value at byte 0"));
    assert_int_equal(client_end(&client), 0);
}

/* ---- Of the command line ------------------------------------------------------------------------------ */

TEST(command_line)
{
    static const char *const arguments[] = {
        "--define", "N=7", "--warm", "--model", "cyber205-1pipe", client_path, NULL
    };
    struct dap_client client;

    client_write("        ES r10, N + M\n        EXIT r10, r0, 0\n");
    client_begin(&client, arguments);
    client_ask(&client, "initialize", NULL);
    client_ask(&client, "launch", "{\"defines\": {\"M\": 4}, \"include\": [\".\"]}");
    client_event(&client, "initialized");
    client_ask(&client, "configurationDone", NULL);
    assert_int_equal(the_whole(client_event(&client, "exited"), "exitCode"), 11);
    client_event(&client, "terminated");
    client_leave(&client);
}

GROUP(set_up_model, tear_down_model);
