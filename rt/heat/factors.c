#include "rt/heat/factors.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "rt/shapes/primitive.h"

/* Lines through points along their normals begin so far below them. */
static const double below = 1e-3;
/* What is within k_delta of a point is where it is. */
static const double near = 1e-7;

struct factors {
    const struct scene *scene;
    struct factors_options options;
    struct lines *normals, *rays;
};

/* ---- To begin ------------------------------------------------------------- */

static struct lines *begin_lines(const struct factors *factors, double behind,
                                 c205_error *error)
{
    const struct lines_options options = { .mode = factors->options.mode,
                                           .queue = factors->options.queue,
                                           .behind = behind,
                                           .model = factors->options.model };

    return lines_new(factors->scene, &options, error);
}

struct factors *factors_new(const struct scene *scene,
                            const struct factors_options *options,
                            c205_error *error)
{
    struct factors *factors;

    if (options->repeats < 2) {
        error_say(error, "errors come of two repeats or more");
        return NULL;
    }
    factors = calloc(1, sizeof *factors);
    if (!factors) {
        error_say(error, "no memory");
        return NULL;
    }
    factors->scene = scene;
    factors->options = *options;
    factors->normals = begin_lines(factors, below, error);
    if (factors->normals)
        factors->rays = begin_lines(factors, 0, error);
    if (factors->rays)
        return factors;
    factors_free(factors);
    return NULL;
}

void factors_free(struct factors *factors)
{
    if (!factors)
        return;
    lines_free(factors->normals);
    lines_free(factors->rays);
    free(factors);
}

/* ---- One repeat ------------------------------------------------------------ */

/* What is done of a repeat, and what it comes to. */
struct packet {
    struct emitted *points;
    struct scene_line *lines;
    size_t kept;   /* points, the first of the list */
    double area;   /* the sum of weights, 0 of points that went */
    double *share; /* .. by receiver */
};

static void put_line(const c205_word origin[3], const c205_word direction[3],
                     struct scene_line *line)
{
    for (int i = 0; i < 3; i++) {
        line->origin[i] = c205_to_double(origin[i]);
        line->direction[i] = c205_to_double(direction[i]);
    }
}

/* Those crossings that lines find, with what that took. */
static bool follow(const struct lines *lines, const struct scene_line *list,
                   size_t count, struct factor_row *row,
                   struct seen_crossings *found, c205_error *error)
{
    if (!lines_find(lines, list, count, found, error))
        return false;
    if (accounts_add_all(&row->accounts, &found->accounts))
        return true;
    seen_crossings_free(found);
    return error_say(error, "no memory");
}

/* Is the primitive seen where the line has its origin? */
static bool is_seen(const struct seen_crossings *found, size_t line,
                    size_t primitive)
{
    for (size_t k = found->first[line]; k < found->first[line + 1]; k++)
        if (found->list[k].primitive == primitive
            && fabs(c205_to_double(found->list[k].distance)) < near)
            return true;
    return false;
}

/* Points that are not on a face go. */
static bool keep_faces(const struct factors *factors, size_t primitive,
                       struct packet *packet, struct factor_row *row,
                       c205_error *error)
{
    size_t count = factors->options.points;
    struct seen_crossings found = { 0 };

    for (size_t i = 0; i < count; i++)
        put_line(packet->points[i].spot, packet->points[i].face,
                 &packet->lines[i]);
    if (!follow(factors->normals, packet->lines, count, row, &found, error))
        return false;
    packet->kept = 0;
    for (size_t i = 0; i < count; i++)
        if (is_seen(&found, i, primitive))
            packet->points[packet->kept++] = packet->points[i];
    seen_crossings_free(&found);
    return true;
}

/* The weights of rays go to what they meet first, and those that meet nothing to
 * the environment. */
static bool receive(const struct factors *factors, struct packet *packet,
                    struct factor_row *row, c205_error *error)
{
    struct seen_crossings found = { 0 };

    for (size_t i = 0; i < packet->kept; i++)
        put_line(packet->points[i].spot, packet->points[i].ray,
                 &packet->lines[i]);
    if (!follow(factors->rays, packet->lines, packet->kept, row, &found,
                error))
        return false;
    for (size_t i = 0; i < packet->kept; i++) {
        size_t first = found.first[i];
        size_t receiver = first < found.first[i + 1]
                              ? found.list[first].primitive
                              : row->receivers - 1;
        double weight = c205_to_double(packet->points[i].weight);

        row->count[receiver]++;
        packet->share[receiver] += weight;
        packet->area += weight;
    }
    seen_crossings_free(&found);
    return true;
}

/* Each primitive has shifts, or rays, of its own. */
static bool run_repeat(const struct factors *factors,
                       struct emission *emission, size_t primitive,
                       size_t repeat, struct packet *packet,
                       struct factor_row *row, c205_error *error)
{
    const struct factors_options *options = &factors->options;
    size_t place = primitive * options->repeats + repeat;
    unsigned m = 0;
    struct emission_choice choice = { .seed = options->seed, .shift = place };

