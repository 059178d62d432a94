/* accounts_show.c - builds and prints the matrix of causes and regions. */
#include "base/accounts_show.h"

#include <math.h>
#include <stdlib.h>

#include "base/word_wrap.h"

/* ---- Figures of a region ------------------------------------------------ */

static double or_nothing(uint64_t count)
{
    return count > 0 ? (double)count : NAN;
}

static double instructions(const c205_model *model, const c205_account *account)
{
    (void)model;
    return or_nothing(account->instructions);
}

static double vectors(const c205_model *model, const c205_account *account)
{
    (void)model;
    return or_nothing(account->vector_instructions);
}

static double mean_length(const c205_model *model, const c205_account *account)
{
    return (double)account->elements / vectors(model, account);
}

static const struct figure {
    const char *name;
    int decimals;
    double (*of)(const c205_model *model, const c205_account *account);
} figures[] = {
    { "instructions", 0, instructions },
    { "of them vector", 0, vectors },
    { "mean vector length", 1, mean_length },
    { "Mflop/s", 2, accounts_rate },
};
enum {
    FIGURES = sizeof figures / sizeof *figures,
    /* Lines of the matrix: each cause, their sum, its percentage, further figures. */
    ALL = C205_CAUSES,
    SHARE,
    FIRST_FIGURE,
    LINES = FIRST_FIGURE + FIGURES
};

/* ---- The matrix in either orientation ----------------------------------- */

struct matrix {
    const struct accounts *accounts;
    const struct accounts_unit *unit;
    c205_account sum;
    size_t count;
    const c205_account **regions; /* regions that took time */
    size_t line_count;
    int lines[LINES]; /* lines with a value */
};

static double value(const struct matrix *matrix, int line, const c205_account *account)
{
    const c205_model *model = matrix->accounts->model;
    uint64_t clocks = line < ALL ? account->clocks[line] : accounts_clocks(account);
    if (line >= FIRST_FIGURE)
        return figures[line - FIRST_FIGURE].of(model, account);
    return line == SHARE ? 100 * (double)clocks / (double)matrix->accounts->clocks
                         : accounts_seconds(model, clocks) * matrix->unit->per_second;
}

static const char *line_name(int line)
{
    return line >= FIRST_FIGURE ? figures[line - FIRST_FIGURE].name
           : line == SHARE      ? "%"
           : line == ALL        ? "all"
                                : c205_cause_name((c205_cause)line);
}

static void add_value(struct table *table, const struct matrix *matrix, int line,
                      const c205_account *account)
{
    double number = value(matrix, line, account);
    int decimals = line >= FIRST_FIGURE ? figures[line - FIRST_FIGURE].decimals
                   : line == SHARE      ? 1
                                        : matrix->unit->decimals;
    table_rounded(table, number > 0 ? number : NAN, decimals);
}

static bool matrix_of(struct matrix *matrix, const struct accounts *accounts)
{
    matrix->accounts = accounts;
    matrix->sum = accounts_together(accounts);
    matrix->unit = accounts_unit(accounts_seconds(accounts->model, accounts->clocks));
    matrix->regions = malloc((accounts->count + 1) * sizeof *matrix->regions);
    for (size_t i = 0; matrix->regions && i < accounts->count; i++)
        if (accounts_clocks(&accounts->items[i]) > 0)
            matrix->regions[matrix->count++] = &accounts->items[i];
    for (int line = 0; line < LINES; line++)
        if (value(matrix, line, &matrix->sum) > 0)
            matrix->lines[matrix->line_count++] = line;
    return matrix->regions != NULL;
}

/* ---- Causes are rows ----------------------------------------------------- */

/* Adds one row of the matrix. The sum of all regions and its percentage are printed
 * only if first is 0. */
static void add_cause(struct table *table, const struct matrix *matrix, int line,
                      size_t first, size_t count)
{
    double all = value(matrix, ALL, &matrix->sum);
    double here = value(matrix, line, &matrix->sum);
    table_text(table, line_name(line));
    if (first == 0) {
        add_value(table, matrix, line, &matrix->sum);
        table_number(table, line <= ALL ? 100 * here / all : NAN);
    }
    for (size_t i = first; i < first + count; i++)
        add_value(table, matrix, line, matrix->regions[i]);
}

