/* test_command.c - the values that commands receive from random command lines, in any
 * order and form, are compared with the values on the lines. Messages about wrong words
 * are compared with expected messages, and suggestions for misspelt names with the
 * original names. A value that goes to another row, or a wrong value that is accepted,
 * fails here. */
#include <unistd.h>

#include "base/command.h"
#include "base/spelling.h"
#include "base/progress.h"
#include "tests/random.h"
#include "tests/unit/unit.h"

enum colour { RED, GREEN, NO_COLOUR, BLUE };

struct arguments {
    const char *command;
    bool loud;
    const char *text, *input, *output, *kept, *folder;
    size_t count;
    uint64_t clocks, end;
    double number;
    enum colour colour;
    size_t length; /* length of the text that `take` received */
    struct command_texts words, files;
    const char *first;
    struct arguments *result; /* where to record the values; NULL: nowhere */
};

static const char *colour_choice(size_t number)
{
    static const char *const names[] = { "red", "green", "", "blue" };
    return number < 4 ? names[number] : NULL;
}

static bool take_length(char *text, void *value)
{
    size_t length = strlen(text);
    memcpy(value, &length, sizeof length);
    return length < 9;
}

#define PLACE(member) offsetof(struct arguments, member)

#define OPTION(option, type, member, ...) \
    { \
        .name = option, .kind = COMMAND_##type, .offset = PLACE(member), \
        .help = "a value", __VA_ARGS__ \
    }
static const struct command_option options[] = {
    OPTION("loud", FLAG, loud, .letter = 'l'),
    OPTION("text", TEXT, text, .letter = 't', .value = "TEXT", .preset_text = "usual"),
    OPTION("input", INPUT, input, .value = "FILE"),
    OPTION("output", OUTPUT, output, .letter = 'o', .value = "FILE"),
    OPTION("kept", FILE, kept, .value = "FILE"),
    OPTION("folder", FOLDER, folder, .value = "DIR"),
    OPTION("count", COUNT, count, .letter = 'c', .value = "N", .least = 3, .most = 1000,
           .preset = 77),
    OPTION("clocks", CLOCKS, clocks, .value = "N", .preset = 205),
    OPTION("end", CLOCKS, end, .value = "N", .preset = -1),
    OPTION("number", NUMBER, number, .value = "X", .least = -2, .most = 2,
           .preset = 0.5),
    OPTION("colour", CHOICE, colour, .value = "COLOUR", .choice = colour_choice,
           .preset = GREEN),
    OPTION("own", CUSTOM, length, .value = "TEXT", .take = take_length,
           .wants = "eight letters"),
    OPTION("word", TEXT, words, .letter = 'w', .value = "WORD", .many = true),
    COMMAND_END
};
/* clang-format off */
static const struct command_option operands[] = {
    { .value = "FIRST", .kind = COMMAND_TEXT, .offset = PLACE(first),
      .help = "a text" },
    { .value = "FILE", .kind = COMMAND_INPUT, .many = true, .optional = true,
      .offset = PLACE(files), .help = "files" },
    COMMAND_END
};
/* clang-format on */

/* The values that the command received, as text that can be compared. */
static char seen[4096];

static void describe(const struct arguments *a, char text[4096])
{
    int length = snprintf(text, 4096, "%d|%s|%s|%s|%s|%s|%zu|%llu|%llu|%g|%d|%zu|%s",
                          a->loud, a->text ? a->text : "", a->input ? a->input : "",
                          a->output ? a->output : "", a->kept ? a->kept : "",
                          a->folder ? a->folder : "", a->count,
                          (unsigned long long)a->clocks, (unsigned long long)a->end,
                          a->number, (int)a->colour, a->length, a->first);
    for (size_t i = 0; i < a->words.count; i++)
        length += snprintf(text + length, 4096 - (size_t)length, "|%s",
                           a->words.items[i]);
    for (size_t i = 0; i < a->files.count; i++)
        length += snprintf(text + length, 4096 - (size_t)length, "#%s",
                           a->files.items[i]);
}

static int look(void *arguments)
{
    describe(arguments, seen);
    return CMD_DONE;
}

