/* test_objective.c - fits with artificial values are compared with the limits of the
 * objective, on both sides of each limit. A limit with the wrong sign, or a limit that
 * is not checked, fails here. */
#include "rt/study/fit/objective.h"
#include "tests/unit/unit.h"

enum { ROWS = 12 };

/* The speedups that the report requests, in this order. Each is requested twice. */
static const double speedups[] = { 1.0999, 1.1001, .9001, .8999,
                                   1.0499, 1.0501, .9501, .9499 };
static size_t speedups_asked;

bool study_is_row(const struct observation *observation)
{
    return observation->unit != NULL;
}

double fit_error(const struct observation *observation, double predicted)
{
    return predicted / observation->value - 1;
}

double study_speedup(const struct study *study UNUSED, const double *predicted UNUSED,
                     const struct speedup_subject *subject UNUSED, bool other UNUSED,
                     double *reported)
{
    *reported = 10;
    return 10 * speedups[speedups_asked++];
}

double constant_value(const struct free_constant *constant, double place)
{
    return constant->prior + place;
}

static const struct observation rows[ROWS] = {
    { .name = "high", .unit = "s", .value = 1 },
    { .name = "higher", .unit = "s", .value = 1 },
    { .name = "low", .unit = "s", .value = 1 },
    { .name = "lower", .unit = "s", .value = 1 },
    { .name = "too high", .unit = "s", .value = 1 },
    { .name = "too low", .unit = "s", .value = 1 },
    { .name = "Livermore 1", .unit = NULL, .value = 1 },
    { .name = "Livermore 2", .unit = NULL, .value = 1 },
    { .name = "Livermore 3", .unit = NULL, .value = 1 },
    { .name = "Livermore 4", .unit = NULL, .value = 1 },
    { .name = "no row", .unit = NULL, .value = 1 },
    { .name = "equal", .unit = "s", .value = 1 },
};

static const double times[ROWS] = { 1.0499, 1.0999, .9501,  .9001,  1.1001, .8999,
                                    .9001,  .8999,  1.0999, 1.1001, 2,      1 };
static const double left_out[ROWS] = { 1.2499, 1.2501, .7501, .7499, 1, 1,
                                       1,      1,      1,     1,     2, 1 };
static const double places[] = { 2, 2.01, -2, -2.01, 0, 5, -5 };
enum { CONSTANTS = COUNT(places) };

TEST(limits)
{
    static struct study study;
    static struct constants constants = { .count = CONSTANTS };
    const struct observations all = { .count = ROWS,
                                      .items = (struct observation *)rows };
    char text[1000] = "";
    const struct command_output results = { .format = OUTPUT_TEXT, .file = tmpfile() };
    assert_non_null(results.file);
    study.fit.observations = &all;
    study.fit.constants = &constants;
    study.subject_count = 2;
    memcpy(study.left_out, left_out, sizeof left_out);
    memcpy(study.best.places, places, sizeof places);
    for (size_t i = 0; i < CONSTANTS; i++)
        constants.items[i] = (struct free_constant){ .least = -5, .most = 5 };
    objective_print(&study, times, &results);
    rewind(results.file);
    text[fread(text, 1, sizeof text - 1, results.file)] = '\0';
    fclose(results.file);
    assert_string_equal(text, "\nThe goal:\n\n"
                              "Times of Table 1 within 10 %: 5 of 7; not\n"
                              "    too high +10.0 %,\n    too low -10.0 %.\n"
                              "Speedups within 10 %: 2 of 4.\n"
                              "Times of Table 1 within 5 %: 3 of 7; not\n"
                              "    higher +10.0 %,\n    lower -10.0 %,\n"
                              "    too high +10.0 %,\n    too low -10.0 %.\n"
                              "Speedups within 5 %: 2 of 4.\n"
                              "Livermore kernels within 10 %: 2 of 4; not\n"
                              "    Livermore 2 -10.0 %,\n"
                              "    Livermore 4 +10.0 %.\n"
                              "Rows left out within 25 %: 9 of 12; not\n"
                              "    higher +25.0 %,\n    lower -25.0 %,\n"
                              "    no row +100.0 %.\n"
                              "Constants inside their bounds: 5 of 7; within 2 "
                              "prior widths: 3.\n");
}
