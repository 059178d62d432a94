/* cmd_model.c - c205 model: lists the machine models and their constants. */
#include "asm/command/session.h"

struct model_arguments {
    struct shared_arguments shared;
    const char *name; /* NULL: list all */
};

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

static int show_models(const struct session *session)
{
    struct table *table = table_new(TABLE_COLUMNS(model_columns));
    const char *const *names = c205_model_names();
    for (; table && *names; names++) {
        c205_model *model = model_open(session->command, *names);
        if (!model) {
            table_free(table);
            return CMD_FAILED;
        }
        table_text(table, c205_model_name(model));
        table_count(table, c205_model_size(model));
        table_text(table, c205_model_title(model));
        c205_model_free(model);
    }
    return output_show(&session->results, table, "models", "Models");
}

static int show_constants(const struct session *session)
{
    const c205_model *model = session->model;
    const struct command_output *results = &session->results;
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
    if (results->json)
        provenance_json(model, results->json);
    return output_show(results, table, "constants", "Constants");
}

static int cmd_model(void *given)
{
    const struct model_arguments *args = given;
    struct session session = { .command = args->shared.command };
    bool good = session_output(&session, &args->shared.results, NULL)
                && (!args->name || session_model(&session, args->name));
    return session_close(&session, !good        ? CMD_FAILED
                                   : args->name ? show_constants(&session)
                                                : show_models(&session));
}

static const struct command_option options[] = { CMD_RESULTS, COMMAND_END };
static const struct command_option operands[] = {
    { OPERAND_ROW("NAME|FILE", COMMAND_INPUT, offsetof(struct model_arguments, name),
                  "a model whose constants are printed"),
      .optional = true, .choice = command_model_choice },
    COMMAND_END
};

const struct command model_command = {
    COMMAND_ROW("model", cmd_model, struct model_arguments,
                "list machine models and their constants"),
    .details =
        "Lists the built-in models. With an argument: the constants of that model, "
        "each with its unit and source.",
};