static int run(int argc, char **argv)
{
    static const struct command look_command = { .name = "look",
                                                 .summary = "look",
                                                 .function = look,
                                                 .arguments_size = sizeof(
                                                     struct arguments),
                                                 .options = options,
                                                 .operands = operands };
    static const struct command other_command = { .name = "other",
                                                  .summary = "another",
                                                  .function = look,
                                                  .arguments_size = sizeof(
                                                      struct arguments) };
    static const struct command *const commands[] = { &look_command, &other_command,
                                                      NULL };
    static const struct command_program program = {
        .name = "test",
        .summary = "a test",
        .version = "1",
        .commands = commands,
    };
    seen[0] = '\0';
    return command_main(&program, argc, argv);
}

/* ---- Accepted texts ------------------------------------------------------ */

enum { MAX_WORDS = 64, WORD_SIZE = 40 };

/* A command line under construction, and the expected values. */
struct line {
    uint64_t random;
    char words[MAX_WORDS][WORD_SIZE];
    char *argv[MAX_WORDS + 1];
    int argc;
    struct arguments expected;
    const char *texts[2][MAX_WORDS]; /* texts for words and files */
};

static size_t below(struct line *line, size_t most)
{
    return (size_t)xorshift_between(&line->random, 0, (int64_t)most - 1);
}

static char *add(struct line *line)
{
    char *word = line->words[line->argc];
    line->argv[line->argc++] = word;
    line->argv[line->argc] = NULL;
    return word;
}

static void make_word(struct line *line, char text[WORD_SIZE])
{
    size_t length = 5 + below(line, 4);
    for (size_t i = 0; i < length; i++)
        text[i] = (char)('a' + below(line, 26));
    text[length] = '\0';
}

/* Makes a random value of a row as text, and adds it to the expected values. */
static const char *make_value(struct line *line, const struct command_option *option,
                              char text[WORD_SIZE])
{
    struct arguments *expected = &line->expected;
    static const enum colour colours[] = { RED, GREEN, BLUE };
    uint64_t clocks;
    make_word(line, text);
    switch (option->kind) {
    case COMMAND_COUNT:
        expected->count = 3 + below(line, 998);
        snprintf(text, WORD_SIZE, "%zu", expected->count);
        break;
    case COMMAND_CLOCKS:
        clocks = xorshift(&line->random);
        memcpy((char *)expected + option->offset, &clocks, sizeof clocks);
        snprintf(text, WORD_SIZE, "%llu", (unsigned long long)clocks);
        break;
    case COMMAND_NUMBER:
        expected->number = (double)below(line, 3999) / 1000 - 1.999;
        snprintf(text, WORD_SIZE, "%.17g", expected->number);
        break;
    case COMMAND_CHOICE:
        expected->colour = colours[below(line, 3)];
        snprintf(text, WORD_SIZE, "%s", colour_choice(expected->colour));
        break;
    case COMMAND_CUSTOM: expected->length = strlen(text); break;
    default: return text;
    }
    return NULL;
}

/* Adds "--name value", "--name=value", "-l value" or "-lvalue", perhaps abbreviated. */
static void add_option(struct line *line, const struct command_option *option)
{
    char value[WORD_SIZE];
    bool is_text = make_value(line, option, value) != NULL;
    bool flag = option->kind == COMMAND_FLAG;
    bool apart = flag || below(line, 2);
    struct arguments *expected = &line->expected;
    char *word = add(line), *place;
    int length;
    if (option->letter && below(line, 2))
        length = snprintf(word, WORD_SIZE, "-%c", option->letter);
    else
        length = snprintf(word, WORD_SIZE, "--%s%s", option->name, apart ? "" : "=");
    if (flag) {
        expected->loud = true;
        return;
    }
    place = apart ? add(line) : word + length;
    snprintf(place, (size_t)(WORD_SIZE - length), "%s", value);
    if (is_text && option->many)
        expected->words.items[expected->words.count++] = place;
    else if (is_text)
        memcpy((char *)expected + option->offset, &place, sizeof place);
}

static void begin(struct line *line, uint64_t seed)
{
    *line = (struct line){ .random = seed,
                           .expected = { .text = "usual",
                                         .count = 77,
                                         .clocks = 205,
                                         .end = UINT64_MAX,
                                         .number = .5,
                                         .colour = GREEN,
                                         .words = { .items = line->texts[0] },
                                         .files = { .items = line->texts[1] } } };
    strcpy(add(line), "test");
    strcpy(add(line), "look");
}

