/* gnuplot.c - runs gnuplot as a process that draws a picture. */
#include "rt/study/plot/gnuplot.h"

#include <errno.h>
#include <string.h>

#include "vm/error.h"
#include "rt/platform/processes.h"

static bool fail(c205_error *error, const char *what, const char *why)
{
    return error_set(error, "%.60s: %.180s", what, why);
}

/* Copies the last line of gnuplot's messages to the error. Before it, gnuplot
 * prints the line of the script and a caret. */
static bool fail_with_output(FILE *messages, c205_error *error)
{
    char line[256], last[256] = "no picture was drawn";

    while (fgets(line, sizeof line, messages)) {
        line[strcspn(line, "\n")] = '\0';
        if (line[strspn(line, " \t^")] != '\0')
            strcpy(last, line);
    }
    return fail(error, "gnuplot", last);
}

bool gnuplot_draw(const char *folder, char *script, FILE *picture, c205_error *error)
{
    char *const words[] = { "gnuplot", "--default-settings", "-e", "piped = 1", script,
                            NULL };
    FILE *messages;
    size_t drawn;
    int code = process_run(folder, words, picture, &drawn, &messages);
    bool good = code == 0 && drawn > 0;

    if (code < 0)
        return fail(error, "gnuplot", strerror(errno));
    if (code == PROCESS_NOT_FOUND)
        fail(error, "gnuplot is not found", "install the Debian package gnuplot-nox");
    else if (!good)
        fail_with_output(messages, error);
    fclose(messages);
    return good;
}
