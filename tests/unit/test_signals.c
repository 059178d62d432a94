/* test_signals.c - files after signals at random times, to every command that writes,
 * are compared with the old file and with the complete new file. A file that is
 * incomplete, a temporary file that is left, or an interrupted command that succeeds,
 * fails here. */
#define _XOPEN_SOURCE 700

#include "tests/unit/asm_helper.h"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/random.h"
#include "tests/unit/scene_reading.h"

enum { WORDS = 20, PATH = 100, TEXT = 4096 };
static size_t rounds = 1;
static uint64_t random_state = RANDOM_SEED;

static int below(int end)
{
    return (int)(xorshift(&random_state) % (uint64_t)end);
}

static char folder[] = "/tmp/signals.XXXXXX";

/* Input files. A word "%name" is a file in the folder. */
static const struct {
    const char *name, *text;
} inputs[] = {
    { "endless.s", "loop:   BIM loop\n        EXIT\n" },
    { "bay.pov", "camera { location -5*z look_at 0 }\n"
                 "cylinder { 0, .7*y, 1 open }\n"
                 "disc { 0, y, 1.8, 1 } disc { .7*y, -y, 1.8, 1 }\n" },
};
enum { INPUTS = COUNT(inputs) };

static const char *const commands[][WORDS] = {
    { "c205", "asm", "asm/examples/sieve.s", "-o", "%o" },
    { "c205", "run", "asm/examples/sieve.s", "--json", "%json" },
    { "c205", "run", "%endless.s", "--no-limit", "--json", "%json" },
    { "c205", "run", "%endless.s", "--limit", "900000000000", "--save", "%state" },
    { "c205", "compare", "asm/examples/saxpy_scalar.s", "asm/examples/saxpy_vector.s",
      "--json", "%json" },
    { "c205", "timeline", "asm/examples/dot.s", "-o", "%svg.svg" },
    { "c205", "sweep", "asm/examples/sieve.s", "--define", "limit=10:300:1", "-o",
      "%svg.svg", "--json", "%json" },
    { "c205", "time", "--json", "%json" },
    { "c205", "model", "--json", "%json" },
    { "c205", "isa", "--json", "%json" },
    { "c205", "check", "1", "--start", "-o", "%started.s" },
    { "c205", "check", "1", "%endless.s", "--json", "%json" },
    { "rt205", "render", "scenes/first.pov", "-W", "80", "-H", "60", "-o", "%png.png",
      "--json", "%json" },
    { "rt205", "render", "scenes/first.pov", "-W", "800", "-H", "600", "--mode",
      "scalar", "-o", "%png.png", "--resume", "%kept" },
    { "rt205", "profile", "scenes/first.pov", "-W", "40", "-H", "30", "--json",
      "%json" },
    { "rt205", "sweep", "queue", "sphere", "-W", "32", "-H", "32", "--json", "%json" },
    { "rt205", "speedup", "--json", "%json" },
    { "rt205", "heat", "%bay.pov", "--rays", "64", "--exchange", "--temperature",
      "default=300", "--json", "%json", "-o", "%png.png" },
    { "rt205", "mass", "scenes/piston.pov", "--json", "%json" },
    { "rt205", "timeline", "scenes/first.pov", "-o", "%svg.svg" },
};
enum { COMMANDS = COUNT(commands) };

static const int signals[] = { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGPIPE };

/* ---- Processes --------------------------------------------------------------- */

static void path_of(char path[PATH], const char *name)
{
    snprintf(path, PATH, "%s/%s", folder, name);
}

/* Executes the command with the default signal actions. Discards stderr. */
static void become(const char *const *given, int in, int out)
{
    const char *built = getenv("RT205_LIBDIR");
    char paths[WORDS][PATH], command[1000], *words[WORDS + 1] = { NULL };
    for (size_t i = 0; given[i]; i++) {
        snprintf(paths[i], PATH, "%s", given[i]);
        if (*given[i] == '%')
            path_of(paths[i], given[i] + 1);
        words[i] = paths[i];
    }
    for (int number = 1; number < 32; number++)
        signal(number, SIG_DFL);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    freopen("/dev/null", "w", stderr);
    snprintf(command, sizeof command, "%s/%s", built ? built : "build", words[0]);
    execv(command, words);
    _exit(127);
}

