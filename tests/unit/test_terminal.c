/* test_terminal.c - the reactions of a debugger at a terminal are compared with its
 * rules, with and without libedit. Ctrl-C stops the program or drops the typed line,
 * and has no other effect. SIGTERM and SIGHUP end the command. A dropped line that is
 * executed fails here. */
#define _XOPEN_SOURCE 700

#include "tests/unit/asm_helper.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/unit/draw.h"
#include "tests/unit/scene_reading.h"

enum { ROUNDS = 10, MAX_MILLISECONDS = 20000 };

/* An endless program, and a folder whose libedit cannot be opened. */
static char folder[] = "/tmp/terminal.XXXXXX", program[40], no_libedit[40];

struct terminal {
    int master;
    pid_t process;
    struct text_buffer said;
    size_t seen;    /* length of the output that was read */
    unsigned asked; /* number of questions; the answer to a question shows that all is
                     * done */
};

/* ---- A process at a terminal ----------------------------------------------- */

static void become(const char *name, bool libedit, char *const *words)
{
    const char *built = getenv("RT205_LIBDIR");
    signal(SIGHUP, SIG_DFL); /* nohup ignores it */
    if (setsid() < 0)
        _exit(127);
    int slave = open(name, O_RDWR);
    for (int i = 0; i < 3; i++)
        dup2(slave, i);
    setenv("TERM", "xterm", 1);
    if (!libedit)
        setenv("LD_LIBRARY_PATH", folder, 1);
    execv(formatted("%s/%s", built ? built : "build", words[0]), words);
    _exit(127);
}

static void begin(struct terminal *terminal, bool libedit, char *const *words)
{
    *terminal = (struct terminal){ .master = posix_openpt(O_RDWR | O_NOCTTY) };
    assert_true(terminal->master >= 0);
    assert_int_equal(grantpt(terminal->master), 0);
    assert_int_equal(unlockpt(terminal->master), 0);
    terminal->process = fork();
    assert_true(terminal->process >= 0);
    if (terminal->process == 0)
        become(ptsname(terminal->master), libedit, words);
}

static void type(struct terminal *terminal, const char *text)
{
    size_t length = strlen(text);
    assert_int_equal(write(terminal->master, text, length), length);
}

/* Reads output. Waits for at most `milliseconds`. Returns false if there was no output,
 * or if the process has ended. */
static bool listen_on(struct terminal *terminal, int milliseconds)
{
    struct pollfd input = { .fd = terminal->master, .events = POLLIN };
    struct sink sink = text_buffer_sink(&terminal->said);
    char bytes[1000];
    if (poll(&input, 1, milliseconds) <= 0)
        return false;
    ssize_t count = read(terminal->master, bytes, sizeof bytes);
    if (count > 0)
        sink.put(sink.context, bytes, (size_t)count);
    return count > 0;
}

static bool hears(struct terminal *terminal, const char *text, int milliseconds)
{
    const char *found = NULL;
    do
        found = terminal->said.text ? strstr(terminal->said.text + terminal->seen, text)
                                    : NULL;
    while (!found && listen_on(terminal, milliseconds));
    if (found)
        terminal->seen = (size_t)(found - terminal->said.text) + strlen(text);
    return found;
}

static void expect(struct terminal *terminal, const char *text)
{
    FAIL_IF(!hears(terminal, text, MAX_MILLISECONDS), "not '%s': %s", text,
            terminal->said.text);
}

/* Asks a question. Its answer shows that all earlier lines have been executed. */
static void ask(struct terminal *terminal)
{
    char line[80];
    snprintf(line, sizeof line, "print %u\n", 1000 + ++terminal->asked);
    type(terminal, line);
    snprintf(line, sizeof line, "%u  X'%X'", 1000 + terminal->asked,
             1000 + terminal->asked);
    expect(terminal, line);
}

