/* cmd_model.c - c205 model: machine models and their constants. */
#include "asm/command/c205_command.h"

static const struct table_column model_columns[] = {
    { "name", "model", TABLE_TEXT, 0 },
    { "constants", "constants", TABLE_COUNT, 0 },
    { "title", "title", TABLE_TEXT, 0 },
};

static const struct table_column constant_columns[] = {
    { "name", "constant", TABLE_TEXT, 0 },
    { "text", "value", TABLE_TEXT, 0 },
    { "unit", "unit", TABLE_TEXT, 0 },
    { "source", "source", TABLE_TEXT, 0 },
    { "remark", "remark", TABLE_TEXT, 0 },
};

static int show_models(const char *command, struct json *json)
{
    struct table *table = table_new(TABLE_COLUMNS(model_columns));
    const char *const *names = c205_model_names();
    for (; table && *names; names++) {
        c205_model *model = cmd_find_model(command, *names);
        if (!model) {
            table_free(table);
            return CMD_FAILED;
        }
        table_text(table, c205_model_name(model));
        table_count(table, c205_model_size(model));
        table_text(table, c205_model_title(model));
        c205_model_free(model);
    }
    return cmd_show(command, table, json, "models");
}

static int show_constants(const char *command, const c205_model *model,
                          struct json *json)
{
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
    printf("%s\n", c205_model_title(model));
    provenance_print(model, "");
    if (json) {
        provenance_json(model, json);
    }
    return cmd_show(command, table, json, "constants");
}

static int show(const char *command, const char *name, struct json *json)
{
    if (!name) {
        return show_models(command, json);
    }
    c205_model *model = cmd_find_model(command, name);
    if (!model) {
        return CMD_FAILED;
    }
    int code = show_constants(command, model, json);
    c205_model_free(model);
    return code;
}

static int run(void *given)
{
    const struct cmd_arguments *arguments = given;
    struct json *json;
    if (!cmd_open_json(arguments, &json)) {
        return CMD_FAILED;
    }
    int code = show(arguments->command, arguments->file, json);
    return cmd_end_json(arguments, json, code);
}

static const struct command_option options[] = { CMD_JSON, COMMAND_END };
static const struct command_option operands[] = {
    { .value = "NAME|FILE",
      .kind = COMMAND_TEXT,
      .optional = true,
      .offset = CMD_PLACE(file),
      .choice = command_model_choice,
      .help = "a model, all of whose constants are told" },
    COMMAND_END
};

const struct command model_command = {
    .name = "model",
    .summary = "the machine models",
    .function = run,
    .options = options,
    .operands = operands,
    .details = "Lists the models that are built in; of one that is named the "
               "constants, each with its unit and its source.",
};
