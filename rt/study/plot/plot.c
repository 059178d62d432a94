/* plot.c - writes the three files of a plot. */
#include "rt/study/plot/plot.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "vm/error.h"
#include "base/atomic_file.h"
#include "rt/study/plot/gnuplot.h"
#include "rt/study/plot/script.h"

static const char *const endings[] = { ".svg", ".png" };
enum { ENDING = 4 }; /* bytes of each */

/* ---- Files ---------------------------------------------------------------- */

struct files {
    char *folder, *name, *script_name;
    struct atomic_file *data, *script, *picture;
};

/* Returns an allocated text, or NULL if out of memory. */
static char *text_of(const char *format, ...)
{
    va_list arguments;
    char *text;
    int length;

    va_start(arguments, format);
    length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    text = length < 0 ? NULL : malloc((size_t)length + 1);
    if (text) {
        va_start(arguments, format);
        vsnprintf(text, (size_t)length + 1, format, arguments);
        va_end(arguments);
    }
    return text;
}

static const char *name_in(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

/* Returns the folder with its slash, or ".". */
static char *folder_of(const char *path)
{
    int length = (int)(name_in(path) - path);

    return text_of("%.*s", length ? length : 1, length ? path : ".");
}

static bool check_folder(const char *path, c205_error *error)
{
    char *folder = folder_of(path);
    int code = 0;

    if (!folder)
        code = ENOMEM;
    else if (access(folder, W_OK | X_OK) != 0)
        code = errno;
    free(folder);
    return code == 0 || error_set(error, "%.180s: %.60s", path, strerror(code));
}

bool plot_is_named(const char *path)
{
    const char *name = name_in(path);
    size_t length = strlen(name);

    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
        if (length > ENDING && strcmp(name + length - ENDING, endings[i]) == 0)
            return true;
    return false;
}

bool plot_check_path(const char *path, c205_error *error)
{
    const char *name = name_in(path);

    if (!plot_is_named(path))
        return error_set(error, "%.180s: the name of a plot must end in .svg or .png",
                         path);
    for (const char *c = name; *c != '\0'; c++)
        if ((unsigned char)*c < ' ')
            return error_set(error, "the name of a plot must be one line of text");
    return check_folder(path, error);
}

static struct atomic_file *open_beside(const char *path, const char *end,
                                       c205_error *error)
{
    char *beside = text_of("%.*s%s", (int)strlen(path) - ENDING, path, end);
    struct atomic_file *whole = beside ? atomic_file_open(beside, error) : NULL;

    if (!beside)
        error_set(error, "%.180s: out of memory", path);
    free(beside);
    return whole;
}

/* Opens all files before any of them is written. */
static bool open_files(struct files *files, const char *path, c205_error *error)
{
    const char *name = name_in(path);

    *files = (struct files){ 0 };
    files->folder = folder_of(path);
    files->name = text_of("%s", name);
    files->script_name = text_of("./%.*s.gp", (int)strlen(name) - ENDING, name);
    if (!files->folder || !files->name || !files->script_name)
        return error_set(error, "%.180s: out of memory", path);
    return (files->data = open_beside(path, ".dat", error)) != NULL
           && (files->script = open_beside(path, ".gp", error)) != NULL
           && (files->picture = atomic_file_open(path, error)) != NULL;
}

static bool commit(struct atomic_file **whole, c205_error *error)
{
    struct atomic_file *done = *whole;

    *whole = NULL;
    return atomic_file_commit(done, error);
}

static void discard(struct atomic_file *whole)
{
    if (whole)
        atomic_file_discard(whole);
}

static void close_files(struct files *files)
{
    discard(files->data);
    discard(files->script);
    discard(files->picture);
    free(files->folder);
    free(files->name);
    free(files->script_name);
}

/* ---- Values --------------------------------------------------------------- */

static bool reach(struct axis *axis, double value, const char *key, c205_error *error)
{
    if (!isfinite(value))
        return true;
    if (!axis_shows(axis, value))
        return error_set(error, "%.60s: %g cannot be drawn on a logarithmic axis", key,
                         value);
    axis_reach(axis, value);
    return true;
}

static bool reach_row(const struct plot *plot, const struct table *table, size_t row,
                      struct plot_axes *axes, c205_error *error)
{
    bool areas = plot->form == PLOT_AREAS;
    double sum = 0;

    for (size_t i = 0; i < plot->curve_count; i++) {
        size_t column = plot->curves[i].column;
        double value = table_value(table, row, column);
        sum += value;
        if (areas && value < 0)
            return error_set(error, "%.60s: an area of %g cannot be drawn",
                             table_key(table, column), value);
        if (!reach(&axes->y, areas ? sum : value, table_key(table, column), error))
            return false;
    }
    return reach(&axes->x, table_value(table, row, plot->x_column),
                 table_key(table, plot->x_column), error);
}

static bool reach_marks(struct axis *axis, const struct plot_mark *marks, size_t count,
                        c205_error *error)
{
    for (size_t i = 0; i < count; i++)
        if (!reach(axis, marks[i].at, marks[i].label, error))
            return false;
    return true;
}

static bool is_empty(const struct axis *axis)
{
    return axis->low > axis->high;
}

/* Extends the axes over everything that is drawn. */
static bool find_axes(const struct plot *plot, const struct table *table,
                      struct plot_axes *axes, c205_error *error)
{
    struct axis *x = &axes->x, *y = &axes->y;
    double highest;

    *x = axis_new(plot->x.scale);
    *y = axis_new(plot->form == PLOT_AREAS ? PLOT_LINEAR : plot->y.scale);
    for (size_t row = 0; row < table_rows(table); row++)
        if (!reach_row(plot, table, row, axes, error))
            return false;
    if (is_empty(x) || is_empty(y))
        return error_set(error, "%.180s: nothing to draw", plot->title);
    highest = y->high;
    if (plot->y_most > y->low)
        y->high = fmin(y->high, plot->y_most);
    if (!reach_marks(x, plot->marks, plot->mark_count, error)
        || !reach_marks(y, plot->levels, plot->level_count, error))
        return false;
    axis_widen(x);
    axis_widen(y);
    axis_round(y);
    axes->cut_off = highest > y->high ? highest : NAN;
    if (plot->form == PLOT_LINES)
        axis_pad(x);
    return true;
}

/* ---- Data ----------------------------------------------------------------- */

/* Writes the shortest text, of two lengths, that reads back as the same number. */
static void put_number(double value, FILE *file)
{
    char text[32];

    snprintf(text, sizeof text, "%.15g", value);
    if (strtod(text, NULL) != value)
        snprintf(text, sizeof text, "%.17g", value);
    fputs(isfinite(value) ? text : "NaN", file);
}

/* Writes a comment line. Line breaks in the text would end the comment, so they
 * become blanks. */
static void put_comment(const char *text, FILE *file)
{
    fputs("# ", file);
    for (; *text != '\0'; text++)
        putc((unsigned char)*text < ' ' ? ' ' : *text, file);
    putc('\n', file);
}

static void write_data(const struct plot *plot, const struct table *table, FILE *file)
{
    put_comment(plot->title, file);
    for (size_t i = 0; i < plot->subtitle_count; i++)
        put_comment(plot->subtitles[i], file);
    fprintf(file, "# %s", table_key(table, plot->x_column));
    for (size_t i = 0; i < plot->curve_count; i++)
        fprintf(file, " %s", table_key(table, plot->curves[i].column));
    putc('\n', file);
    for (size_t row = 0; row < table_rows(table); row++) {
        put_number(table_value(table, row, plot->x_column), file);
        for (size_t i = 0; i < plot->curve_count; i++) {
            putc(' ', file);
            put_number(table_value(table, row, plot->curves[i].column), file);
        }
        putc('\n', file);
    }
}

static bool write_files(const struct plot *plot, const struct table *table,
                        const struct plot_axes *axes, struct files *files,
                        c205_error *error)
{
    write_data(plot, table, files->data->file);
    if (!plot_script_write(plot, axes, files->name, files->script->file))
        return error_set(error, "%.180s: out of memory", plot->title);
    return commit(&files->data, error) && commit(&files->script, error)
           && gnuplot_draw(files->folder, files->script_name, files->picture->file,
                           error)
           && commit(&files->picture, error);
}

bool plot_write(const struct plot *plot, const struct table *table, const char *path,
                c205_error *error)
{
    struct plot_axes axes;
    struct files files;
    bool good;

    if (!table_is_whole(table))
        return error_set(error, "%.180s: out of memory", plot->title);
    if (!plot_check_path(path, error) || !find_axes(plot, table, &axes, error))
        return false;
    good = open_files(&files, path, error)
           && write_files(plot, table, &axes, &files, error);
    close_files(&files);
    return good;
}