static int end(struct terminal *terminal)
{
    int status = 0;
    while (listen_on(terminal, MAX_MILLISECONDS))
        continue;
    close(terminal->master);
    assert_int_equal(waitpid(terminal->process, &status, 0), terminal->process);
    text_buffer_free(&terminal->said);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

static void wait_a_moment(void)
{
    poll(NULL, 0, (int)below(20));
}

/* ---- Sessions --------------------------------------------------------------- */

static char *const debug_words[] = { "c205", "debug", program, NULL };
static char *const render_words[] = { "rt205", "render",  "scenes/first.pov",
                                      "-W",    "40",      "-H",
                                      "30",    "--debug", "20,15",
                                      NULL };

/* Types complete and incomplete lines with Ctrl-C at random positions. At the end the
 * first breakpoint must exist, which shows that no dropped line was executed. */
static void check_drops(struct terminal *terminal)
{
    static const char *const dropped[] = { "",     "delete",   "dele", "qu",
                                           "quit", "delete 1", "q",    "brea" };
    ask(terminal);
    type(terminal, "break insn EXIT\n");
    expect(terminal, "break 1: insn EXIT");
    for (size_t i = 0; i < ROUNDS; i++) {
        if (below(2))
            ask(terminal);
        wait_a_moment();
        type(terminal, dropped[below(COUNT(dropped))]);
        wait_a_moment();
        for (size_t n = below(3); n < 3; n++)
            type(terminal, "\003");
        wait_a_moment();
    }
    ask(terminal);
    type(terminal, "info breaks\n");
    expect(terminal, "1 break insn EXIT, hit 0 times");
}

/* Ctrl-C drops the line if it comes before the line is read. The line is then typed
 * again. */
static void check_program(struct terminal *terminal)
{
    for (size_t i = 0; i < 3; i++) {
        size_t tries = 0;
        do {
            type(terminal, "continue\n");
            poll(NULL, 0, 100);
            type(terminal, "\003");
        } while (!hears(terminal, "interrupted", 500) && ++tries < 40);
        assert_true(tries < 40);
        wait_a_moment();
        type(terminal, "\003\003");
    }
}

static void check_session(char *const *words, bool libedit)
{
    struct terminal terminal;
    begin(&terminal, libedit, words);
    check_drops(&terminal);
    if (words == debug_words)
        check_program(&terminal);
    type(&terminal, "# \303\251\377\003pri\t2 * 21\n");
    expect(&terminal, "42  X'2A'");
    type(&terminal, "quit\n");
    assert_int_equal(end(&terminal), 0);
}

TEST(ctrl_c)
{
    for (int i = 0; i < 4; i++)
        check_session(i < 2 ? debug_words : render_words, i % 2 == 0);
}

/* SIGTERM and SIGHUP end the command at the prompt, in the middle of a line, and while
 * the program runs. */
TEST(ends)
{
    static const char *const typed[] = { "", "print", "continue\n" };
    static const int signals[] = { SIGTERM, SIGHUP };
    for (size_t i = 0; i < 12; i++) {
        struct terminal terminal;
        begin(&terminal, i % 2 == 0, debug_words);
        ask(&terminal);
        type(&terminal, typed[i / 4]);
        poll(NULL, 0, 100);
        kill(terminal.process, signals[i / 2 % 2]);
        FAIL_IF(end(&terminal) != 1, "typed '%s', signal %d", typed[i / 4],
                signals[i / 2 % 2]);
    }
}

/* ---- The folder -------------------------------------------------------------- */

FIXTURE(make_folder)
{
    static const char text[] = "loop:   BIM loop\n        EXIT\n";
    if (!mkdtemp(folder))
        return -1;
    snprintf(no_libedit, sizeof no_libedit, "%s/libedit.so.2", folder);
    write_bytes(no_libedit, "", 0);
    snprintf(program, sizeof program, "%s/p.s", folder);
    write_bytes(program, text, strlen(text));
    return 0;
}

FIXTURE(remove_folder)
{
    unlink(no_libedit);
    unlink(program);
    return rmdir(folder);
}

GROUP(make_folder, remove_folder);
