/* figures.c - computes mass properties from sums over columns. */
#include "rt/mass/figures.h"

#include <math.h>
#include <stdlib.h>

#include "rt/shapes/singular.h"

const char *figure_name(size_t figure)
{
    static const char *const names[FIGURES] = {
        "volume", "area", "mass", "cx",  "cy",  "cz",  "Ixx", "Iyy",
        "Izz",    "Ixy",  "Ixz",  "Iyz", "Jxx", "Jyy", "Jzz", "Jxy",
        "Jxz",    "Jyz",  "J1",   "J2",  "J3",  "Vx",  "Vy",  "Vz",
    };
    return names[figure];
}

/* ---- Integrals over a body ----------------------------------------------- */

/* Integrals relative to the centre of the box. The second moments are xx yy zz xy xz
 * yz. */
struct integrals {
    double volume, area, mass, first[3], second[6];
    double views[VIEWS]; /* volume from each view */
};
enum { INTEGRALS = sizeof(struct integrals) / sizeof(double) };

/* Returns the index in integrals.second of the product of the axes i and k. */
static size_t product_place(size_t i, size_t k)
{
    return i == k ? i : i + k + 2;
}

struct summand {
    const struct columns_sums *sums;
    size_t view, repeat, part;
};

static double integral(const struct summand *summand, enum moment moment)
{
    return columns_integral(summand->sums, summand->view, summand->repeat,
                            summand->part, moment);
}

/* Adds a view's integrals for a part with this density, divided by 3 for the mean of
 * the three views. */
static void add_view(const struct summand *summand, double density,
                     struct integrals *sum)
{
    static const enum moment firsts[3] = { MOMENT_S, MOMENT_P, MOMENT_Q };
    static const enum moment seconds[3][3] = {
        { MOMENT_SS, MOMENT_PS, MOMENT_QS },
        { MOMENT_PS, MOMENT_PP, MOMENT_PQ },
        { MOMENT_QS, MOMENT_PQ, MOMENT_QQ },
    };
    size_t view = summand->view;
    double volume = integral(summand, MOMENT_1), share = density / VIEWS;
    sum->views[view] += volume;
    sum->volume += volume / VIEWS;
    sum->area += integral(summand, MOMENT_AREA);
    sum->mass += share * volume;
    for (size_t i = 0; i < 3; i++) {
        size_t axis = (view + i) % 3;
        sum->first[axis] += share * integral(summand, firsts[i]);
        for (size_t k = i; k < 3; k++)
            sum->second[product_place(axis, (view + k) % 3)] +=
                share * integral(summand, seconds[i][k]);
    }
}

static void find_integrals(const struct mass_body *body, size_t repeat,
                           struct integrals *sum)
{
    struct summand summand = { .sums = body->sums, .repeat = repeat };
    *sum = (struct integrals){ 0 };
    for (summand.part = 0; summand.part + 1 < body->sums->parts; summand.part++)
        for (summand.view = 0; body->density[summand.part] > 0 && summand.view < VIEWS;
             summand.view++)
            add_view(&summand, body->density[summand.part], sum);
}

static void add_integrals(struct integrals *sum, const struct integrals *more,
                          double weight)
{
    double *to = (double *)sum;
    const double *from = (const double *)more;
    for (size_t i = 0; i < INTEGRALS; i++)
        to[i] += weight * from[i];
}

/* ---- Figures from integrals ---------------------------------------------- */

/* Computes the inertia tensor about a point. The integrals and the centroid are
 * relative to the centre of the box. `offset` is the vector from the point to the
 * centroid.
 *
 * By the parallel axis theorem the second moments about the point are
 *
 *   second + mass (offset offset^T - centroid centroid^T).
 *
 * The tensor is the identity times the trace of these moments, minus the moments.
 */
static void find_inertia(const struct integrals *sum, const double centroid[3],
                         const double offset[3], double inertia[6])
{
    double central[6] = { 0 }, trace = 0;
    for (size_t i = 0; i < 3; i++)
        for (size_t k = i; k < 3; k++) {
            size_t place = product_place(i, k);
            central[place] = sum->second[place]
                             + sum->mass
                                   * (offset[i] * offset[k]
                                      - centroid[i] * centroid[k]);
        }
    for (size_t i = 0; i < 3; i++)
        trace += central[i];
    for (size_t i = 0; i < 3; i++) {
        inertia[i] = trace - central[i];
        inertia[3 + i] = -central[3 + i];
    }
}

