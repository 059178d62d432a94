/* line_profile.c - attributes the clocks of a run to source lines and writes tables. */
#include "asm/measure/line_profile.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/accounts.h"

/* The rows after the rows of lines, for clocks that belong to no line. */
enum { ROW_UNKNOWN, ROW_END, ROWS_BESIDES };

struct line_profile {
    const struct object *object;
    size_t *row_of; /* the row of each line of the object */
    size_t row_count;
    struct profile_row *rows;    /* [row_count + ROWS_BESIDES] */
    const struct asm_line *last; /* the line of the last look-up */
    bool cut;                    /* the run stopped within an instruction */
    bool has_forms;              /* a row has a form */
};

/* ---- Rows ----------------------------------------------------------------- */

/* The key of a line for sorting by place, region and form. */
struct placed_line {
    const struct asm_line *line;
    const char *region;
    size_t index;
};

static int compare_places(const void *a, const void *b)
{
    const struct placed_line *one = a, *other = b;
    const struct asm_place *place = &one->line->shown, *next = &other->line->shown;
    int order = strcmp(place->file, next->file);
    if (order == 0)
        order = (place->number > next->number) - (place->number < next->number);
    if (order == 0)
        order = strcmp(one->region, other->region);
    if (order == 0)
        order = (int)one->line->form - (int)other->line->form;
    return order != 0 ? order
                      : (one->index > other->index) - (one->index < other->index);
}

static bool is_same_row(const struct placed_line *a, const struct placed_line *b)
{
    const struct asm_place *place = &b->line->shown;
    return asm_place_is(&a->line->shown, place->file, place->number)
           && strcmp(a->region, b->region) == 0 && a->line->form == b->line->form;
}

/* Finds, for each line, the first line that belongs to the same row. */
static void find_firsts(const struct placed_line *places, size_t count, size_t *first)
{
    size_t begin = 0;
    for (size_t i = 0; i < count; i++) {
        if (!is_same_row(&places[i], &places[begin]))
            begin = i;
        first[places[i].index] = places[begin].index;
    }
}

/* Finds, for each line, the first line with the same place, region and form. The lines
 * are sorted by these and then by index, so the first of equal lines comes first. */
static bool sort_places(const struct object *object, size_t *first)
{
    size_t count = object->line_count;
    struct placed_line *places = malloc((count + 1) * sizeof *places);
    if (!places)
        return false;
    for (size_t i = 0; i < count; i++) {
        places[i].line = &object->lines[i];
        places[i].region = object_region(object, object->lines[i].address);
        places[i].index = i;
    }
    qsort(places, count, sizeof *places, compare_places);
    find_firsts(places, count, first);
    free(places);
    return true;
}

/* Makes the rows in the order of addresses. The first line of a row precedes its other
 * lines, so the row exists when they are reached. */
static void make_rows(struct line_profile *profile)
{
    for (size_t i = 0; i < profile->object->line_count; i++) {
        const struct asm_line *line = &profile->object->lines[i];
        struct profile_row *row = &profile->rows[profile->row_count];
        if (profile->row_of[i] < i) {
            profile->row_of[i] = profile->row_of[profile->row_of[i]];
            continue;
        }
        row->region = object_region(profile->object, line->address);
        row->file = line->shown.file;
        row->number = line->shown.number;
        row->source = line->shown.source;
        row->form = line->form;
        profile->has_forms = profile->has_forms || row->form;
        profile->row_of[i] = profile->row_count++;
    }
}

struct line_profile *line_profile_new(const struct object *object)
{
    struct line_profile *profile = calloc(1, sizeof *profile);
    size_t count = object->line_count;
    if (!profile)
        return NULL;
    profile->object = object;
    profile->row_of = calloc(count + 1, sizeof *profile->row_of);
    profile->rows = calloc(count + ROWS_BESIDES, sizeof *profile->rows);
    if (profile->row_of && profile->rows && sort_places(object, profile->row_of)) {
        make_rows(profile);
        for (size_t i = 0; i < ROWS_BESIDES; i++)
            profile->rows[profile->row_count + i].region = "";
        return profile;
    }
    line_profile_free(profile);
    return NULL;
}

void line_profile_free(struct line_profile *profile)
{
    if (!profile)
        return;
    free(profile->row_of);
    free(profile->rows);
    free(profile);
}

void line_profile_add(struct line_profile *profile, const struct line_profile *more)
{
    for (size_t i = 0; i < line_profile_count(profile); i++) {
        struct profile_row *row = &profile->rows[i];
        row->executions += more->rows[i].executions;
        row->elements += more->rows[i].elements;
        for (int cause = 0; cause < C205_CAUSES; cause++)
            row->clocks[cause] += more->rows[i].clocks[cause];
    }
}

size_t line_profile_count(const struct line_profile *profile)
{
    return profile->row_count + ROWS_BESIDES;
}

const struct profile_row *line_profile_row(const struct line_profile *profile, size_t i)
{
    return &profile->rows[i];
}

/* ---- The listener --------------------------------------------------------- */

static bool line_contains(const struct asm_line *line, uint64_t address)
{
    return line && address >= line->address
           && address - line->address < 32 * line->halves;
}