static pid_t begin(const char *const *words, int in, int out)
{
    pid_t process = fork();
    assert_true(process >= 0);
    if (process == 0)
        become(words, in, out);
    return process;
}

/* Returns the exit status, or the negative number of the signal. */
static int end(pid_t process)
{
    int status = 0;
    assert_int_equal(waitpid(process, &status, 0), process);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

static void wait_for(int milliseconds)
{
    poll(NULL, 0, milliseconds);
}

/* ---- Files -------------------------------------------------------------------- */

static void write_file(const char *name, const char *text)
{
    char path[PATH];
    path_of(path, name);
    write_bytes(path, text, strlen(text));
}

static size_t read_file(const char *name, char text[TEXT])
{
    char path[PATH];
    path_of(path, name);
    FILE *file = NON_NULL(fopen(path, "r"));
    size_t length = fread(text, 1, TEXT - 1, file);
    fseek(file, length < TEXT - 1 ? 0 : -16, SEEK_END);
    if (length == TEXT - 1)
        length = fread(text, 1, 16, file);
    fclose(file);
    text[length] = '\0';
    return length;
}

static const char old[] = "the old file\n";

/* Returns the end of a complete file with this name, or "" for any end. */
static const char *ending_of(const char *name)
{
    return strcmp(name, "json") == 0      ? "}\n"
           : strcmp(name, "svg.svg") == 0 ? "</svg>\n"
           : strcmp(name, "png.png") == 0 ? "IEND\xAE\x42\x60\x82"
                                          : "";
}

static void check_file(const char *name, const char *command, int number)
{
    char text[TEXT];
    size_t length = read_file(name, text), wanted = strlen(ending_of(name));
    FAIL_IF(strcmp(text, old) != 0
                && (length < 2 || length < wanted
                    || memcmp(text + length - wanted, ending_of(name), wanted) != 0),
            "%s, signal %d: %s is no whole file", command, number, name);
}

static bool is_input(const char *name)
{
    for (size_t i = 0; i < INPUTS; i++)
        if (strcmp(name, inputs[i].name) == 0)
            return true;
    return false;
}

/* The folder must contain only the named files. */
static void check_folder(const char *const *words, int number)
{
    DIR *directory = NON_NULL(opendir(folder));
    struct dirent *entry;
    char command[100];
    snprintf(command, sizeof command, "%s %s", words[0], words[1]);
    while ((entry = readdir(directory))) {
        size_t i = 0;
        if (*entry->d_name == '.' || is_input(entry->d_name))
            continue;
        while (words[i]
               && !(*words[i] == '%' && strcmp(words[i] + 1, entry->d_name) == 0))
            i++;
        FAIL_IF(!words[i], "%s, signal %d: leaves %s", command, number, entry->d_name);
        if (strcmp(entry->d_name, "kept") != 0)
            check_file(entry->d_name, command, number);
    }
    closedir(directory);
}

static void remove_files(void)
{
    DIR *directory = opendir(folder);
    struct dirent *entry;
    while (directory && (entry = readdir(directory))) {
        const char *path = formatted("%s/%s", folder, entry->d_name);
        if (*entry->d_name != '.' && !is_input(entry->d_name))
            unlink(path);
    }
    closedir(directory);
}

/* ---- Commands that write --------------------------------------------------------- */

/* Writes old versions of all output files. */
static void write_old_files(const char *const *words)
{
    for (size_t i = 0; words[i]; i++)
        if (*words[i] == '%' && !is_input(words[i] + 1)
            && strcmp(words[i], "%kept") != 0)
            write_file(words[i] + 1, old);
}

/* Commands begin work after some milliseconds. A second signal ends a running one. */
static void check_command(const char *const *words, int number)
{
    int null = open("/dev/null", O_RDWR), status;
    int delay = below(2) ? below(30) : below(300);
    remove_files();
    if (below(2))
        write_old_files(words);
    pid_t process = begin(words, null, null);
    wait_for(delay);
    kill(process, number);
    wait_for(below(100));
    kill(process, number);
    status = end(process);
    close(null);
    FAIL_IF(status != 0 && status != 1 && status != -number,
            "%s %s, signal %d: ends with %d", words[0], words[1], number, status);
    check_folder(words, number);
}

TEST(commands)
{
    for (size_t round = 0; round < rounds; round++)
        for (size_t i = 0; i < COMMANDS; i++)
            check_command(commands[i], signals[below((int)(COUNT(signals)))]);
}

/* nohup makes a command ignore SIGHUP. */
TEST(nohup)
{
    const char *command = formatted("trap '' HUP; \"${RT205_LIBDIR:-build}/c205\" run "
                                    "asm/examples/sieve.s --json %s/json >/dev/null & "
                                    "kill -HUP $!; wait $!",
                                    folder);
    assert_int_equal(system(command), 0);
}

/* ---- Scripts --------------------------------------------------------------------- */

static const char *const debug_words[] = { "c205", "debug", "%endless.s", NULL };
static const char *const script_words[] = { "c205",   "debug",      "-x",
                                            "%lines", "%endless.s", NULL };
static const char *const render_words[] = {
    "rt205",  "render", "scenes/first.pov", "-W",      "400", "-H",     "300",
    "--mode", "scalar", "--debug",          "200,150", "-x",  "%lines", NULL
};

/* Runs a script from a file or an open pipe. Stores its output in `said`. */
static int run_script(const char *const *words, const char *lines, int number,
                      char said[TEXT])
{
    int to[2], from[2], status;
    size_t length = 0;
    ssize_t count;
    write_file("lines", lines);
    assert_int_equal(pipe(to), 0);
    assert_int_equal(pipe(from), 0);
    for (int i = 0; i < 2; i++) {
        fcntl(to[i], F_SETFD, FD_CLOEXEC);
        fcntl(from[i], F_SETFD, FD_CLOEXEC);
    }
    pid_t process = begin(words, to[0], from[1]);
    close(to[0]);
    close(from[1]);
    if (words == debug_words)
        assert_int_equal(write(to[1], lines, strlen(lines)), strlen(lines));
    /* The debugger is ready when it prints its prompt. */
    said[0] = '\0';
    while (!strstr(said, "=>") && length < TEXT - 1
           && (count = read(from[0], said + length, TEXT - 1 - length)) > 0)
        said[length += (size_t)count] = '\0';
    wait_for(20 + below(200));
    kill(process, number);
    if (number == SIGINT) {
        wait_for(300);
        close(to[1]);
    }
    while (length < TEXT - 1
           && (count = read(from[0], said + length, TEXT - 1 - length)) > 0)
        said[length += (size_t)count] = '\0';
    status = end(process);
    if (number != SIGINT)
        close(to[1]);
    close(from[0]);
    return status;
}

/* SIGTERM and SIGHUP end the command, Ctrl-C a movement. The status is never 0. */
TEST(scripts)
{
    static const char lines[] = "continue\nprint 6 * 7\n";
    static const int ends[] = { SIGTERM, SIGHUP };
    char said[TEXT];
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(run_script(script_words, lines, ends[i], said), 1);
        assert_null(strstr(said, "42  X'2A'"));
        assert_int_equal(run_script(debug_words, lines, ends[i], said), 1);
        assert_null(strstr(said, "42  X'2A'"));
        assert_int_equal(run_script(debug_words, "", ends[i], said), 1);
    }
    assert_int_equal(run_script(script_words, lines, SIGINT, said), 1);
    assert_non_null(strstr(said, "42  X'2A'"));
    assert_int_equal(run_script(debug_words, lines, SIGINT, said), 1);
    assert_non_null(strstr(said, "42  X'2A'"));
    assert_int_equal(run_script(render_words, "goto 100000000\n", SIGTERM, said), 1);
    remove_files();
}

FIXTURE(make_folder)
{
    if (!mkdtemp(folder))
        return -1;
    for (size_t i = 0; i < INPUTS; i++)
        write_file(inputs[i].name, inputs[i].text);
    return 0;
}

FIXTURE(remove_folder)
{
    char path[PATH];
    remove_files();
    for (size_t i = 0; i < INPUTS; i++) {
        path_of(path, inputs[i].name);
        unlink(path);
    }
    return rmdir(folder);
}

ARGUMENTS(count, words)
{
    const char *wanted = getenv("SIGNALS");
    (void)count, (void)words;
    if (wanted)
        rounds = (size_t)strtoul(wanted, NULL, 10);
}

GROUP(make_folder, remove_folder);