/* Computes the eigenvalues and eigenvectors of the inertia by one-sided Jacobi
 * rotations. The tensor is positive semidefinite, so its singular vectors are its
 * principal axes. */
static void find_principal(const double inertia[6], double moments[3],
                           double axes[3][3])
{
    struct singular singular = { .rows = 3, .columns = 3 };
    size_t order[3] = { 0, 1, 2 };
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 3; k++)
            singular
                .scaled[i][k] = inertia[product_place(i < k ? i : k, i < k ? k : i)];
    singular_decompose(&singular);
    for (size_t i = 0; i < 3; i++)
        for (size_t k = i;
             k > 0 && singular.values[order[k]] < singular.values[order[k - 1]]; k--) {
            size_t other = order[k];

            order[k] = order[k - 1];
            order[k - 1] = other;
        }
    for (size_t i = 0; i < 3; i++) {
        moments[i] = singular.values[order[i]];
        for (size_t k = 0; k < 3; k++)
            axes[i][k] = singular.right[k][order[i]];
    }
}

static void find_values(const struct mass_body *body, const struct integrals *sum,
                        double value[FIGURES], double axes[3][3])
{
    const double *middle = body->sums->middle;
    double centroid[3], offset[3], none[3] = { 0 };
    value[FIGURE_VOLUME] = sum->volume;
    value[FIGURE_AREA] = sum->area;
    value[FIGURE_MASS] = sum->mass;
    for (size_t i = 0; i < 3; i++) {
        centroid[i] = sum->mass != 0 ? sum->first[i] / sum->mass : 0;
        value[FIGURE_CENTROID + i] = sum->mass != 0 ? centroid[i] + middle[i] : NAN;
        offset[i] = centroid[i] + middle[i] - body->about[i];
        value[FIGURE_VIEWS + i] = sum->views[i];
    }
    find_inertia(sum, centroid, offset, value + FIGURE_INERTIA);
    find_inertia(sum, centroid, none, value + FIGURE_CENTRAL);
    find_principal(value + FIGURE_CENTRAL, value + FIGURE_PRINCIPAL, axes);
}

/* ---- Errors -------------------------------------------------------------- */

/* Returns the 97.5 % quantile of Student's t distribution with at least 3 degrees of
 * freedom. */
static double student(double freedom)
{
    const double terms[] = { 1.959964, 2.372271, 2.822500, 2.555852, 1.589534 };
    double sum = 0;
    for (int i = 4; i >= 0; i--)
        sum = sum / freedom + terms[i];
    return sum;
}

/* Returns half the width of the 95 % confidence interval of a figure, by the jackknife.
 * The figure has been computed `count` times, each time without a different shift.
 * `squares` is the sum of the squared deviations of these values from their mean. */
static double interval(double squares, double count)
{
    return count > 3 ? student(count - 1) * sqrt((count - 1) / count * squares) : NAN;
}

/* Computes the figures once without each shift, and from these values the errors of the
 * figures. */
static void find_errors(const struct mass_body *body, const struct integrals *shifts,
                        const struct integrals *sum, struct mass_figures *figures,
                        double (*without)[FIGURES])
{
    size_t count = body->sums->repeats;
    double axes[3][3];
    for (size_t r = 0; r < count; r++) {
        struct integrals less = { 0 };
        double others = (double)count - 1;
        add_integrals(&less, sum, (double)count / others);
        add_integrals(&less, &shifts[r], -1 / others);
        find_values(body, &less, without[r], axes);
    }
    for (size_t i = 0; i < FIGURES; i++) {
        double mean = 0, squares = 0;
        for (size_t r = 0; r < count; r++)
            mean += without[r][i] / (double)count;
        for (size_t r = 0; r < count; r++)
            squares += (without[r][i] - mean) * (without[r][i] - mean);
        figures->error[i] = interval(squares, (double)count);
    }
}

bool mass_figures_find(const struct mass_body *body, struct mass_figures *figures)
{
    size_t count = body->sums->repeats;
    struct integrals *shifts = calloc(count, sizeof *shifts), sum = { 0 };
    double(*without)[FIGURES] = calloc(count, sizeof *without);
    bool good = shifts && without;

    for (size_t r = 0; good && r < count; r++) {
        find_integrals(body, r, &shifts[r]);
        add_integrals(&sum, &shifts[r], 1 / (double)count);
    }
    if (good) {
        find_values(body, &sum, figures->value, figures->axes);
        find_errors(body, shifts, &sum, figures, without);
    }
    free(shifts);
    free(without);
    return good;
}

