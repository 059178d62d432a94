/* points.c - computes the random stream and the lattice by their definitions, and by a
 * program of the machine (points.h). */
#include "tests/oracle/points.h"

#include <stdlib.h>

#include "vm/error.h"
#include "rt/layout/program.h"
#include "rt/trace/form.h"

/* ---- By the definition --------------------------------------------------- */

static const uint64_t mask = (UINT64_C(1) << 47) - 1;

/* Products of unsigned integers are exact in their low 64, and low 47, bits. */
uint64_t stream_state_at(uint64_t p)
{
    if (p == 0)
        return 1;
    uint64_t root = stream_state_at(p / 2);
    return root * root * (p % 2 ? UINT64_C(44485709377909) : 1) & mask;
}

/* The integer nearest to 2^45 / golden ratio. */
static const uint64_t seed_apart = UINT64_C(21745137823721);

uint64_t stream_mixed(uint64_t x)
{
    x = (x ^ x >> 23) * UINT64_C(0x5851F42D4C95) & mask;
    return x ^ x >> 24;
}

uint64_t stream_position(uint64_t seed, uint64_t ray, unsigned draw)
{
    return (seed * seed_apart + STREAM_DRAWS * ray + draw + 1) & mask;
}

uint64_t stream_word(uint64_t seed, uint64_t ray, unsigned draw)
{
    return stream_mixed(stream_state_at(stream_position(seed, ray, draw)));
}

uint64_t lattice_word(unsigned m, uint64_t seed, uint64_t shift, uint64_t i,
                      unsigned coordinate)
{
    static const uint64_t z[LATTICE_COORDINATES] = { 1,      182667, 469891,
                                                     498753, 110745, 446247 };
    uint64_t p = seed * seed_apart - 7 * (shift + 1) + coordinate + 1;
    uint64_t cells = UINT64_C(1) << (47 - m);
    return (i * z[coordinate] * cells + (stream_mixed(stream_state_at(p & mask)) | 1))
           & mask;
}

/* ---- By the machine ------------------------------------------------------ */

struct point_maker {
    struct point_kind kind;
    struct object *program;
    c205_model *model;
    c205 *machine;
    uint64_t given, made; /* addresses of input and output */
};

static bool prepare(struct point_maker *maker, c205_error *error)
{
    const struct point_kind *kind = &maker->kind;
    const struct asm_define defines[] = {
        { "QUEUE", (int64_t)kind->queue },
        { "POINTS", (int64_t)kind->points },
        { "LATTICE", kind->lattice },
        { "COORDINATES", (int64_t)kind->coordinates },
        { "NUMBERS", kind->numbers },
        { NULL, 0 },
    };
    maker->program = form_assemble_beside("points/points",
                                          kind->form == POINTS_SCALAR ? TRACE_SCALAR
                                                                      : TRACE_VECTOR,
                                          defines, error);
    if (!maker->program)
        return false;
    maker->given = (uint64_t)object_symbol(maker->program, "points_arguments")->value;
    maker->made = (uint64_t)object_symbol(maker->program, "points_results")->value;
    maker->model = c205_model_find("cyber205-2pipe", error);
    maker->machine = maker->model ? c205_new(maker->model, error) : NULL;
    return maker->machine != NULL;
}

struct point_maker *point_maker_new(const struct point_kind *kind, c205_error *error)
{
    struct point_maker *maker = calloc(1, sizeof *maker);
    if (!maker) {
        error_set(error, "out of memory");
        return NULL;
    }
    maker->kind = *kind;
    if (prepare(maker, error))
        return maker;
    point_maker_free(maker);
    return NULL;
}

void point_maker_free(struct point_maker *maker)
{
    if (!maker)
        return;
    c205_free(maker->machine);
    c205_model_free(maker->model);
    object_free(maker->program);
    free(maker);
}

c205 *point_maker_load(struct point_maker *maker, const struct point_choice *choice,
                       c205_error *error)
{
    /* An integer of the machine has the exponent 0. */
    c205_word given[] = { choice->seed, choice->first, choice->m, choice->shift };
    if (!c205_load(maker->machine, &maker->program->program, error))
        return NULL;
    c205_write(maker->machine, maker->given, given, sizeof given / sizeof *given);
    return maker->machine;
}

bool point_maker_run(struct point_maker *maker, const struct point_choice *choice,
                     c205_word *words, c205_error *error)
{
    c205 *machine = point_maker_load(maker, choice, error);
    return machine && program_run(machine, NULL, NULL, NULL, error)
           && c205_read(machine, maker->made, words,
                        maker->kind.points * maker->kind.coordinates);
}

const struct object *point_maker_program(const struct point_maker *maker)
{
    return maker->program;
}
