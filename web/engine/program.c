/* program.c - the requests `load` and `breaks`. Assembles a program and creates its
 * debugger.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "asm/check/expect.h"
#include "asm/object/object_file.h"
#include "base/array.h"
#include "vm/text.h"
#include "web/engine/engine_internal.h"

/* ---- Diagnostics ----------------------------------------------------------------- */

static const char *severity_name(enum severity severity)
{
    switch (severity) {
    case SEVERITY_ERROR: return "error";
    case SEVERITY_WARNING: return "warning";
    case SEVERITY_REPORT: return "report";
    default: return "said";
    }
}

/* Returns the length of the word at the column of a message, which an editor
 * underlines. */
static size_t length_of(const struct diagnostic *diagnostic)
{
    const char *source = diagnostic->source;
    size_t column = diagnostic->column, length;
    if (!source || column == 0 || column > strlen(source))
        return 1;
    length = strcspn(source + column - 1, " \t\n,;[]()+-*/\"");
    return length > 0 ? length : 1;
}

void put_diagnostic(const struct diagnostic *diagnostic, struct json *reply)
{
    json_object(reply, NULL);
    json_text(reply, "severity", severity_name(diagnostic->severity));
    json_text(reply, "file", diagnostic->file ? diagnostic->file : "");
    json_count(reply, "line", diagnostic->line);
    json_count(reply, "column", diagnostic->column);
    json_count(reply, "length", length_of(diagnostic));
    json_text(reply, "message", diagnostic->message ? diagnostic->message : "");
    json_end(reply);
}

void put_diagnostics(const struct diagnostics *diagnostics, struct json *reply)
{
    json_array(reply, "diagnostics");
    for (size_t i = 0; i < diagnostics->count; i++)
        put_diagnostic(&diagnostics->items[i], reply);
    json_end(reply);
}

/* ---- Options ------------------------------------------------------------- */

static bool is_object(const struct json_value *value)
{
    return !value || value->kind == JSON_OBJECT;
}

enum { MAX_DEFINES = 100 }; /* the maximum of a sweep */

/* Reads a member such as "defines": { "n": 100 }. */
static bool take_defines(const struct json_value *request, struct arena *arena,
                         struct asm_options *options, c205_error *error)
{
    const struct json_value *defines = json_member(request, "defines");
    size_t count = json_length(defines);
    struct asm_define *list = arena_take(arena, (count + 1) * sizeof *list);
    options->defines = list;
    if (!list)
        return error_set(error, "out of memory");
    if (!is_object(defines) || count > MAX_DEFINES)
        return error_set(error, "\"defines\" must have at most %d names with integers",
                         MAX_DEFINES);
    for (const struct json_value *item = defines ? defines->first : NULL; item;
         item = item->next, list++) {
        if (item->kind != JSON_NUMBER
            || !json_member_whole(defines, item->key, &list->value))
            return error_set(error, "\"defines\" must have names with integers");
        list->name = arena_text(arena, item->key, strlen(item->key));
    }
    return true;
}

/* Reads a member such as "files": { "data.inc": "..." }. The program can include these
 * files and the library. */
static bool take_files(const struct json_value *request, struct arena *arena,
                       struct asm_options *options, c205_error *error)
{
    const struct json_value *files = json_member(request, "files");
    size_t count = is_object(files) ? json_length(files) : 0;
    struct text *texts = arena_take(arena, (count + 1) * sizeof *texts);
    const struct text **tables = arena_take(arena, 2 * sizeof *tables);
    const char **lines = arena_take(arena, (2 * count + 1) * sizeof *lines);
    if (!is_object(files))
        return error_set(error, "\"files\" must have names with strings");
    if (!texts || !tables || !lines)
        return error_set(error, "out of memory");
    tables[0] = texts;
    options->texts = tables;
    for (const struct json_value *item = files ? files->first : NULL; item;
         item = item->next, texts++, lines += 2) {
        if (item->kind != JSON_TEXT)
            return error_set(error, "\"files\" must have names with strings");
        lines[0] = arena_text(arena, item->text, strlen(item->text));
        texts->name = arena_text(arena, item->key, strlen(item->key));
        texts->lines = lines;
    }
    return true;
}

bool take_options(const struct json_value *request, struct arena *arena,
                  struct asm_options *options, c205_error *error)
{
    options->sealed = true;
    return take_defines(request, arena, options, error)
           && take_files(request, arena, options, error)
           && (!arena->failed || error_set(error, "out of memory"));
}

bool uses_defines(const struct asm_options *options, struct object *const *objects,
                  size_t count, c205_error *error)
{
    const char *unused = asm_unused_define(options->defines, objects, count);
    return !unused
           || error_set(error, "'%.100s' is defined, but the program does not use it",
                        unused);
}

