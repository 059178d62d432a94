/* named_model.c - opens machine models and reports their errors with the line. */
#include "base/named_model.h"

#include "base/command_error.h"
#include "base/diagnostic.h"
#include "vm/error.h"
#include "base/file.h"
#include "base/outputs.h"
#include "base/text_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static struct position position_of(const char *name, const char *text,
                                   const c205_place *place)
{
    struct position position = { .file = name,
                                 .line = place->line,
                                 .column = place->column };
    for (unsigned line = 1; line < place->line; line++)
        text += strcspn(text, "\n") + 1;
    position.source = text;
    position.source_length = strcspn(text, "\n");
    return position;
}

static c205_model *read_model(const char *command, const char *name, const char *text)
{
    c205_error error;
    c205_place place;
    c205_model *model = c205_model_read(name, text, &place, &error);
    if (!model && place.line) {
        struct position position = position_of(name, text, &place);
        struct diagnostics found = { 0 };
        diagnostics_add(&found, SEVERITY_ERROR, &position, error.message);
        diagnostics_print(&found, stderr);
        diagnostics_free(&found);
    } else if (!model) {
        cmd_failed(command, "%s", error.message);
    }
    return model;
}

static c205_model *open_file(const char *command, const char *name)
{
    c205_error error;
    size_t length;
    char *text = text_file_read(name, FILE_LARGEST, &length, &error);
    c205_model *model = NULL;
    if (!text)
        cmd_failed(command, "cannot read %s: %s", name, error.message);
    else if (memchr(text, '\0', length))
        cmd_failed(command, "cannot read %s: not a text file", name);
    else
        model = read_model(command, name, text);
    free(text);
    return model;
}

c205_model *model_find(const char *name, c205_error *error)
{
    struct stat status;
    if (c205_model_is_file(name) && stat(name, &status) == 0
        && outputs_refuse(&status)) {
        error_set(error, "cannot read %.180s: %s", name, file_reason(ETXTBSY));
        return NULL;
    }
    return c205_model_find(name, error);
}

c205_model *model_open(const char *command, const char *name)
{
    c205_error error;
    c205_model *model;
    if (!name)
        name = C205_DEFAULT_MODEL;
    if (c205_model_is_file(name))
        return open_file(command, name);
    model = c205_model_find(name, &error);
    if (!model)
        cmd_failed(command, "%s", error.message);
    return model;
}

const char *command_model_choice(size_t number)
{
    return c205_model_names()[number];
}
