/* fuzz_dap.c - reads any bytes as the input of an editor: each line is the content of a
 * message, or the whole input has headers.
 *
 * For any input, the output must be JSON in numbered frames, and the session must end
 * with the input.
 */
#include <string.h>

#include "asm/dap/dap.h"
#include "asm/dap/message.h"
#include "base/json_read.h"
#include "tests/fuzz/fuzz.h"

bool fuzz_accepted;

static const char text[] = "        .include \"vectors.s\"\n"
                           "        .regs r16, a, b, turns, to, link, place\n"
                           "        words a, 1.5, -2.0, 3.0, 4.0\n"
                           "        words b\n"
                           "        ES    turns, 5\n"
                           "        EX    to, again\n"
                           "        .kernel loop\n"
                           "again:  ADDNV [a], [a], [b]\n"
                           "        call  double, link, place\n"
                           "        LINKV\n"
                           "        MPYSV [a], r0, [b]\n"
                           "        ADDNV [b], [a], [b]\n"
                           "        DBNZ  turns, [to]\n"
                           "        .endkernel\n"
                           "        EXIT  turns, r0, 2\n"
                           "        EXIT\n"
                           "double: ADDNV [b], [b], [b]\n"
                           "        return link\n";

/* ---- The client ---------------------------------------------------------------- */

struct talk {
    struct text_buffer said; /* sent by the client */
    size_t taken;            /* length that was read */
    int64_t heard;
};

static void frame_lines(struct talk *talk, const uint8_t *data, size_t size)
{
    enum { MAX_LINES = 14 };
    struct sink sink = text_buffer_sink(&talk->said);
    size_t from = 0, lines = 0;
    for (size_t i = 0; i <= size && lines < MAX_LINES; i++) {
        SCOPED_VALUE(text_buffer) line = { 0 };
        struct sink filling = text_buffer_sink(&line);
        if (i < size && data[i] != '\n')
            continue;
        filling.put(filling.context, (const char *)data + from, i - from);
        if (line.length > 0)
            message_put(&line, &sink);
        from = i + 1;
        lines++;
    }
}

static void say(struct talk *talk, const uint8_t *data, size_t size)
{
    static const char header[] = "Content";
    struct sink sink = text_buffer_sink(&talk->said);
    if (size >= sizeof header - 1 && memcmp(data, header, sizeof header - 1) == 0)
        sink.put(sink.context, (const char *)data, size);
    else
        frame_lines(talk, data, size);
}

/* Reads the input in pieces of several lengths. */
static size_t give(void *context, char *bytes, size_t most)
{
    struct talk *talk = context;
    size_t left = talk->said.length - talk->taken;
    size_t length = 1 + talk->taken * 7 % 300;
    length = length < left ? length : left;
    length = length < most ? length : most;
    if (length > 0)
        memcpy(bytes, talk->said.text + talk->taken, length);
    talk->taken += length;
    return length;
}

static bool is_ready(void *context UNUSED)
{
    return true;
}

static void hear(void *context, const char *bytes, size_t length)
{
    struct talk *talk = context;
    struct text_buffer whole = { .text = (char *)bytes, .length = length };
    struct message_content content;
    SCOPED_VALUE(arena) arena = { 0 };
    c205_error error;
    const struct json_value *message, *success;
    int64_t number = -1;
    must(message_find(&whole, &content, &error) == MESSAGE_WHOLE);
    must(content.begin + content.length == length);
    message = json_read(&arena, bytes + content.begin, content.length, &error);
    must(json_member_whole(message, "seq", &number));
    must(number == ++talk->heard);
    success = json_member(message, "success");
    fuzz_accepted = fuzz_accepted || (success && success->truth);
}

/* Ignores the program that the client names, so that no file of the host is opened. */
static bool open_program(void *context UNUSED, const struct dap_program *program,
                         const struct sink *report, struct object **object,
                         c205_model **model)
{
    const struct asm_options options = { .defines = program->defines };
    SCOPED_VALUE(diagnostics) errors = { 0 };
    c205_error error;
    *object = assemble_text("fuzz.s", text, &options, &errors);
    diagnostics_put(&errors, report);
    if (*object)
        *model = c205_model_find(C205_DEFAULT_MODEL, &error);
    return *object && *model;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct talk talk = { .taken = 0 };
    struct dap_setup setup = { .read = give,
                               .ready = is_ready,
                               .open = open_program,
                               .context = &talk,
                               .out = { hear, &talk },
                               .program = "fuzz.s",
                               .folder = "/nowhere",
                               .clocks_most = 1000000 };
    c205_error error = { "" };
    say(&talk, data, size);
    must(dap_serve(&setup, &error) || *error.message);
    text_buffer_free(&talk.said);
    return 0;
}