struct object *engine_assemble(struct engine *engine, const char *name,
                               const char *text, const struct asm_options *options,
                               c205_error *error)
{
    struct object *object = assemble_text(name, text, options, &engine->diagnostics);
    if (!object && engine->diagnostics.errors == 0)
        error_set(error, "out of memory");
    else if (!object)
        error_set(error, "%.100s cannot be assembled: %zu error%s", name,
                  engine->diagnostics.errors,
                  engine->diagnostics.errors == 1 ? "" : "s");
    return object;
}

/* Returns the model of a program. Only built-in models are accepted, because the engine
 * reads no files. */
c205_model *program_model(const char *name, const struct object *object,
                          c205_error *error)
{
    const char *own = expect_model(object);
    c205_model *model;
    name = name && *name ? name : own ? own : C205_DEFAULT_MODEL;
    if (c205_model_is_file(name)) {
        error_set(error, "'%.60s' is not a built-in model", name);
        return NULL;
    }
    model = c205_model_find(name, error);
    if (!model || !c205_model_is_projection(model))
        return model;
    c205_model_free(model);
    error_set(error, "programs cannot run on '%.60s', which only gives times", name);
    return NULL;
}

/* ---- Output of the program ----------------------------------------------- */

static void keep_mark(struct printed *printed, uint64_t step)
{
    struct printed_mark mark = { step, printed->text.length };
    if (printed->count > 0 && printed->marks[printed->count - 1].step == step) {
        printed->marks[printed->count - 1].length = printed->text.length;
        return;
    }
    if (!array_add(&printed->marks, &printed->count, &mark, sizeof mark))
        printed->cut = true;
}

void printed_forget(struct printed *printed, uint64_t step)
{
    while (printed->count > 0 && printed->marks[printed->count - 1].step > step) {
        printed->count--;
        printed->cut = false;
    }
    printed->text.length = printed->count > 0
                               ? printed->marks[printed->count - 1].length
                               : 0;
}

/* Stores the output of the instruction after the current step. Output of later steps is
 * dropped, because it belongs to an earlier run. */
static void print(void *context, const char *text, size_t length)
{
    struct engine *engine = context;
    struct printed *printed = &engine->printed;
    struct sink sink = text_buffer_sink(&printed->text);
    uint64_t step = debugger_step(engine->debugger) + 1;
    printed_forget(printed, step);
    if (printed->cut)
        return;
    printed->cut = length > MAX_PRINTED - printed->text.length;
    if (!printed->cut)
        sink.put(sink.context, text, length);
    keep_mark(printed, step);
    printed->cut |= printed->text.failed;
}

size_t printed_until(const struct printed *printed, uint64_t step)
{
    size_t low = 0, high = printed->count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (printed->marks[middle].step <= step)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0 ? printed->marks[low - 1].length : 0;
}

bool printed_is_cut(const struct printed *printed, uint64_t step)
{
    return printed->cut
           && (printed->count == 0 || printed->marks[printed->count - 1].step <= step);
}

static void forget_printed(struct printed *printed)
{
    text_buffer_free(&printed->text);
    free(printed->marks);
    *printed = (struct printed){ .count = 0 };
}

/* ---- The debugger -------------------------------------------------------- */

enum { MAX_HISTORY = 64 << 20 }; /* bytes; the page of a browser has little memory */

/* Creates the machine and adds the listeners of replays and of warnings. */
static c205 *make_machine(void *context, c205_error *error)
{
    struct engine *engine = context;
    c205 *machine = c205_new(engine->model, error);
    if (machine && object_check(engine->object, error)
        && c205_load(machine, &engine->object->program, error)
        && c205_listen(machine, replay_listen, engine)
        && c205_listen(machine, warnings_listen, engine))
        return machine;
    c205_free(machine);
    return NULL;
}

static bool make_debugger(struct engine *engine, c205_error *error)
{
    struct debugger_setup setup = { .object = engine->object,
                                    .name = engine->name,
                                    .model = engine->model,
                                    .out = text_buffer_sink(&engine->said),
                                    .printed = { print, engine },
                                    .printed_apart = true,
                                    .clocks_most = UINT64_MAX,
                                    .history = MAX_HISTORY,
                                    .interrupted = slice_is_over,
                                    .asked = engine,
                                    .machine = make_machine,
                                    .context = engine };
    engine->debugger = debugger_new(&setup, error);
    return engine->debugger;
}

void program_drop(struct engine *engine)
{
    debugger_free(engine->debugger);
    warnings_drop(engine);
    object_free(engine->object);
    c205_model_free(engine->model);
    free(engine->name);
    forget_printed(&engine->printed);
    engine->debugger = NULL;
    engine->object = NULL;
    engine->model = NULL;
    engine->name = NULL;
}

/* ---- load ---------------------------------------------------------------- */

size_t program_line(const struct engine *engine, uint64_t address)
{
    const struct asm_line *line = object_line(engine->object, address);
    return line && strcmp(line->shown.file, engine->name) == 0 ? line->shown.number : 0;
}

