/* emission.c - generates points on a surface, and the directions in which it radiates,
 * on a machine. */
#include "rt/heat/emission.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "rt/heat/alias.h"
#include "rt/layout/program.h"
#include "rt/layout/record.h"
#include "rt/scene/transform.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/shape.h"
#include "rt/trace/form.h"

struct emission {
    struct emission_options options;
    struct object *program;
    struct image image;    /* the input except the choice */
    uint64_t choice, made; /* addresses of the choice and of the output */
};

/* ---- Input ---------------------------------------------------------------- */

static double determinant(const struct transform *map)
{
    const double(*rows)[4] = map->rows;
    double product[3];
    cross3(rows[1], rows[2], product);
    return dot3(rows[0], product);
}

/* Writes the matrix that maps normals to world space: the transposed inverse. It is
 * negated for an inverted solid. */
static void put_to_face(struct record *record, const struct transform *inverse,
                        bool inverted)
{
    double words[9], side = inverted ? -1 : 1;
    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++)
            words[3 * i + j] = side * inverse->rows[j][i];
    record_numbers(record, "EMISSION_TO_FACE", words, 9);
}

static void put_place(struct record *record, const struct primitive *primitive,
                      const struct emitter *emitter)
{
    struct transform map = transform_then(&emitter->to_own, &primitive->to_world);
    struct transform inverse;
    double area = emitter->area * fabs(determinant(&map));
    if (!transform_invert(&map, &inverse))
        layout_fail(record->layout,
                    "the transformation of the object of line %zu cannot be inverted",
                    primitive->line);
    record_numbers(record, "EMISSION_AREA", &area, 1);
    record_numbers(record, "EMISSION_TO_WORLD", map.rows[0], 12);
    put_to_face(record, &inverse, primitive->inverted);
}

/* Fills the columns of the alias table: the shares, then the aliases, then a column for
 * each word of a piece. */
static void fill_columns(const struct emitter *emitter, const double *share,
                         const size_t *alias, c205_word *columns)
{
    size_t count = emitter->piece_count;
    put_numbers(columns, share, count);
    for (size_t i = 0; i < count; i++) {
        const double *piece = emitter->pieces + emitter->piece_words * i;
        columns[count + i] = c205_from_integer((int64_t)alias[i]);
        for (size_t k = 0; k < emitter->piece_words; k++)
            columns[(2 + k) * count + i] = c205_from_double(piece[k]);
    }
}

static size_t table_size(const struct emitter *emitter)
{
    return emitter->piece_count > 0 ? emitter->piece_count * (2 + emitter->piece_words)
                                    : 0;
}

static void put_pieces(struct record *record, const struct emitter *emitter)
{
    size_t count = emitter->piece_count, size = table_size(emitter);
    double *share = malloc((count + 1) * sizeof *share);
    size_t *alias = malloc((count + 1) * sizeof *alias);
    c205_word *columns = malloc((size + 1) * sizeof *columns);
    if (!share || !alias || !columns
        || !alias_build(emitter->areas, count, share, alias)) {
        layout_fail(record->layout, "out of memory");
    } else {
        record_check(record, emitter->pieces, emitter->piece_words * count);
        fill_columns(emitter, share, alias, columns);
        record_table(record, "EMISSION_TABLE", columns, size);
    }
    record_integer(record, "EMISSION_COUNT", count);
    free(share);
    free(alias);
    free(columns);
}

static bool lay_out_emitter(struct emission *emission,
                            const struct primitive *primitive,
                            const struct emitter *emitter, c205_error *error)
{
    struct record_layout layout = { .image = &emission->image,
                                    .program = emission->program,
                                    .error = error,
                                    .free = program_end(emission->program) };
    struct record record;
    record_begin(&record, &layout, "EMISSION_SIZE", 1, table_size(emitter));
    record.line = primitive->line;
    layout_word(&layout, "emission_arguments", record.address);
    put_place(&record, primitive, emitter);
    record_numbers(&record, "EMISSION_FORM", emitter->form, EMITTER_FORM);
    record_routine(&record, "EMISSION_KERNEL", emitter->kernel);
    if (emitter->piece_count > 0)
        put_pieces(&record, emitter);
    record_write(&record);
    record_end(&record);
    emission->choice = layout_symbol(&layout, "points_arguments");
    emission->made = layout_symbol(&layout, "emission_results");
    return !layout.failed;
}

/* ---- The program ---------------------------------------------------------- */

