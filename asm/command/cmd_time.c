/* cmd_time.c - c205 time: the speed of the vector instructions. */
#include "asm/command/c205_command.h"
#include "asm/measure.h"
#include "asm/syntax.h"

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

struct tables {
    struct table *speeds, *points;
};

static void add_measurement(struct tables *tables,
                            const struct measurement *measured,
                            const c205_model *model)
{
    struct table *speeds = tables->speeds;
    table_text(speeds, measured->name);
    table_text(speeds, measured->timing);
    table_number(speeds, measured->startup);
    table_number(speeds, measured->per_element);
    table_number(speeds, measure_rate(measured, model));
    table_text(speeds, measured->flops ? "Mflop/s" : "Mresults/s");
    table_number(speeds, measure_half_length(measured));
    table_number(speeds, measured->deviation);
    for (size_t i = 0; i < MEASURE_POINTS; i++) {
        table_text(tables->points, measured->name);
        table_count(tables->points, measured->points[i].length);
        table_count(tables->points, measured->points[i].clocks);
    }
}

static bool add_name(const struct cmd_arguments *arguments,
                     const c205_model *model, const char *name,
                     struct tables *tables)
{
    struct measurement measured;
    c205_error error;
    if (!measure(model, name, &measured, &error)) {
        cmd_failed(arguments->command, "%s", error.message);
        return false;
    }
    add_measurement(tables, &measured, model);
    return true;
}

/* All of the table in one size, and the triad. */
static bool measure_size(const struct cmd_arguments *arguments,
                         const c205_model *model, const char *suffix,
                         struct tables *tables)
{
    char name[MEASURE_NAME_SIZE];
    bool good = true;
    for (size_t i = 0; good && i < c205_insn_count; i++) {
        snprintf(name, sizeof name, "%s%s", c205_insns[i].mnemonic, suffix);
        if (measure_knows(name)) {
            good = add_name(arguments, model, name, tables);
        }
    }
    snprintf(name, sizeof name, "%s%s", measure_triad, suffix);
    return good && add_name(arguments, model, name, tables);
}

/* Those that were named, in that order; or all. */
static bool measure_all(const struct cmd_arguments *arguments,
                        const c205_model *model, struct tables *tables)
{
    bool good = true;
    for (size_t i = 0; good && i < arguments->files.count; i++) {
        good = add_name(arguments, model, arguments->files.items[i], tables);
    }
    if (arguments->files.count > 0) {
        return good;
    }
    return measure_size(arguments, model, "", tables)
           && measure_size(arguments, model, SYNTAX_HALF, tables);
}

/* Both tables go to the JSON file; the points are printed when asked for. */
static int show(const struct cmd_arguments *arguments,
                const c205_model *model, struct tables *tables,
                const struct results *results)
{
    if (results->json) {
        provenance_json(model, results->json);
        if (!table_json(tables->points, results->json, "points")) {
            return cmd_failed(arguments->command, "no memory");
        }
    }
    if (arguments->points) {
        struct results printed = *results;
        printed.json = NULL;
        int code = results_show(&printed, tables->points, NULL, "Points");
        tables->points = NULL;
        if (code != CMD_DONE) {
            return code;
        }
        results_gap(results);
    }
    int code = results_show(results, tables->speeds, "speeds", "Speeds");
    tables->speeds = NULL;
    results_model(results, model);
    return code;
}

static int time_model(const struct cmd_arguments *arguments,
                      const c205_model *model, const struct results *results)
{
    struct tables tables = {
        table_new(TABLE_COLUMNS(speed_columns)),
        table_new(TABLE_COLUMNS(point_columns)),
    };
    int code = CMD_FAILED;
    if (!tables.speeds || !tables.points) {
        cmd_failed(arguments->command, "no memory");
    } else if (measure_all(arguments, model, &tables)) {
        code = show(arguments, model, &tables, results);
    }
    table_free(tables.speeds);
    table_free(tables.points);
    return code;
}

static int run(void *given)
{
    const struct cmd_arguments *arguments = given;
    struct results results = arguments->results;
    for (size_t i = 0; i < arguments->files.count; i++) {
        const char *name = arguments->files.items[i];
        if (!measure_knows(name)) {
            return cmd_usage(arguments->command,
                             "no such vector instruction: %s", name);
        }
    }
    c205_model *model = model_open(arguments->command, arguments->model);
    int code = CMD_FAILED;
    if (model && results_open(&results, arguments->command, NULL)) {
        code = time_model(arguments, model, &results);
        code = results_close(&results, code);
    }
    c205_model_free(model);
    return code;
}

/* Those that can be measured, and the triad. */
static const char *measured_choice(size_t number)
{
    if (number > c205_insn_count) {
        return NULL;
    }
    const char *name = number < c205_insn_count ? c205_insns[number].mnemonic
                                                : measure_triad;
    return measure_knows(name) ? name : "";
}

static const struct command_option options[] = {
    CMD_MODEL, CMD_FLAG(points, "print each measured point, too"),
    CMD_FIGURES, COMMAND_END
};
static const struct command_option operands[] = {
    { .value = "MNEMONIC",
      .kind = COMMAND_TEXT,
      .many = true,
      .optional = true,
      .offset = CMD_PLACE(files),
      .choice = measured_choice,
      .help = "a vector instruction, or TRIAD, the linked triad B + s A; ,H "
              "behind a name: on 32-bit operands" },
    COMMAND_END
};

const struct command time_command = {
    .name = "time",
    .summary = "measure the vector instructions",
    .function = run,
    .options = options,
    .operands = operands,
    .details = "Start-up, clocks per element, r-infinity and n-half of these "
               "instructions, or of all.",
};