static void put_symbols(const struct object *object, struct json *reply)
{
    json_array(reply, "symbols");
    for (size_t i = 0; i < object->symbol_count; i++) {
        const struct asm_symbol *symbol = &object->symbols[i];
        json_object(reply, NULL);
        json_text(reply, "name", symbol->name);
        json_bool(reply, "label", symbol->is_label);
        if (symbol->is_word)
            put_hex(reply, "hex", (c205_word)symbol->value);
        else
            json_number(reply, "value", (double)symbol->value);
        json_text(reply, "contents", asm_contents_name(symbol->contents));
        json_count(reply, "count", symbol->count);
        json_end(reply);
    }
    json_end(reply);
}

static int compare_lines(const void *a, const void *b)
{
    size_t one = *(const size_t *)a, other = *(const size_t *)b;
    return (one > other) - (one < other);
}

/* Writes the numbers of the lines that have code, in ascending order. */
static bool put_lines(const struct engine *engine, struct json *reply,
                      c205_error *error)
{
    const struct object *object = engine->object;
    size_t *lines = calloc(object->line_count + 1, sizeof *lines);
    size_t count = 0;
    if (!lines)
        return error_set(error, "out of memory");
    for (size_t i = 0; i < object->line_count; i++) {
        size_t line = program_line(engine, object->lines[i].address);
        if (object->lines[i].is_code && line > 0)
            lines[count++] = line;
    }
    qsort(lines, count, sizeof *lines, compare_lines);
    json_array(reply, "lines");
    for (size_t i = 0; i < count; i++)
        if (i == 0 || lines[i] != lines[i - 1])
            json_count(reply, NULL, lines[i]);
    json_end(reply);
    free(lines);
    return true;
}

bool take_warm(const struct json_value *request, struct object *object,
               c205_error *error)
{
    return take_truth(request, "warm", &object->program.warm, error);
}

static bool begin_program(struct engine *engine, const char *name,
                          struct object *object, c205_model *model, c205_error *error)
{
    program_drop(engine);
    engine->object = object;
    engine->model = model;
    engine->name = copy_of(name);
    if (engine->name ? make_debugger(engine, error) && warnings_begin(engine, error)
                     : error_set(error, "out of memory"))
        return true;
    program_drop(engine);
    return false;
}

static bool load_program(struct engine *engine, const struct json_value *request,
                         const char *name, struct object *object, c205_error *error)
{
    const char *wanted = NULL;
    c205_model *model = NULL;
    if (take_text_or(request, "model", &wanted, error)
        && take_warm(request, object, error))
        model = program_model(wanted, object, error);
    if (model)
        return begin_program(engine, name, object, model, error);
    object_free(object);
    return false;
}

bool answer_load(struct engine *engine, const struct json_value *request,
                 struct json *reply, c205_error *error)
{
    const char *name = "program.s", *text;
    struct asm_options options = { .defines = NULL };
    struct arena arena = { 0 };
    struct object *object = NULL;
    if (take_text_or(request, "name", &name, error)
        && take_text(request, "text", &text, error)
        && take_options(request, &arena, &options, error))
        object = engine_assemble(engine, name, text, &options, error);
    if (object && !uses_defines(&options, &object, 1, error)) {
        object_free(object);
        object = NULL;
    }
    arena_free(&arena);
    if (!object || !load_program(engine, request, name, object, error))
        return false;
    json_text(reply, "name", name);
    json_text(reply, "model", c205_model_name(engine->model));
    json_bool(reply, "warm", object->program.warm);
    put_diagnostics(&engine->diagnostics, reply);
    put_symbols(object, reply);
    return put_lines(engine, reply, error);
}

/* ---- breaks -------------------------------------------------------------- */

/* Sets a breakpoint. Writes its actual line, or the reason for which it cannot be
 * set. */
static bool put_break(struct engine *engine, struct json *reply, int64_t wanted,
                      c205_error *error)
{
    size_t line = 0;
    bool reported = true;
    json_object(reply, NULL);
    json_number(reply, "wanted", (double)wanted);
    if (wanted < 1)
        json_text(reply, "message", "lines are counted from 1");
    else if (debugger_break_line(engine->debugger, engine->name, (size_t)wanted, &line))
        json_count(reply, "line", line);
    else
        reported = put_said(engine, reply, "message", error);
    json_end(reply);
    return reported;
}

bool answer_breaks(struct engine *engine, const struct json_value *request,
                   struct json *reply, c205_error *error)
{
    const struct json_value *lines = json_member(request, "lines");
    bool good = true;
    if (!lines || lines->kind != JSON_ARRAY)
        return error_set(error, "\"lines\" must be a list of line numbers");
    for (const struct json_value *line = lines->first; line; line = line->next)
        if (line->kind != JSON_NUMBER || line->number != floor(line->number)
            || fabs(line->number) > 1e9)
            return error_set(error, "\"lines\" must be a list of line numbers");
    debugger_forget_lines(engine->debugger);
    json_array(reply, "lines");
    for (const struct json_value *line = lines->first; line && good; line = line->next)
        good = put_break(engine, reply, (int64_t)line->number, error);
    json_end(reply);
    return good;
}
