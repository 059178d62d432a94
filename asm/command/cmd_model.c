/* cmd_model.c - c205 model: lists the machine models and their constants. */
#include "asm/command/c205_command.h"

static const struct table_column model_columns[] = {
    { "name", "model", TABLE_TEXT, 0 },
    { "constants", "constants", TABLE_COUNT, 0 },
    { "title", "title", TABLE_TEXT, 0 },
};

static const struct table_column constant_columns[] = {
    { "name", "constant", TABLE_TEXT, 0 }, { "text", "value", TABLE_TEXT, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },     { "source", "source", TABLE_TEXT, 0 },
    { "remark", "remark", TABLE_TEXT, 0 },
};

static int show_models(const char *command, const struct command_output *results)
{
    struct table *table = table_new(TABLE_COLUMNS(model_columns));
    const char *const *names = c205_model_names();
    for (; table && *names; names++) {
        c205_model *model = model_open(command, *names);
        if (!model) {
            table_free(table);
            return CMD_FAILED;
        }
        table_text(table, c205_model_name(model));
        table_count(table, c205_model_size(model));
        table_text(table, c205_model_title(model));
        c205_model_free(model);
    }
    return output_show(results, table, "models", "Models");
}

static int show_constants(const c205_model *model, const struct command_output *results)
{
    struct command_output head = *results;
    struct table *table = table_new(TABLE_COLUMNS(constant_columns));
    for (size_t i = 0; table && i < c205_model_size(model); i++) {
        const c205_constant *constant = c205_model_constant(model, i);
        char source[2] = { constant->source, '\0' };
        table_text(table, constant->name);
        table_text(table, constant->text);
        table_text(table, constant->unit);
        table_text(table, source);
        table_text(table, constant->remark);
    }
    output_printf(results, "%s\n", c205_model_title(model));
    head.provenance = true;
    output_model(&head, model);
    if (results->json) {
        provenance_json(model, results->json);
    }
    return output_show(results, table, "constants", "Constants");
}

static int show(const char *command, const char *name,
                const struct command_output *results)
{
    if (!name) {
        return show_models(command, results);
    }
    c205_model *model = model_open(command, name);
    if (!model) {
        return CMD_FAILED;
    }
    int code = show_constants(model, results);
    c205_model_free(model);
    return code;
}

static int run(void *given)
{
    const struct c205_arguments *arguments = given;
    struct command_output results = arguments->results;
    if (!output_open(&results, arguments->command, NULL)) {
        return CMD_FAILED;
    }
    int code = show(arguments->command, arguments->file, &results);
    return output_close(&results, code);
}

static const struct command_option options[] = { CMD_RESULTS, COMMAND_END };
static const struct command_option operands[] = {
    { .value = "NAME|FILE",
      .kind = COMMAND_INPUT,
      .optional = true,
      .offset = CMD_PLACE(file),
      .choice = command_model_choice,
      .help = "a model whose constants are printed" },
    COMMAND_END
};

const struct command model_command = {
    .name = "model",
    .summary = "list machine models and their constants",
    .function = run,
    .arguments_size = sizeof(struct c205_arguments),
    .options = options,
    .operands = operands,
    .details =
        "Lists the built-in models. With an argument: the constants of that model, "
        "each with its unit and source.",
};