/* Returns the exponent of length in the unit of a figure. Densities are masses per cube
 * of the file's unit. */
static int dimension_of(size_t figure)
{
    return figure == FIGURE_AREA                                  ? 2
           : figure >= FIGURE_CENTROID && figure < FIGURE_INERTIA ? 1
           : figure >= FIGURE_INERTIA && figure < FIGURE_VIEWS    ? 5
                                                                  : 3;
}

void mass_figures_enlarge(struct mass_figures *figures, int log)
{
    for (size_t i = 0; i < FIGURES; i++) {
        double unit = ldexp(1, log * dimension_of(i));
        figures->value[i] *= unit;
        figures->error[i] *= unit;
    }
}

/* Returns the sum of the volumes of all parts minus the volume of their union, as the
 * mean over the views. */
static double overlap_of_all(const struct columns_sums *sums, size_t repeat,
                             size_t none)
{
    double volume = 0;
    (void)none;
    for (size_t view = 0; view < VIEWS; view++)
        for (size_t part = 0; part < sums->parts; part++)
            volume += (part + 1 < sums->parts ? 1 : -1)
                      * columns_integral(sums, view, repeat, part, MOMENT_1);
    return volume / VIEWS;
}

static double overlap_of_pair(const struct columns_sums *sums, size_t repeat,
                              size_t pair)
{
    double volume = 0;
    for (size_t view = 0; view < VIEWS; view++)
        volume += columns_overlap(sums, view, repeat, pair);
    return volume / VIEWS;
}

/* Computes the mean of a value over the shifts, and the error of the mean. */
static void find_mean(const struct columns_sums *sums,
                      double (*of)(const struct columns_sums *sums, size_t repeat,
                                   size_t which),
                      size_t which, double *volume, double *error)
{
    double count = (double)sums->repeats, squares = 0;
    *volume = 0;
    for (size_t r = 0; r < sums->repeats; r++)
        *volume += of(sums, r, which) / count;
    for (size_t r = 0; r < sums->repeats; r++) {
        double beside = of(sums, r, which) - *volume;
        squares += beside * beside / ((count - 1) * (count - 1));
    }
    *error = interval(squares, count);
}

void mass_overlap(const struct columns_sums *sums, double *volume, double *error)
{
    find_mean(sums, overlap_of_all, 0, volume, error);
}

/* A smaller fraction of the box's volume is a rounding error of bodies that touch. */
static const double TOUCHING = 0x1p-36;

bool mass_overlap_of(const struct columns_sums *sums, size_t pair, double *volume,
                     double *error)
{
    const double *width = sums->width;
    find_mean(sums, overlap_of_pair, pair, volume, error);
    return fabs(*volume) > TOUCHING * width[0] * width[1] * width[2];
}

/* Returns the value by which the error of a figure is divided to compute its relative
 * error. */
static double scale_of(const struct mass_figures *figures,
                       const struct columns_sums *sums, size_t figure)
{
    const double *width = sums->width;
    if (figure < FIGURE_CENTROID)
        return figures->value[figure];
    if (figure < FIGURE_INERTIA)
        return sqrt(width[0] * width[0] + width[1] * width[1] + width[2] * width[2]);
    if (figure < FIGURE_CENTRAL)
        return fmax(figures->value[FIGURE_PRINCIPAL + 2],
                    fmax(figures->value[FIGURE_INERTIA],
                         fmax(figures->value[FIGURE_INERTIA + 1],
                              figures->value[FIGURE_INERTIA + 2])));
    return figures->value[FIGURE_PRINCIPAL + 2];
}

double mass_worst(const struct mass_figures *figures, const struct columns_sums *sums,
                  size_t *figure)
{
    double worst = -1;
    for (size_t i = 0; i < FIGURE_VIEWS; i++) {
        double scale = scale_of(figures, sums, i);
        double share = figures->error[i] > 0 ? figures->error[i] / scale
                                             : figures->error[i];
        if (isnan(figures->value[i])) /* the centroid of an empty body is NaN */
            continue;
        if (share > worst || isnan(share)) {
            worst = isnan(share) ? INFINITY : share;
            *figure = i;
        }
    }
    return worst;
}
