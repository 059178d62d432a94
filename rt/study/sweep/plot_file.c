/* plot_file.c - writes a plot to a file. */
#include "rt/study/sweep/plot_file.h"

#include <errno.h>
#include <string.h>

#include "base/atomic_file.h"
#include "base/file.h"
#include "rt/platform/processes.h"
#include "vm/error.h"

enum { ENDING = 4 }; /* length of ".svg" and ".png" in bytes */

static bool is_png(const char *path)
{
    return file_ends_with(path, ".png");
}

bool plot_is_named(const char *path)
{
    return file_ends_with(path, ".svg") || is_png(path);
}

bool plot_svg_path(const char *path, char svg[PLOT_PATH])
{
    int stem = (int)strlen(path) - ENDING;
    return snprintf(svg, PLOT_PATH, "%.*s.svg", stem, path) < PLOT_PATH;
}

bool plot_check_path(const char *path, c205_error *error)
{
    char svg[PLOT_PATH];
    if (!plot_is_named(path))
        return error_set(error, "%.180s: the name of a plot must end in .svg or .png",
                         path);
    if (!plot_svg_path(path, svg))
        return error_set(error, "%.180s: %s", path, strerror(ENAMETOOLONG));
    return atomic_file_check(svg, error) && atomic_file_check(path, error);
}

/* Commits the file if `good` is true; otherwise discards it. Returns true if the file
 * has been written. */
static bool end_plot(struct atomic_file *whole, bool good, c205_error *error)
{
    if (good)
        return atomic_file_commit(whole, error);
    atomic_file_discard(whole);
    return false;
}

static bool write_svg(const struct plot *plot, const struct table *table,
                      const char *path, c205_error *error)
{
    struct atomic_file *whole = atomic_file_open(path, error);
    struct sink sink;
    if (!whole)
        return false;
    sink = stream_sink(whole->file);
    return end_plot(whole, plot_draw(plot, table, &sink, error), error);
}

/* Runs the converter. The error is the last message of the converter. */
static bool convert(const char *svg, FILE *png, c205_error *error)
{
    char path[PLOT_PATH + 2], line[180], last[180] = "no picture was written";
    char *const words[] = { "rsvg-convert", path, NULL };
    FILE *messages;
    size_t written;
    int code;

    /* the name must not look like an option */
    snprintf(path, sizeof path, "%s%s", *svg == '/' ? "" : "./", svg);
    code = process_run(".", words, png, &written, &messages);
    if (code < 0)
        return error_set(error, "rsvg-convert: %s", strerror(errno));
    while (fgets(line, sizeof line, messages))
        snprintf(last, sizeof last, "%.*s", (int)strcspn(line, "\n"), line);
    fclose(messages);
    if (code == PROCESS_NOT_FOUND)
        return error_set(error, "rsvg-convert is not found: install the Debian package "
                                "librsvg2-bin");
    return (code == 0 && written > 0) || error_set(error, "rsvg-convert: %s", last);
}

/* Opens the .png before it writes the .svg, so that if one of them cannot be written,
 * neither is. */
static bool write_both(const struct plot *plot, const struct table *table,
                       const char *svg, const char *png, c205_error *error)
{
    struct atomic_file *whole = atomic_file_open(png, error);
    return whole
           && end_plot(whole,
                       write_svg(plot, table, svg, error)
                           && convert(svg, whole->file, error),
                       error);
}

bool plot_write(const struct plot *plot, const struct table *table, const char *path,
                c205_error *error)
{
    char svg[PLOT_PATH];
    if (!plot_check_path(path, error) || !plot_svg_path(path, svg))
        return false;
    return is_png(path) ? write_both(plot, table, svg, path, error)
                        : write_svg(plot, table, svg, error);
}
