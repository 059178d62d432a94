/* remarks.c - finds properties of an answer that suggest that it does not solve the
 * exercise. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "asm/lesson/lesson_internal.h"
#include "asm/object/object_file.h"
#include "asm/view/operand_view.h"
#include "vm/error.h"
#include "vm/hash.h"

/* ---- The code -------------------------------------------------------------- */

/* Numbers the registers of a program in the order of their first use. */
struct renaming {
    uint16_t names[C205_REGISTERS];
    uint16_t count;
};

static uint64_t rename_register(struct renaming *renaming, unsigned number)
{
    if (number == 0)
        return 0;
    if (renaming->names[number] == 0)
        renaming->names[number] = ++renaming->count;
    return renaming->names[number];
}

/* Adds an instruction to a hash. Addresses are omitted, because they depend on the
 * order of the data. */
static uint64_t hash_instruction(uint64_t hash, struct renaming *renaming,
                                 const struct instruction_view *view)
{
    enum { MIN_ADDRESS = 1 << 16 };
    const c205_fields *fields = &view->fields;
    int64_t immediate = fields->immediate;
    bool number = immediate < MIN_ADDRESS && immediate > -MIN_ADDRESS;
    hash = hash_text(hash, view->insn->mnemonic);
    hash = hash_word(hash, fields->g);
    hash = hash_word(hash, number ? (uint64_t)immediate : MIN_ADDRESS);
    for (size_t i = 0; i < view->count; i++) {
        const struct operand_view *operand = &view->operands[i];
        if (!operand->field)
            continue;
        hash = hash_word(hash, (unsigned char)operand->field);
        hash = hash_word(hash, rename_register(renaming, operand->number));
        hash = hash_word(hash, rename_register(renaming, operand->offset));
    }
    return hash;
}

static uint64_t hash_line(uint64_t hash, struct renaming *renaming, const c205 *machine,
                          const struct asm_line *line)
{
    uint64_t at = line->address, end = at + 32 * line->halves;
    while (at < end) {
        struct instruction_view view = { .insn = NULL };
        view_decode(&view, machine, at);
        if (!view.insn)
            return hash;
        hash = hash_instruction(hash, renaming, &view);
        at += 32 * (uint64_t)view.halves;
    }
    return hash;
}

static bool code_hash(const struct object *object, uint64_t *hash, c205_error *error)
{
    struct renaming renaming = { .count = 0 };
    c205_model *model = c205_model_find(C205_DEFAULT_MODEL, error);
    c205 *machine = model ? c205_new(model, error) : NULL;
    bool good = machine && c205_load(machine, &object->program, error);
    *hash = HASH_BEGIN;
    for (size_t i = 0; good && i < object->line_count; i++)
        if (object->lines[i].is_code)
            *hash = hash_line(*hash, &renaming, machine, &object->lines[i]);
    c205_free(machine);
    c205_model_free(model);
    return good;
}

/* Returns the hash of a program, or 0. */
static uint64_t text_hash(const char *text, c205_error *error)
{
    static const struct asm_options options = { .sealed = true };
    struct diagnostics said = { 0 };
    struct object *object = assemble_text("text.s", text, &options, &said);
    uint64_t hash = 0;
    if (object && !code_hash(object, &hash, error))
        hash = 0;
    diagnostics_free(&said);
    object_free(object);
    return hash;
}

void lesson_remark_same_code(struct lesson_verdict *verdict, const char *other)
{
    report_printf(&verdict->remarks, "The same code as %.900s.", other);
}

void lesson_compare_code(struct lesson_verdict *verdict, const struct object *object)
{
    c205_error error;
    uint64_t hash;
    if (!object_check(object, &error) || !code_hash(object, &hash, &error)
        || hash == text_hash(verdict->lesson->start, &error))
        return;
    verdict->code = hash;
    if (hash == text_hash(verdict->lesson->solution, &error))
        lesson_remark_same_code(verdict, "solution.s");
}

/* ---- The inputs ------------------------------------------------------------ */

/* The state of the search for inputs that an answer does not read. */
struct unread_search {
    const struct lesson_verdict *verdict;
    const char *text;
    size_t length;
    size_t count;
    const char **labels; /* of the inputs that no test has read so far */
    c205_error *error;
};

/* Runs a test without an input. Returns false if memory is exhausted. */
static bool try_without(const struct unread_search *search,
                        const struct lesson_trial *trial, const struct test_case *test,
                        const char *label, bool *read)
{
    struct arena kept = { 0 };
    struct lesson_report report = { .kept = &kept };
    struct answer_run run = { .name = search->verdict->answer,
                              .text = search->text,
                              .length = search->length,
                              .test = test,
                              .spoilt = label,
                              .limit = trial->clocks + 1,
                              .report = &report,
                              .general = &report,
                              .kept = &kept,
                              .error = search->error };
    bool good = answer_run(&run);
    *read = !good || !answer_is_right(&run) || run.clocks != trial->clocks;
    answer_run_free(&run);
    arena_free(&kept);
    return good;
}

/* Removes the inputs that the answer reads in a test. */
static bool remove_read(struct unread_search *search, const struct lesson_trial *trial,
                        const struct test_case *test)
{
    bool good = true;
    size_t kept = 0;
    for (size_t i = 0; good && i < search->count; i++) {
        bool read;
        good = try_without(search, trial, test, search->labels[i], &read);
        if (!read)
            search->labels[kept++] = search->labels[i];
    }
    search->count = kept;
    return good;
}

/* Lists the labels of inputs that are not results, too. */
static bool list_inputs(struct unread_search *search, const struct object *test)
{
    search->labels = calloc(test->symbol_count + 1, sizeof *search->labels);
    for (size_t i = 0; search->labels && i < test->symbol_count; i++) {
        const struct asm_symbol *symbol = &test->symbols[i];
        if (test_holds_data(symbol) && !lesson_wanted(symbol->name)
            && !test_wants(test, symbol->name))
            search->labels[search->count++] = symbol->name;
    }
    return search->labels || error_set(search->error, "out of memory");
}

bool lesson_find_unread(struct lesson_verdict *verdict, const struct test_case *tests,
                        const char *text, size_t length, c205_error *error)
{
    struct unread_search search = { verdict, text, length, 0, NULL, error };
    bool good = list_inputs(&search, tests[0].object);
    for (size_t i = 0; good && search.count > 0 && i < verdict->lesson->test_count; i++)
        good = remove_read(&search, &verdict->trials[i], &tests[i]);
    for (size_t i = 0; good && i < search.count; i++)
        report_printf(&verdict->remarks, "It does not read %s.", search.labels[i]);
    free(search.labels);
    return good;
}
