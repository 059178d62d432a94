#include "rt/heat/factors.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

static bool fail(c205_error *error, const char *message)
{
    snprintf(error->message, sizeof error->message, "%s", message);
    return false;
}

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
        fail(error, "errors come of two repeats or more");
        return NULL;
    }
    factors = calloc(1, sizeof *factors);
    if (!factors) {
        fail(error, "no memory");
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
    double area;   /* the mean of weights, 0 of points that went */
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

static bool add_accounts(struct accounts *sum, const struct accounts *more)
{
    for (size_t i = 0; i < more->count; i++)
        if (!accounts_add_account(sum, &more->items[i]))
            return false;
    return true;
}

/* Those crossings that lines find, with what that took. */
static bool follow(const struct lines *lines, const struct scene_line *list,
                   size_t count, struct factor_row *row,
                   struct seen_crossings *found, c205_error *error)
{
    if (!lines_find(lines, list, count, found, error))
        return false;
    if (add_accounts(&row->accounts, &found->accounts))
        return true;
    seen_crossings_free(found);
    return fail(error, "no memory");
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
    memset(packet->share, 0, row->receivers * sizeof *packet->share);
    return emission_run(emission, &choice, packet->points, error)
           && (accounts_add(&row->accounts, emission_machine(emission))
               || fail(error, "no memory"))
           && keep_faces(factors, primitive, packet, row, error)
           && (packet->kept == 0 || receive(factors, packet, row, error));
}

/* ---- All of them ------------------------------------------------------------ */

/* Sums over the repeats: of areas, of shares and of their products. */
struct sums {
    double area, area_squares;
    double *share, *squares, *products;
};

static void add_repeat(struct sums *sums, const struct packet *packet,
                       size_t points, size_t receivers)
{
    double area = packet->area / (double)points;

    sums->area += area;
    sums->area_squares += area * area;
    for (size_t j = 0; j < receivers; j++) {
        double share = packet->share[j] / (double)points;

        sums->share[j] += share;
        sums->squares[j] += share * share;
        sums->products[j] += share * area;
    }
}

/* The standard error of a mean of n, from the sum of squares about it. */
static double error_of(double squares, double n)
{
    return sqrt(fmax(squares, 0) / (n * (n - 1)));
}

/* A factor is a ratio: its error is that of share - factor area. */
static void conclude(const struct sums *sums, double n,
                     struct factor_row *row)
{
    row->area.value = sums->area / n;
    row->area.error = error_of(sums->area_squares
                                   - sums->area * sums->area / n,
                               n);
    for (size_t j = 0; j < row->receivers && sums->area > 0; j++) {
        double factor = sums->share[j] / sums->area;
        double squares = sums->squares[j] - 2 * factor * sums->products[j]
                         + factor * factor * sums->area_squares;

        row->factor[j].value = factor;
        row->factor[j].error = error_of(squares, n) / row->area.value;
    }
}

static bool run_repeats(const struct factors *factors, size_t primitive,
                        struct emission *emission, struct packet *packet,
                        struct sums *sums, struct factor_row *row,
                        c205_error *error)
{
    const struct factors_options *options = &factors->options;

    for (size_t k = 0; k < options->repeats; k++) {
        if (!run_repeat(factors, emission, primitive, k, packet, row, error))
            return false;
        add_repeat(sums, packet, options->points, row->receivers);
        row->tried += options->points;
        row->sent += packet->kept;
    }
    conclude(sums, (double)options->repeats, row);
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
                      struct sums *sums, double **numbers,
                      struct factor_row *row)
{
    size_t points = factors->options.points;
    size_t receivers = factors->scene->primitive_count + 1;

    *row = (struct factor_row){ .receivers = receivers };
    row->accounts.model = factors->options.model;
    row->count = calloc(receivers, sizeof *row->count);
    row->factor = calloc(receivers, sizeof *row->factor);
    packet->points = malloc(points * sizeof *packet->points);
    packet->lines = malloc(points * sizeof *packet->lines);
    *numbers = calloc(4 * receivers, sizeof **numbers);
    if (!row->count || !row->factor || !packet->points || !packet->lines
        || !*numbers)
        return false;
    packet->share = *numbers;
    sums->share = *numbers + receivers;
    sums->squares = *numbers + 2 * receivers;
    sums->products = *numbers + 3 * receivers;
    return true;
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
    struct sums sums = { .area = 0 };
    double *numbers = NULL;
    bool good;

    *row = (struct factor_row){ .receivers = 0 };
    if (!emission)
        return false;
    good = make_room(factors, &packet, &sums, &numbers, row)
               ? run_repeats(factors, primitive, emission, &packet, &sums,
                             row, error)
               : fail(error, "no memory");
    if (!good)
        factor_row_free(row);
    emission_free(emission);
    free(packet.points);
    free(packet.lines);
    free(numbers);
    return good;
}
