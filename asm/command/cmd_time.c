/* cmd_time.c - c205 time: measures the speed of the vector instructions. */
#include <stdlib.h>
#include <string.h>

#include "asm/command/session.h"
#include "asm/measure/measure.h"
#include "asm/object/syntax.h"
#include "base/array.h"

static const struct table_column speed_columns[] = {
    { "instruction", "instruction", TABLE_TEXT, 0 },
    { "timing", "timing", TABLE_TEXT, 0 },
    { "startup", "start-up clk", TABLE_NUMBER, 1 },
    { "per_element", "clk/element", TABLE_NUMBER, 4 },
    { "r_infinity", "r-infinity", TABLE_NUMBER, 1 },
    { "unit", "unit", TABLE_TEXT, 0 },
    { "n_half", "n-half", TABLE_NUMBER, 1 },
    { "deviation", "off line, clk", TABLE_NUMBER, 1 },
};

static const struct table_column point_columns[] = {
    { "instruction", "instruction", TABLE_TEXT, 0 },
    { "length", "length", TABLE_COUNT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
};

/* The columns of a table with one row for all instructions of a class that take the
 * same time. */
static const struct table_column class_columns[] = {
    { "timing", "timing", TABLE_TEXT, 0 },
    { "startup", "start-up", TABLE_NUMBER, 1 },
    { "per_element", "clk/element", TABLE_NUMBER, 4 },
    { "r_infinity", "r-infin.", TABLE_NUMBER, 1 },
    { "unit", "unit", TABLE_TEXT, 0 },
    { "n_half", "n-half", TABLE_NUMBER, 1 },
    { "deviation", "off line", TABLE_NUMBER, 1 },
    { "instructions", "instructions", TABLE_TEXT, 0 },
};

struct time_arguments {
    struct shared_arguments shared;
    struct command_texts names; /* instructions to measure; none: all */
    bool points;
};

struct measurements {
    size_t count;
    struct measurement *items;
};

/* ---- Single instructions  */

static void add_speed(struct table *table, const struct measurement *item,
                      const c205_model *model)
{
    table_number(table, item->startup);
    table_number(table, item->per_element);
    table_number(table, measure_rate(item, model));
    table_text(table, item->flops > 0 ? "Mflop/s" : "Mresults/s");
    table_number(table, measure_half_length(item));
    table_number(table, item->deviation);
}

static struct table *speed_table(const struct measurements *measured,
                                 const c205_model *model)
{
    struct table *speeds = table_new(TABLE_COLUMNS(speed_columns));
    for (size_t i = 0; speeds && i < measured->count; i++) {
        const struct measurement *item = &measured->items[i];
        table_text(speeds, item->name);
        table_text(speeds, item->timing);
        add_speed(speeds, item, model);
    }
    return speeds;
}

static struct table *point_table(const struct measurements *measured)
{
    struct table *points = table_new(TABLE_COLUMNS(point_columns));
    for (size_t i = 0; points && i < measured->count; i++) {
        const struct measurement *item = &measured->items[i];
        for (size_t k = 0; k < MEASURE_POINTS; k++) {
            table_text(points, item->name);
            table_count(points, item->points[k].length);
            table_count(points, item->points[k].clocks);
        }
    }
    return points;
}

/* ---- By class ---- */

static const char *qualifier_of(const struct measurement *measured)
{
    return measured->name + strcspn(measured->name, ",");
}

static bool alike(const struct measurement *a, const struct measurement *b)
{
    bool same = strcmp(a->timing, b->timing) == 0 && a->flops == b->flops
                && strcmp(qualifier_of(a), qualifier_of(b)) == 0;
    for (size_t i = 0; same && i < MEASURE_POINTS; i++)
        same = a->points[i].clocks == b->points[i].clocks;
    return same;
}

static bool is_first(const struct measurements *measured, size_t number)
{
    const struct measurement *items = measured->items;
    size_t i = 0;
    while (!alike(&items[i], &items[number]))
        i++;
    return i == number;
}

/* Writes the names of all instructions of a class. */
static void add_names(struct table *table, const struct measurements *measured,
                      const struct measurement *class)
{
    enum { ROOM = 1024 };
    char text[ROOM] = "";
    size_t length = 0;
    for (size_t i = 0; i < measured->count; i++) {
        const struct measurement *item = &measured->items[i];
        int size = (int)strcspn(item->name, ",");
        if (alike(item, class)) {
            length += (size_t)snprintf(text + length, ROOM - length, "%s%.*s",
                                       length > 0 ? " " : "", size, item->name);
        }
    }
    table_text(table, text);
}

static struct table *class_table(const struct measurements *measured,
                                 const c205_model *model)
{
    struct table *table = table_new(TABLE_COLUMNS(class_columns));
    for (size_t i = 0; table && i < measured->count; i++) {
        const struct measurement *item = &measured->items[i];
        char timing[C205_TEXT_SIZE];
        if (!is_first(measured, i))
            continue;
        snprintf(timing, sizeof timing, "%s%s", item->timing, qualifier_of(item));
        table_text(table, timing);
        add_speed(table, item, model);
        add_names(table, measured, item);
    }
    return table;
}

/* ---- Measurement --------- */

static bool add_name(const struct time_arguments *args, const c205_model *model,
                     const char *name, struct measurements *measured)
{
    struct measurement taken;
    c205_error error = { "out of memory" };
    if (measure(model, name, &taken, &error)
        && array_add(&measured->items, &measured->count, &taken, sizeof taken))
        return true;
    cmd_failed(args->shared.command, "%s", error.message);
    return false;
}

/* Measures all instructions with one size of operands, and the triad. */
static bool measure_size(const struct time_arguments *args, const c205_model *model,
                         const char *suffix, struct measurements *measured)
{
    char name[MEASURE_NAME_SIZE];
    bool good = true;
    for (size_t i = 0; good && i < c205_insn_count; i++) {
        snprintf(name, sizeof name, "%s%s", c205_insns[i].mnemonic, suffix);
        if (measure_knows(name))
            good = add_name(args, model, name, measured);
    }
    snprintf(name, sizeof name, "%s%s", measure_triad, suffix);
    return good && add_name(args, model, name, measured);
}

/* Measures the named instructions in their order, or all instructions. */
static bool measure_all(const struct time_arguments *args, const c205_model *model,
                        struct measurements *measured)
{
    bool good = true;
    for (size_t i = 0; good && i < args->names.count; i++)
        good = add_name(args, model, args->names.items[i], measured);
    if (args->names.count > 0)
        return good;
    return measure_size(args, model, "", measured)
           && measure_size(args, model, SYNTAX_HALF, measured);
}

/* ---- Results --------- */

/* Prints the measured points if the option --points is given. They are always written
 * to the JSON. */
static int show_points(const struct time_arguments *args,
                       const struct measurements *measured,
                       const struct command_output *results)
{
    struct command_output shown = *results;
    if (!args->points)
        shown.file = NULL;
    int code = output_show(&shown, point_table(measured), "points", "Points");
    if (code == CMD_DONE && args->points)
        output_gap(results);
    return code;
}

/* Shows the speeds of the named instructions one by one, or of all instructions by
 * class. CSV and JSON always have single instructions. */
static int show_speeds(const struct time_arguments *args, const c205_model *model,
                       const struct measurements *measured,
                       const struct command_output *results)
{
    struct command_output classes = *results, each = *results;
    if (args->names.count > 0 || results->format == OUTPUT_CSV || !results->file)
        return output_show(results, speed_table(measured, model), "speeds", "Speeds");
    classes.json = NULL;
    each.file = NULL;
    int code = output_show(&classes, class_table(measured, model), NULL,
                           "Speeds by class");
    return code != CMD_DONE
               ? code
               : output_show(&each, speed_table(measured, model), "speeds", NULL);
}

static int show(const struct time_arguments *args, const c205_model *model,
                const struct measurements *measured,
                const struct command_output *results)
{
    if (results->json)
        provenance_json(model, results->json);
    int code = show_points(args, measured, results);
    if (code == CMD_DONE)
        code = show_speeds(args, model, measured, results);
    if (code == CMD_DONE)
        output_model(results, model);
    return code;
}

static int time_model(const struct time_arguments *args, const c205_model *model,
                      const struct command_output *results)
{
    struct measurements measured = { 0, NULL };
    int code = measure_all(args, model, &measured)
                   ? show(args, model, &measured, results)
                   : CMD_FAILED;
    free(measured.items);
    return code;
}

static int cmd_time(void *given)
{
    const struct time_arguments *args = given;
    struct session session = { .command = args->shared.command };
    for (size_t i = 0; i < args->names.count; i++) {
        const char *name = args->names.items[i];
        if (!measure_knows(name)) {
            return cmd_usage(args->shared.command, "unknown vector instruction '%s'",
                             name);
        }
    }
    bool good = session_model(&session, args->shared.model)
                && session_output(&session, &args->shared.results, NULL);
    return session_close(&session,
                         good ? time_model(args, session.model, &session.results)
                              : CMD_FAILED);
}

/* Returns choice `number` for the completion of MNEMONIC: a vector instruction or the
 * triad. Returns "" if the instruction cannot be measured, and NULL after the last
 * choice. */
static const char *measured_choice(size_t number)
{
    if (number > c205_insn_count)
        return NULL;
    const char *name = number < c205_insn_count ? c205_insns[number].mnemonic
                                                : measure_triad;
    return measure_knows(name) ? name : "";
}

#define PLACE(member) offsetof(struct time_arguments, member)

static const struct command_option options[] = {
    CMD_MODEL, OPTION_FLAG("points", PLACE(points), "print each measured point, too"),
    CMD_FIGURES, COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW(
          "MNEMONIC", COMMAND_TEXT, PLACE(names),
          "a vector instruction, or TRIAD, the linked triad B + s A; ,H after a "
          "name: on 32-bit operands"),
      .many = true, .optional = true, .choice = measured_choice },
    COMMAND_END
};

const struct command time_command = {
    COMMAND_ROW("time", cmd_time, struct time_arguments,
                "measure the vector instructions"),
    .details =
        "Prints the start-up (in clocks), clocks per element, r-infinity and n-half "
        "of these instructions. Without MNEMONIC all instructions are measured, and "
        "instructions of a class that take the same time share one line; \",H\" after "
        "a class means 32-bit operands. CSV and JSON have a row for each instruction. "
        "Off line: the largest distance in clocks of a measured point from the "
        "straight line. The elements of sparse vectors are the bits of their order "
        "vectors; the rate counts executed operations.",
};
