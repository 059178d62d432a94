/* roots.c - finds the real roots of polynomials on a machine. */
#include "rt/roots/roots.h"

#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "base/plural.h"
#include "rt/layout/program.h"
#include "rt/trace/form.h"

/* The planes of the polynomials and of the results in the machine's memory, as in
 * rt/kernels/roots/roots.s. */
struct planes {
    uint64_t coefficients, bound, inputs;
    uint64_t count, roots, results;
};

enum { COEFFICIENTS = 5 }; /* number of coefficients of a polynomial */

struct root_search {
    struct roots_options options;
    struct object *program;
    c205 *machine;
    size_t count;
    uint64_t inputs, results; /* addresses of the first planes */
    struct planes planes;
};

static struct object *assemble_roots(const struct roots_options *options,
                                     c205_error *error)
{
    struct asm_define defines[] = { { "QUEUE", (int64_t)options->queue },
                                    { NULL, 0 },
                                    { NULL, 0 } };
    if (options->falsi != FALSI_DEFAULT) {
        defines[1].name = "FALSI";
        defines[1].value = options->falsi;
    }
    return form_assemble_beside("roots/roots", options->mode, defines, error);
}

static bool write_symbol(struct root_search *search, const char *name, c205_word word,
                         c205_error *error)
{
    const struct asm_symbol *symbol = object_symbol(search->program, name);
    if (symbol && c205_write(search->machine, (uint64_t)symbol->value, &word, 1))
        return true;
    return error_set(error, "cannot write the symbol %s of the program", name);
}

static bool read_symbol(const struct root_search *search, const char *name,
                        uint64_t *value, c205_error *error)
{
    const struct asm_symbol *symbol = object_symbol(search->program, name);
    if (!symbol)
        return error_set(error, "the program has no symbol %s", name);
    *value = (uint64_t)symbol->value;
    return true;
}

static bool find_planes(struct root_search *search, c205_error *error)
{
    struct planes *planes = &search->planes;
    return read_symbol(search, "INPUT_COEFFICIENTS", &planes->coefficients, error)
           && read_symbol(search, "INPUT_BOUND", &planes->bound, error)
           && read_symbol(search, "INPUT_SIZE", &planes->inputs, error)
           && read_symbol(search, "RESULT_COUNT", &planes->count, error)
           && read_symbol(search, "RESULT_ROOTS", &planes->roots, error)
           && read_symbol(search, "RESULT_SIZE", &planes->results, error);
}

static uint64_t plane_address(const struct root_search *search, uint64_t first,
                              uint64_t plane)
{
    return first + UINT64_C(64) * search->count * plane;
}

static bool write_plane(struct root_search *search, uint64_t first, uint64_t plane,
                        const c205_word *words)
{
    return c205_write(search->machine, plane_address(search, first, plane), words,
                      search->count);
}

static bool read_plane(const struct root_search *search, uint64_t plane,
                       c205_word *words)
{
    return c205_read(search->machine, plane_address(search, search->results, plane),
                     words, search->count);
}

/* Writes the input. The numbers of roots are initially indefinite, so that the host can
 * see from the machine's memory which polynomials are done. */
static bool write_planes(struct root_search *search,
                         const struct polynomial *polynomials)
{
    const struct planes *planes = &search->planes;
    c205_word *words = malloc((search->count + 1) * sizeof *words);
    bool good = words != NULL;
    for (uint64_t k = 0; good && k < COEFFICIENTS; k++) {
        for (size_t i = 0; i < search->count; i++)
            words[i] = polynomials[i].c[k];
        good = write_plane(search, search->inputs, planes->coefficients + k, words);
    }
    for (size_t i = 0; good && i < search->count; i++)
        words[i] = polynomials[i].bound;
    good = good && write_plane(search, search->inputs, planes->bound, words);
    for (size_t i = 0; good && i < search->count; i++)
        words[i] = C205_INDEFINITE;
    good = good && write_plane(search, search->results, planes->count, words);
    free(words);
    return good;
}

static bool lay_out_polynomials(struct root_search *search,
                                const struct polynomial *polynomials, c205_error *error)
{
    size_t count = search->count;
    search->inputs = program_end(search->program);
    search->results = program_round_up(
        plane_address(search, search->inputs, search->planes.inputs));
    if (count > 0
        && (!c205_map(search->machine, search->inputs,
                      (size_t)search->planes.inputs * count, C205_READ_ONLY, error)
            || !c205_map(search->machine, search->results,
                         (size_t)search->planes.results * count, C205_READ_WRITE,
                         error)))
        return false;
    if (count > 0 && !write_planes(search, polynomials))
        return error_set(error, "out of memory for the polynomials");
    return write_symbol(search, "roots_polynomials", c205_from_integer((int64_t)count),
                        error)
           && write_symbol(search, "roots_wanted",
                           c205_from_integer(search->options.first ? 1 : MAX_ROOTS),
                           error)
           && write_symbol(search, "roots_inputs", search->inputs, error)
           && write_symbol(search, "roots_results", search->results, error);
}