static bool check_options(const struct emission_options *options, c205_error *error)
{
    if (options->mode >= TRACE_FORMS)
        return error_set(error, "the form of emission must be scalar or vector");
    if (options->points < 1 || options->points > MAX_EMISSION)
        return error_set(error, "%zu points: the number must be between 1 and %d",
                         options->points, MAX_EMISSION);
    if (options->mode == TRACE_VECTOR
        && (options->queue < 1 || options->queue > MAX_EMISSION))
        return error_set(error,
                         "a queue of %zu points: the length must be between 1 and %d",
                         options->queue, MAX_EMISSION);
    return true;
}

static bool assemble_emission(struct emission *emission, c205_error *error)
{
    const struct emission_options *options = &emission->options;
    const struct asm_define defines[] = {
        { "POINTS", (int64_t)options->points },
        { "LATTICE", options->lattice },
        { options->mode == TRACE_VECTOR ? "QUEUE" : NULL, (int64_t)options->queue },
        { NULL, 0 },
    };
    emission->program = form_assemble_beside("heat/emission", options->mode, defines,
                                             error);
    return emission->program != NULL;
}

static const char *find_emitter(const struct primitive *primitive,
                                struct emitter *emitter)
{
    const struct shape *shape = shape_of(primitive);
    *emitter = (struct emitter){ .to_own = placement_none.to_world };
    return shape->emit ? shape->emit(primitive, emitter)
                       : "only lines can sample its surface";
}

const char *emission_refusal(const struct primitive *primitive)
{
    struct emitter emitter;
    const char *fault = find_emitter(primitive, &emitter);
    emitter_free(&emitter);
    return fault;
}

static bool prepare(struct emission *emission, const struct primitive *primitive,
                    c205_error *error)
{
    struct emitter emitter;
    const char *fault = find_emitter(primitive, &emitter);
    bool good = !fault && check_options(&emission->options, error)
                && assemble_emission(emission, error)
                && lay_out_emitter(emission, primitive, &emitter, error);
    if (fault)
        error_set(error, "the %s of line %zu: %s", primitive_kind_name(primitive->kind),
                  primitive->line, fault);
    emitter_free(&emitter);
    return good;
}

struct emission *emission_new(const struct primitive *primitive,
                              const struct emission_options *options, c205_error *error)
{
    struct emission *emission = calloc(1, sizeof *emission);
    if (!emission) {
        error_set(error, "out of memory");
        return NULL;
    }
    emission->options = *options;
    if (prepare(emission, primitive, error))
        return emission;
    emission_free(emission);
    return NULL;
}

void emission_free(struct emission *emission)
{
    if (!emission)
        return;
    image_free(&emission->image);
    object_free(emission->program);
    free(emission);
}

/* ---- Runs ----------------------------------------------------------------- */

static bool load_choice(const struct emission *emission, c205 *machine,
                        const struct emission_choice *choice, c205_error *error)
{
    /* The machine represents integers by words with the exponent 0, so these integers
     * need no conversion. */
    const c205_word words[] = { choice->seed, choice->first, choice->m, choice->shift };
    return c205_load(machine, &emission->program->program, error)
           && image_load(&emission->image, machine, error)
           && (c205_write(machine, emission->choice, words,
                          sizeof words / sizeof *words)
               || error_set(error, "out of memory"));
}

c205 *emission_load(const struct emission *emission,
                    const struct emission_choice *choice, c205_error *error)
{
    c205 *machine = c205_new(emission->options.model, error);
    if (machine && load_choice(emission, machine, choice, error))
        return machine;
    c205_free(machine);
    return NULL;
}

bool emission_run(const struct emission *emission, const struct emission_choice *choice,
                  c205_word *planes, struct accounts *accounts, c205_error *error)
{
    size_t words = EMITTED_PLANES * emission->options.points;
    c205 *machine = emission_load(emission, choice, error);
    bool good = machine && program_run(machine, NULL, NULL, NULL, error)
                && ((c205_read(machine, emission->made, planes, words)
                     && (!accounts || accounts_add(accounts, machine)))
                    || error_set(error, "out of memory"));
    c205_free(machine);
    return good;
}

const struct object *emission_program(const struct emission *emission)
{
    return emission->program;
}

struct emission_choice emission_choose(bool lattice, uint64_t seed, size_t points,
                                       size_t place)
{
    struct emission_choice choice = { .seed = seed, .shift = place };
    while (choice.m < 20 && (UINT64_C(1) << choice.m) < points)
        choice.m++;
    if (!lattice)
        choice.first = place * points;
    return choice;
}