    while (m < 20 && (UINT64_C(1) << m) < options->points)
        m++;
    choice.m = m;
    if (!options->lattice)
        choice.first = place * options->points;
    packet->area = 0;
    return emission_run(emission, &choice, packet->points, error)
           && (accounts_add(&row->accounts, emission_machine(emission))
               || error_say(error, "no memory"))
           && keep_faces(factors, primitive, packet, row, error)
           && (packet->kept == 0 || receive(factors, packet, row, error));
}

/* ---- All of them ------------------------------------------------------------ */

/* What each of the repeats comes to, means over its points. */
struct repeats {
    size_t count;
    double *area;
    double *share; /* [count][receivers] */
};

static bool repeats_begin(struct repeats *repeats, size_t count,
                          size_t receivers)
{
    repeats->count = count;
    repeats->area = calloc(count, sizeof *repeats->area);
    repeats->share = calloc(count * receivers, sizeof *repeats->share);
    return repeats->area && repeats->share;
}

static void repeats_free(struct repeats *repeats)
{
    free(repeats->area);
    free(repeats->share);
}

static double sum_of(const double *values, size_t step, size_t count)
{
    double sum = 0;

    for (size_t k = 0; k < count; k++)
        sum += values[k * step];
    return sum;
}

/* The standard error of a mean, from the squares about it of so many. */
static double error_of(double squares, size_t count)
{
    double n = (double)count;

    return sqrt(squares / (n * (n - 1)));
}

static struct estimate area_of(const struct repeats *repeats)
{
    double mean = sum_of(repeats->area, 1, repeats->count)
                  / (double)repeats->count;
    double squares = 0;

    for (size_t k = 0; k < repeats->count; k++) {
        double beside = repeats->area[k] - mean;
        squares += beside * beside;
    }
    return (struct estimate){ mean, error_of(squares, repeats->count) };
}

/* A ratio: its error is that of share - factor area.  share: of the receiver, each of a
 * repeat so many behind the one before. */
static struct estimate factor_of(const struct repeats *repeats,
                                 const double *share, size_t step)
{
    double area = sum_of(repeats->area, 1, repeats->count);
    double factor = sum_of(share, step, repeats->count) / area, squares = 0;

    for (size_t k = 0; k < repeats->count; k++) {
        double beside = share[k * step] - factor * repeats->area[k];
        squares += beside * beside;
    }
    return (struct estimate){ factor, error_of(squares, repeats->count)
                                          * (double)repeats->count / area };
}

static void conclude(const struct repeats *repeats, struct factor_row *row)
{
    row->area = area_of(repeats);
    for (size_t j = 0; j < row->receivers && row->area.value > 0; j++)
        row->factor[j] = factor_of(repeats, repeats->share + j,
                                   row->receivers);
}

static bool run_repeats(const struct factors *factors, size_t primitive,
                        struct emission *emission, struct packet *packet,
                        struct repeats *repeats, struct factor_row *row,
                        c205_error *error)
{
    const struct factors_options *options = &factors->options;

    for (size_t k = 0; k < options->repeats; k++) {
        packet->share = repeats->share + k * row->receivers;
        if (!run_repeat(factors, emission, primitive, k, packet, row, error))
            return false;
        repeats->area[k] = packet->area / (double)options->points;
        for (size_t j = 0; j < row->receivers; j++)
            packet->share[j] /= (double)options->points;
        row->tried += options->points;
        row->sent += packet->kept;
    }
    conclude(repeats, row);
    return true;
}

void factor_row_free(struct factor_row *row)
{
    free(row->count);
    free(row->factor);
    accounts_free(&row->accounts);
    *row = (struct factor_row){ .receivers = 0 };
}

static bool make_room(const struct factors *factors, struct packet *packet,
                      struct repeats *repeats, struct factor_row *row)
{
    size_t points = factors->options.points;
    size_t receivers = factors->scene->primitive_count + 1;

    *row = (struct factor_row){ .receivers = receivers };
    row->accounts.model = factors->options.model;
    row->count = calloc(receivers, sizeof *row->count);
    row->factor = calloc(receivers, sizeof *row->factor);
    packet->points = malloc(points * sizeof *packet->points);
    packet->lines = malloc(points * sizeof *packet->lines);
    return row->count && row->factor && packet->points && packet->lines
           && repeats_begin(repeats, factors->options.repeats, receivers);
}

bool factors_find(const struct factors *factors, size_t primitive,
                  struct factor_row *row, c205_error *error)
{
    const struct factors_options *options = &factors->options;
    const struct emission_options emits = { .mode = options->mode,
                                            .queue = options->queue,
                                            .points = options->points,
                                            .lattice = options->lattice,
                                            .model = options->model };
    struct emission *emission =
        emission_new(&factors->scene->primitives[primitive], &emits, error);
    struct packet packet = { .points = NULL };
    struct repeats repeats = { .count = 0 };
    bool good;

    *row = (struct factor_row){ .receivers = 0 };
    if (!emission)
        return false;
    good = make_room(factors, &packet, &repeats, row)
               ? run_repeats(factors, primitive, emission, &packet, &repeats,
                             row, error)
               : error_say(error, "no memory");
    if (!good)
        factor_row_free(row);
    emission_free(emission);
    free(packet.points);
    free(packet.lines);
    repeats_free(&repeats);
    return good;
}