static bool prepare(struct root_search *search, const struct polynomial *polynomials,
                    c205_error *error)
{
    search->program = assemble_roots(&search->options, error);
    if (!search->program)
        return false;
    search->machine = c205_new(search->options.model, error);
    return search->machine != NULL
           && c205_load(search->machine, &search->program->program, error)
           && find_planes(search, error)
           && lay_out_polynomials(search, polynomials, error);
}

struct root_search *roots_new(const struct polynomial *polynomials, size_t count,
                              const struct roots_options *options, c205_error *error)
{
    struct root_search *search = calloc(1, sizeof *search);
    if (!search) {
        error_set(error, "out of memory");
        return NULL;
    }
    search->options = *options;
    search->count = count;
    if (prepare(search, polynomials, error))
        return search;
    roots_free(search);
    return NULL;
}

void roots_free(struct root_search *search)
{
    if (!search)
        return;
    c205_free(search->machine);
    object_free(search->program);
    free(search);
}

bool roots_watch(struct root_search *search, struct iterations *iterations)
{
    return iterations_begin(iterations, search->program,
                            search->options.mode == TRACE_VECTOR)
           && c205_listen(search->machine, iterations_listen, iterations);
}

/* Returns the index of the first polynomial whose roots are not yet computed, by binary
 * search. Its number of roots in the machine's memory is indefinite. */
static size_t done(const struct root_search *search)
{
    uint64_t counts = plane_address(search, search->results, search->planes.count);
    size_t low = 0, high = search->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        c205_word word = C205_INDEFINITE;
        c205_read(search->machine, counts + UINT64_C(64) * middle, &word, 1);
        if (word == C205_INDEFINITE)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

static bool report_polynomials(void *context, const c205 *machine)
{
    const struct root_search *search = context;
    const struct roots_options *options = &search->options;
    (void)machine;
    return options->progress(options->context, done(search), search->count);
}

bool roots_run(struct root_search *search, c205_error *error)
{
    const struct roots_options *options = &search->options;
    bool stopped = false;
    bool good = program_run(search->machine,
                            options->progress ? report_polynomials : NULL, search,
                            &stopped, error);
    if (good && options->progress)
        options->progress(options->context, search->count, search->count);
    if (stopped)
        error_set(error, "stopped after %zu of %zu polynomial%s", done(search),
                  search->count, plural(search->count));
    return good;
}

bool roots_read(const struct root_search *search, struct polynomial_roots *roots,
                c205_error *error)
{
    c205_word *words = malloc((search->count + 1) * sizeof *words);
    bool good = words != NULL;
    good = good
           && (search->count == 0 || read_plane(search, search->planes.count, words));
    for (size_t i = 0; good && i < search->count; i++)
        roots[i].count = (int)c205_to_double(words[i]);
    for (uint64_t k = 0; good && search->count > 0 && k < MAX_ROOTS; k++) {
        good = read_plane(search, search->planes.roots + k, words);
        for (size_t i = 0; good && i < search->count; i++)
            roots[i].root[k] = words[i];
    }
    free(words);
    return good || error_set(error, "out of memory for the roots");
}

enum falsi roots_falsi(const struct root_search *search)
{
    return falsi_of(search->program);
}

const c205 *roots_machine(const struct root_search *search)
{
    return search->machine;
}

/* ---- Rules of falsi ----------------------------------------------------- */

static const char *const rules[FALSI_RULES] = {
    [FALSI_PAPER] = "paper",
    [FALSI_ILLINOIS] = "illinois",
    [FALSI_PEGASUS] = "pegasus",
    [FALSI_ANDERSON_BJORCK] = "anderson-bjorck",
};

const char *falsi_name(enum falsi rule)
{
    return rules[rule];
}

bool falsi_named(const char *name, enum falsi *rule)
{
    for (int i = 0; i < FALSI_RULES; i++)
        if (strcmp(name, rules[i]) == 0) {
            *rule = (enum falsi)i;
            return true;
        }
    return false;
}

enum falsi falsi_of(const struct object *program)
{
    const struct asm_symbol *symbol = object_symbol(program, "FALSI");
    return symbol ? (enum falsi)symbol->value : FALSI_DEFAULT;
}