static struct table *causes_down(const struct matrix *matrix, size_t first,
                                 size_t count)
{
    size_t before = first == 0 ? 3 : 1;
    struct table_column *columns = calloc(3 + count, sizeof *columns);
    struct table *table = NULL;
    if (columns) {
        columns[0] = (struct table_column){ "cause", matrix->unit->heading, TABLE_TEXT,
                                            0 };
        columns[1] = (struct table_column){ "all", "all", TABLE_NUMBER, 0 };
        columns[2] = (struct table_column){ "percent", "%", TABLE_NUMBER, 1 };
        for (size_t i = 0; i < count; i++) {
            const char *name = accounts_region(matrix->regions[first + i]);
            columns[before + i] = (struct table_column){ name, name, TABLE_NUMBER, 0 };
        }
        table = table_new(columns, before + count);
    }
    for (size_t i = 0; table && i < matrix->line_count; i++)
        if (matrix->lines[i] != SHARE)
            add_cause(table, matrix, matrix->lines[i], first, count);
    free(columns);
    return table;
}

/* ---- Regions are rows ---------------------------------------------------- */

static void add_region(struct table *table, const struct matrix *matrix,
                       const c205_account *account, const char *name)
{
    table_text(table, name);
    for (size_t i = 0; i < matrix->line_count; i++)
        add_value(table, matrix, matrix->lines[i], account);
}

static struct table *regions_down(const struct matrix *matrix, size_t first,
                                  size_t count)
{
    struct table_column columns[1 + LINES] = { { "region", matrix->unit->heading,
                                                 TABLE_TEXT, 0 } };
    struct table *table;
    for (size_t i = 0; i < matrix->line_count; i++) {
        const char *name = line_name(matrix->lines[i]);
        columns[1 + i] = (struct table_column){ name, name, TABLE_NUMBER, 0 };
    }
    table = table_new(columns, 1 + matrix->line_count);
    for (size_t i = first; table && i < first + count; i++) {
        add_region(table, matrix, matrix->regions[i],
                   accounts_region(matrix->regions[i]));
    }
    if (table)
        add_region(table, matrix, &matrix->sum, "all");
    return table;
}

struct table *accounts_matrix(const struct accounts *accounts, enum accounts_rows rows,
                              size_t first, size_t count)
{
    struct matrix matrix = { .accounts = accounts };
    struct table *table = NULL;
    if (matrix_of(&matrix, accounts)) {
        size_t there = matrix.count > 1 && first < matrix.count ? matrix.count - first
                                                                : 0;
        size_t shown = count < there ? count : there;
        table = rows == ACCOUNTS_CAUSES ? causes_down(&matrix, first, shown)
                                        : regions_down(&matrix, first, shown);
    }
    free(matrix.regions);
    return table;
}

/* ---- Printing ----------------------------------------------------------- */

static bool fits(const struct table *table)
{
    return !table || table_width(table) <= WORD_WRAP_WIDTH;
}

/* Returns the matrix for regions from index first on. Sets the number of regions that
 * fit the line width. */
static struct table *widest(const struct accounts *accounts, size_t first,
                            size_t *count)
{
    struct table *table = accounts_matrix(accounts, ACCOUNTS_CAUSES, first, *count);
    while (!fits(table) && *count > 1) {
        table_free(table);
        --*count;
        table = accounts_matrix(accounts, ACCOUNTS_CAUSES, first, *count);
    }
    return table;
}

/* Prints the matrix of causes and regions. If it is wider than the output, prints
 * several matrices, each with some of the regions. */
static int show_parts(const struct accounts *accounts,
                      const struct command_output *results)
{
    size_t first = 0, all = accounts_regions(accounts), count;
    int code = CMD_DONE;
    do {
        count = all - first;
        struct table *table = widest(accounts, first, &count);
        if (first > 0)
            output_gap(results);
        code = output_show(results, table, NULL, "Clocks");
        first += count;
    } while (code == CMD_DONE && first < all);
    return code;
}

static int show_matrix(const struct accounts *accounts,
                       const struct command_output *results)
{
    bool narrow = results->format == OUTPUT_TEXT;
    for (int rows = ACCOUNTS_CAUSES; rows <= ACCOUNTS_REGIONS; rows++) {
        struct table *table = accounts_matrix(accounts, (enum accounts_rows)rows, 0,
                                              accounts->count);
        if (!narrow || fits(table))
            return output_show(results, table, NULL, "Clocks");
        table_free(table);
    }
    return show_parts(accounts, results);
}

static int show_exact(const struct accounts *accounts,
                      const struct command_output *results)
{
    int code = output_show(results, accounts_by_cause(accounts), "causes",
                           "Clocks by cause");
    return code != CMD_DONE ? code
                            : output_show(results, accounts_by_region(accounts),
                                          "regions", "By region");
}

int accounts_show(const struct accounts *accounts, const struct command_output *results)
{
    struct command_output exact = *results, matrix = *results;
    int code;
    if (results->format != OUTPUT_CSV)
        exact.file = NULL;
    matrix.json = NULL;
    code = show_exact(accounts, &exact);
    return code != CMD_DONE || exact.file || !results->file
               ? code
               : show_matrix(accounts, &matrix);
}