static void add_operands(struct line *line, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct command_texts *files = &line->expected.files;
        char *word = add(line);
        make_word(line, word);
        if (!line->expected.first)
            line->expected.first = word;
        else
            files->items[files->count++] = word;
    }
}

TEST(right_lines)
{
    for (uint64_t seed = 1; seed <= 3000; seed++) {
        struct line line;
        char expected[4096];
        begin(&line, seed * RANDOM_SEED);
        add_operands(&line, 1);
        for (size_t i = below(&line, 12); i > 0; i--) {
            add_option(&line, &options[below(&line, COUNT(options) - 1)]);
            add_operands(&line, below(&line, 3) == 0);
        }
        describe(&line.expected, expected);
        assert_int_equal(run(line.argc, line.argv), CMD_DONE);
        assert_string_equal(seen, expected);
    }
}

/* ---- Rejected texts ------------------------------------------------------ */

/* Captures the text that is printed on stderr. */
struct caught {
    int before;
    FILE *file;
    char text[8192];
};

static void catch (struct caught *caught)
{
    fflush(stderr);
    caught->before = dup(STDERR_FILENO);
    caught->file = NON_NULL(tmpfile());
    dup2(fileno(caught->file), STDERR_FILENO);
}

static void release(struct caught *caught)
{
    fflush(stderr);
    dup2(caught->before, STDERR_FILENO);
    close(caught->before);
    rewind(caught->file);
    size_t length = fread(caught->text, 1, sizeof caught->text - 1, caught->file);
    caught->text[length] = '\0';
    fclose(caught->file);
}

/* A correct line with these words added must be rejected with the message `why`. */
static void refused(const char *word, const char *value, const char *why)
{
    for (uint64_t seed = 1; seed <= 20; seed++) {
        struct line line;
        struct caught caught;
        begin(&line, seed * RANDOM_SEED);
        if (below(&line, 2))
            add_option(&line, &options[0]);
        snprintf(add(&line), WORD_SIZE, "%s", word);
        if (value)
            snprintf(add(&line), WORD_SIZE, "%s", value);
        if (below(&line, 2))
            add_option(&line, &options[1]);
        add_operands(&line, 1);
        catch (&caught);
        int code = run(line.argc, line.argv);
        release(&caught);
        assert_int_equal(code, CMD_USAGE);
        assert_string_equal(seen, "");
        FAIL_IF(!strstr(caught.text, why), "%s %s: '%s' does not tell '%s'", word,
                value ? value : "", caught.text, why);
    }
}

TEST(wrong_lines)
{
    refused("--count", "2",
            "--count: expected a whole number from 3 to 1000, found '2'");
    refused("--count", "1001", "found '1001'");
    refused("--count", "-5", "found '-5'");
    refused("--count", "5x", "found '5x'");
    refused("-c", "", "found ''");
    refused("--count=99999999999999999999", NULL, "found '99999999999999999999'");
    refused("--clocks", "18446744073709551616", "found '18446744073709551616'");
    refused("--clocks", "-1", "found '-1'");
    refused("--number", "2", "a number above -2 and below 2");
    refused("--number", "-2", "found '-2'");
    refused("--number", "nan", "found 'nan'");
    refused("--number", "1,5", "found '1,5'");
    refused("--colour", "black", "expected red, green or blue, found");
    refused("--colour", "", "found ''");
    refused("--own", "ninechars", "expected eight letters, found");
    refused("--kept", "-", "expected the name of a file, found");
    refused("--text", "", "found ''");
    refused("--loud=yes", NULL, "--loud takes no argument");
    refused("--lodu", NULL, "unknown option --lodu; did you mean --loud?");
    refused("--colr=red", NULL, "did you mean --colour?");
    refused("--co", "red", "--co is ambiguous: --count, --colour");
    refused("-x", NULL, "unknown option -x");
    refused("-lx", NULL, "unknown option -x");
    refused("--output=a", "--kept=./a",
            "--output and --kept cannot write the same file");
}

/* Runs a line of words, which end with NULL. Returns its exit code. */
static int run_words(const char *first, ...)
{
    struct line line = { .argc = 0 };
    va_list words;
    strcpy(add(&line), "test");
    va_start(words, first);
    for (const char *word = first; word; word = va_arg(words, const char *))
        strcpy(add(&line), word);
    va_end(words);
    return run(line.argc, line.argv);
}