static struct profile_row *row_at(struct line_profile *profile, uint64_t address)
{
    if (!line_contains(profile->last, address))
        profile->last = object_line(profile->object, address);
    return profile->last
               ? &profile->rows[profile->row_of[profile->last - profile->object->lines]]
               : &profile->rows[profile->row_count + ROW_UNKNOWN];
}

static void add_pieces(struct line_profile *profile, const c205_times *times)
{
    for (size_t i = 0; i < times->piece_count; i++) {
        const c205_piece *piece = &times->piece[i];
        row_at(profile, piece->pc)->clocks[piece->cause] += piece->clocks;
    }
}

/* Computes the clocks of an instruction within which the run stopped. The accounts of
 * the machine contain its clocks, but no row does yet. */
static void add_end(struct line_profile *profile, const c205 *machine)
{
    struct profile_row *end = &profile->rows[profile->row_count + ROW_END];
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        uint64_t clocks = 0;
        for (size_t i = 0; i < c205_account_count(machine); i++)
            clocks += c205_account_at(machine, i)->clocks[cause];
        for (size_t i = 0; i <= profile->row_count; i++)
            clocks -= profile->rows[i].clocks[cause];
        end->clocks[cause] = clocks;
    }
}

static void forget_end(struct line_profile *profile)
{
    struct profile_row *end = &profile->rows[profile->row_count + ROW_END];
    memset(end->clocks, 0, sizeof end->clocks);
    profile->cut = false;
}

void line_profile_listen(void *context, const c205 *machine, const c205_event *event)
{
    struct line_profile *profile = context;
    struct profile_row *row;
    if (!event->record) {
        add_end(profile, machine);
        profile->cut = true;
        return;
    }
    if (profile->cut)
        forget_end(profile);
    add_pieces(profile, event->record);
    if (event->kind != C205_EVENT_INSTRUCTION && event->kind != C205_EVENT_REQUEST)
        return;
    row = row_at(profile, event->pc);
    row->executions++;
    row->elements += event->elements;
}

/* ---- Tables --------------------------------------------------------------- */

/* The columns of tables. The column of regions is omitted if regions are not shown, and
 * that of forms if no row has a form. */
static const struct table_column region_column = { "region", "region", TABLE_TEXT, 0 };
static const struct table_column line_column = { "line", "line", TABLE_TEXT, 0 };
static const struct table_column form_column = { "form", "form", TABLE_TEXT, 0 };
static const struct table_column number_columns[] = {
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "percent", "%", TABLE_NUMBER, 1 },
    { "executions", "times", TABLE_COUNT, 0 },
    { "elements", "elements", TABLE_COUNT, 0 },
};
static const struct table_column source_column = { "source", "source", TABLE_TEXT, 0 };
static const struct table_column causes_column = { "causes", "mostly", TABLE_TEXT, 0 };
enum {
    NUMBER_COLUMNS = sizeof number_columns / sizeof *number_columns,
    MAX_COLUMNS = 3 + NUMBER_COLUMNS + C205_CAUSES + 2
};

uint64_t line_profile_clocks(const struct profile_row *row)
{
    uint64_t sum = 0;
    for (int cause = 0; cause < C205_CAUSES; cause++)
        sum += row->clocks[cause];
    return sum;
}

static void put_name(struct table *table, const struct line_profile *profile,
                     const struct profile_row *row)
{
    char name[300];
    const char *slash = row->file ? strrchr(row->file, '/') : NULL;
    if (row->file)
        snprintf(name, sizeof name, "%.280s:%zu", slash ? slash + 1 : row->file,
                 row->number);
    else
        snprintf(name, sizeof name, "%s",
                 row == &profile->rows[profile->row_count + ROW_END]
                     ? "stopped inside an instruction"
                     : "no line");
    table_text(table, name);
}

static void put_source(struct table *table, const struct profile_row *row)
{
    const char *source = row->source ? row->source : "";
    table_text(table, source + strspn(source, " \t"));
}

/* Writes up to three causes and their clocks, the largest first. A cause is written
 * only if it has at least a tenth of the clocks of the row. */
static void put_causes(struct table *table, const struct profile_row *row)
{
    char text[160] = "";
    uint64_t all = line_profile_clocks(row);
    bool reported[C205_CAUSES] = { false };
    size_t used = 0;
    for (int i = 0; i < 3; i++) {
        int found = -1;
        for (int cause = 0; cause < C205_CAUSES; cause++)
            if (!reported[cause] && row->clocks[cause] > 0
                && row->clocks[cause] * 10 >= all
                && (found < 0 || row->clocks[cause] > row->clocks[found]))
                found = cause;
        if (found < 0)
            break;
        reported[found] = true;
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s %" PRIu64,
                                 used > 0 ? ", " : "",
                                 c205_cause_name((c205_cause)found),
                                 row->clocks[found]);
    }
    table_text(table, text);
}

