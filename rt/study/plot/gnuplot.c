/* gnuplot.c - see gnuplot.h. */
#include "rt/study/plot/gnuplot.h"

#include <errno.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

/* How a shell tells the same two. */
enum { CANNOT_RUN = 126, NOT_FOUND = 127 };

static bool fail(c205_error *error, const char *what, const char *why)
{
    snprintf(error->message, sizeof error->message, "%.60s: %.180s", what,
             why);
    return false;
}

/* In the new process, of which only the parent's descriptors are used. */
static void become_gnuplot(const char *folder, const char *script, int output,
                           int messages)
{
    if (chdir(folder) != 0 || dup2(output, STDOUT_FILENO) < 0
        || dup2(messages, STDERR_FILENO) < 0)
        _exit(CANNOT_RUN);
    execlp("gnuplot", "gnuplot", "--default-settings", "-e", "piped = 1",
           script, (char *)NULL);
    _exit(NOT_FOUND);
}

/* Its process, whose output can be read from *output; -1: errno tells. */
static pid_t start(const char *folder, const char *script, FILE *messages,
                   int *output)
{
    int ends[2];
    pid_t process;

    if (pipe(ends) != 0)
        return -1;
    process = fork();
    if (process == 0) {
        close(ends[0]);
        become_gnuplot(folder, script, ends[1], fileno(messages));
    }
    close(ends[1]);
    if (process < 0)
        close(ends[0]);
    *output = ends[0];
    return process;
}

/* How many bytes; whether all could be written, the file itself knows. */
static size_t copy(int from, FILE *to)
{
    char bytes[4096];
    ssize_t count;
    size_t copied = 0;

    while ((count = read(from, bytes, sizeof bytes)) != 0)
        if (count > 0)
            copied += fwrite(bytes, 1, (size_t)count, to);
        else if (errno != EINTR)
            break;
    close(from);
    return copied;
}

static int wait_for(pid_t process)
{
    int status = 0;

    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
            return CANNOT_RUN;
    return WIFEXITED(status) ? WEXITSTATUS(status) : CANNOT_RUN;
}

/* gnuplot prints the line of the script and a caret before what is wrong. */
static bool fail_as_told(FILE *messages, c205_error *error)
{
    char line[256], last[256] = "no picture was drawn";

    rewind(messages);
    while (fgets(line, sizeof line, messages)) {
        line[strcspn(line, "\n")] = '\0';
        if (line[strspn(line, " \t^")] != '\0')
            strcpy(last, line);
    }
    return fail(error, "gnuplot", last);
}

bool gnuplot_draw(const char *folder, const char *script, FILE *picture,
                  c205_error *error)
{
    FILE *messages = tmpfile();
    int output, code;
    size_t drawn;
    pid_t process = messages ? start(folder, script, messages, &output) : -1;
    bool good;

    if (process < 0) {
        fail(error, "gnuplot", strerror(errno));
        if (messages)
            fclose(messages);
        return false;
    }
    drawn = copy(output, picture);
    code = wait_for(process);
    good = code == 0 && drawn > 0;
    if (code == NOT_FOUND)
        fail(error, "gnuplot is not found",
             "the Debian package gnuplot-nox has it");
    else if (!good)
        fail_as_told(messages, error);
    fclose(messages);
    return good;
}