/* The minimum and the maximum of a count are accepted. */
TEST(bounds)
{
    assert_int_equal(run_words("look", "--count=3", "first", NULL), CMD_DONE);
    assert_non_null(strstr(seen, "|3|"));
    assert_int_equal(run_words("look", "--count=1000", "first", NULL), CMD_DONE);
    assert_non_null(strstr(seen, "|1000|"));
}

TEST(missing_and_too_many)
{
    struct caught caught;
    catch (&caught);
    assert_int_equal(run_words("look", NULL), CMD_USAGE);
    assert_int_equal(run_words("other", "look", NULL), CMD_USAGE);
    assert_int_equal(run_words("lok", NULL), CMD_USAGE);
    assert_int_equal(run_words("xh", NULL), CMD_USAGE);
    assert_int_equal(run_words("look", "--input=-", "other", "-", NULL), CMD_USAGE);
    release(&caught);
    assert_non_null(strstr(caught.text, "test look: FIRST is missing: a text"));
    assert_non_null(strstr(caught.text, "too many arguments: look"));
    assert_non_null(strstr(caught.text, "unknown command 'lok'; did you mean 'look'?"));
    assert_non_null(strstr(caught.text, "only one file can be - (stdin)"));
}

/* ---- Names, times -------------------------------------------------------- */

/* A name with a letter dropped, doubled, replaced or swapped with the next letter is
 * found. A completely different name is not found. */
TEST(nearest)
{
    static const char *const names[] = { "render", "profile", "speedup", "sweep",
                                         "quartic" };
    uint64_t random = RANDOM_SEED;
    for (int i = 0; i < 2000; i++) {
        const char *name = names[xorshift_between(&random, 0, 4)];
        size_t length = strlen(name);
        size_t at = (size_t)xorshift_between(&random, 0, (int64_t)length - 2);
        char word[16];
        struct spelling nearest = { .word = word };
        strcpy(word, name);
        switch (xorshift_between(&random, 0, 3)) {
        case 0: memmove(word + at, name + at + 1, length - at); break;
        case 1: memmove(word + at + 1, name + at, length - at + 1); break;
        case 2: word[at] = 'x'; break;
        default: word[at] = name[at + 1], word[at + 1] = name[at];
        }
        for (int k = 0; k < 5; k++)
            spelling_try(&nearest, names[k]);
        assert_ptr_equal(nearest.name, name);
    }
    struct spelling swapped = { .word = "rnu" };
    spelling_try(&swapped, "run");
    assert_string_equal(swapped.name, "run");
    struct spelling nothing = { .word = "fit" };
    spelling_try(&nothing, "quartic");
    spelling_try(&nothing, "run");
    spelling_try(&nothing, "a name of more than forty letters is near nobody");
    assert_null(nothing.name);
}

TEST(time_left)
{
    static const struct {
        double seconds;
        const char *text;
    } cases[] = { { 59.4, "59 s" },
                  { 59.6, "1 min 0 s" },
                  { 3599, "59 min 59 s" },
                  { 7290, "2 h 1 min" } };
    for (size_t i = 0; i < COUNT(cases); i++) {
        char text[PROGRESS_TIME_SIZE];
        progress_time(cases[i].seconds, text);
        assert_string_equal(text, cases[i].text);
    }
}

/* The line is shown after the first second, and erased at the end. An hour has passed
 * for 40 of 100 items, so that delays of the host do not change the text. */
TEST(progress_line)
{
    char text[100] = "", expected[100];
    FILE *file = tmpfile();
    struct progress progress;
    progress_begin(&progress);
    progress.file = file;
    progress_update(&progress, 10, 100);
    progress.begin.tv_sec += 100;
    progress.shown.tv_sec -= 100;
    progress_update(&progress, 20, 100);
    assert_int_equal(ftell(file), 0);
    progress.begin.tv_sec -= 100 + 3632;
    progress_update(&progress, 50, 100);
    progress.shown.tv_sec += 100;
    progress_update(&progress, 60, 100);
    progress_update(&progress, 100, 100);
    rewind(file);
    assert_true(fread(text, 1, sizeof text - 1, file) > 0);
    fclose(file);
    snprintf(expected, sizeof expected, "\r 50 %% done, 1 h 15 min left   \r%40s\r",
             "");
    assert_string_equal(text, expected);
}