static struct table *new_table(const struct line_profile *profile, bool regions,
                               bool words)
{
    struct table_column columns[MAX_COLUMNS];
    size_t count = 0;
    if (regions)
        columns[count++] = region_column;
    columns[count++] = line_column;
    if (profile->has_forms)
        columns[count++] = form_column;
    memcpy(columns + count, number_columns, sizeof number_columns);
    count += NUMBER_COLUMNS;
    if (!words) {
        memcpy(columns + count, accounts_cause_columns, sizeof accounts_cause_columns);
        count += C205_CAUSES;
    }
    columns[count++] = source_column;
    if (words)
        columns[count++] = causes_column;
    return table_new(columns, count);
}

static void put_profile_row(struct table *table, const struct line_profile *profile,
                            const struct profile_row *row, uint64_t all, bool words)
{
    put_name(table, profile, row);
    if (profile->has_forms)
        table_text(table, asm_form_name(row->form));
    table_count(table, line_profile_clocks(row));
    table_number(table,
                 all > 0 ? 100 * (double)line_profile_clocks(row) / (double)all : 0);
    table_count(table, row->executions);
    table_count(table, row->elements);
    for (int cause = 0; !words && cause < C205_CAUSES; cause++)
        table_count(table, row->clocks[cause]);
    put_source(table, row);
    if (words)
        put_causes(table, row);
}

/* ---- Selection and order of the rows --------------------------------------- */

struct shown_row {
    const struct profile_row *row;
    uint64_t clocks;
    uint64_t of_region; /* clocks of the region; 0 if regions are not summed */
};

struct shown_rows {
    size_t count;
    struct shown_row *rows;
    uint64_t clocks;
};

/* Selects and sorts the rows. Returns false if memory is exhausted. */
static bool choose_rows(const struct line_profile *profile, struct shown_rows *shown)
{
    size_t count = line_profile_count(profile);
    *shown = (struct shown_rows){ .rows = malloc(count * sizeof *shown->rows) };
    for (size_t i = 0; shown->rows && i < count; i++) {
        const struct profile_row *row = &profile->rows[i];
        uint64_t clocks = line_profile_clocks(row);
        if (row->executions == 0 && clocks == 0)
            continue;
        shown->rows[shown->count++] = (struct shown_row){ row, clocks, 0 };
        shown->clocks += clocks;
    }
    return shown->rows;
}

static int compare_regions(const void *a, const void *b)
{
    const struct shown_row *one = a, *other = b;
    return strcmp(one->row->region, other->row->region);
}

static void add_up_regions(struct shown_rows *shown)
{
    size_t end;
    qsort(shown->rows, shown->count, sizeof *shown->rows, compare_regions);
    for (size_t i = 0; i < shown->count; i = end) {
        uint64_t sum = 0;
        for (end = i; end < shown->count
                      && compare_regions(&shown->rows[i], &shown->rows[end]) == 0;
             end++)
            sum += shown->rows[end].clocks;
        for (size_t k = i; k < end; k++)
            shown->rows[k].of_region = sum;
    }
}

static int compare_hottest(const void *a, const void *b)
{
    const struct shown_row *one = a, *other = b;
    int order = (one->of_region < other->of_region)
                - (one->of_region > other->of_region);
    if (order == 0 && one->of_region > 0)
        order = compare_regions(one, other);
    if (order == 0)
        order = (one->clocks < other->clocks) - (one->clocks > other->clocks);
    return order != 0 ? order : (one->row > other->row) - (one->row < other->row);
}

static void put_rows(struct table *table, const struct line_profile *profile,
                     const struct shown_rows *shown, bool regions, bool words)
{
    for (size_t i = 0; table && i < shown->count; i++) {
        if (regions)
            table_text(table, shown->rows[i].row->region);
        put_profile_row(table, profile, shown->rows[i].row, shown->clocks, words);
    }
}

struct table *line_profile_table(const struct line_profile *profile,
                                 struct profile_view view, bool words)
{
    struct shown_rows shown;
    struct table *table;
    if (!choose_rows(profile, &shown))
        return NULL;
    if (view.order == PROFILE_HOTTEST && view.regions)
        add_up_regions(&shown);
    if (view.order == PROFILE_HOTTEST)
        qsort(shown.rows, shown.count, sizeof *shown.rows, compare_hottest);
    table = new_table(profile, view.regions, words);
    put_rows(table, profile, &shown, view.regions, words);
    free(shown.rows);
    return table;
}

/* Shows the table. Text and Markdown have the causes in words, and other formats have a
 * column for each cause. */
int line_profile_show(const struct line_profile *profile, struct profile_view view,
                      const struct command_output *results)
{
    struct command_output shown = *results, kept = *results;
    bool words = results->file
                 && (results->format == OUTPUT_TEXT
                     || results->format == OUTPUT_MARKDOWN);
    int code;
    if (!words)
        return output_show(results, line_profile_table(profile, view, false), "lines",
                           "Lines");
    shown.json = NULL;
    kept.file = NULL;
    output_gap(results);
    code = output_show(&shown, line_profile_table(profile, view, true), NULL, "Lines");
    return code != CMD_DONE || !results->json
               ? code
               : output_show(&kept, line_profile_table(profile, view, false), "lines",
                             NULL);
}
