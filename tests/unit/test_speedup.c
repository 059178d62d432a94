/* test_speedup.c - the measurements and tables of rt205 speedup are compared with sums
 * of their parts and with the paper's figures, in small frames. A clock without a
 * cause, or a wrong figure of a row, fails here. */
#include "rt/study/formulations.h"
#include "rt/study/speedup_report.h"

#include <math.h>

#include "tests/unit/csv_reading.h"
#include "tests/unit/prior_model.h"

static struct speedup_report *report; /* report of all subjects */
static const struct speedup_view view = { .distance = 5, .angle = 37 };

static void measure(const struct speedup_subject *subject,
                    const struct speedup_view *from,
                    struct speedup_measure measures[TRACE_FORMS])
{
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        struct trace_options options = { .mode = (enum trace_mode)mode,
                                         .width = 80,
                                         .height = 50,
                                         .queue = TRACE_QUEUE,
                                         .model = prior_model };
        REQUIRE(speedup_measure(subject, from, &options, &measures[mode], &failure));
    }
}

/* Each clock has a cause and a region. */
static void check_sums(const struct speedup_measure *measure)
{
    uint64_t causes = 0, regions = 0;
    for (int i = 0; i < C205_CAUSES; i++)
        causes += measure->clocks[i];
    for (int i = 0; i < MAX_SPEEDUP_REGIONS; i++)
        regions += measure->regions[i];
    assert_true(causes == measure->total);
    assert_true(regions == measure->total);
}

/* The region of the solver has clocks if the regula falsi made steps. The scalar form
 * refines one bracket at a time. */
static void check_solver(const struct speedup_subject *subject,
                         const struct speedup_measure measures[TRACE_FORMS])
{
    for (size_t i = 0; i < MAX_SPEEDUP_REGIONS; i++) {
        const struct stage_count *count = measures[TRACE_SCALAR].iterations.stage;
        if (!subject->regions[i] || strcmp(subject->regions[i], speedup_solver) != 0)
            continue;
        for (int stage = 0; stage < STAGES; stage++) {
            assert_true(count[stage].steps >= count[stage].brackets);
            assert_true(count[stage].steps == count[stage].passes);
        }
        assert_true(count[STAGE_VALUE].brackets >= measures[TRACE_SCALAR].hits);
        for (int mode = 0; mode < TRACE_FORMS; mode++) {
            assert_true(measures[mode].regions[i] > 0);
            assert_int_equal(measures[mode].falsi == FALSI_PAPER, subject->historical);
        }
    }
}

/* A subject names the solver's region if and only if it calls the solver. */
TEST(subjects)
{
    for (size_t i = 0; i < speedup_subject_count; i++) {
        const struct speedup_subject *subject = &speedup_subjects[i];
        struct speedup_measure measures[TRACE_FORMS];
        bool solves = false;
        measure(subject, &view, measures);
        for (int k = 0; k < MAX_SPEEDUP_REGIONS; k++)
            solves |= subject->regions[k] != NULL
                      && strcmp(subject->regions[k], speedup_solver) == 0;
        for (int mode = 0; mode < TRACE_FORMS; mode++) {
            check_sums(&measures[mode]);
            assert_int_equal(measures[mode].rays, 4000);
            assert_in_range(measures[mode].hits, 1000, 3000);
            assert_int_equal(measures[mode].iterations.stage[STAGE_VALUE].brackets > 0,
                             solves);
        }
        assert_true(measures[TRACE_SCALAR].checksum == measures[TRACE_VECTOR].checksum);
        assert_true(measures[TRACE_SCALAR].total > 3 * measures[TRACE_VECTOR].total);
        check_solver(subject, measures);
    }
}

/* The historical kernel and its regula falsi differ from the standard kernel. */
TEST(historical)
{
    for (size_t i = 0; i < speedup_subject_count; i++) {
        struct speedup_subject subject = speedup_subjects[i];
        struct speedup_measure then[TRACE_FORMS], ours[TRACE_FORMS];
        if (!subject.historical)
            continue;
        measure(&subject, &view, then);
        subject.historical = false;
        measure(&subject, &view, ours);
        for (int mode = 0; mode < TRACE_FORMS; mode++) {
            assert_int_equal(then[mode].hits, ours[mode].hits);
            assert_true(then[mode].regions[1] != ours[mode].regions[1]);
        }
    }
}

/* The camera is more distant, and its view is narrower. */
TEST(view)
{
    static const struct speedup_view far = { .distance = 20, .angle = 37 };
    static const struct speedup_view narrow = { .distance = 5, .angle = 5 };
    struct speedup_measure measures[TRACE_FORMS];
    measure(&speedup_subjects[0], &far, measures);
    assert_in_range(measures[TRACE_VECTOR].hits, 50, 300);
    measure(&speedup_subjects[0], &narrow, measures);
    assert_int_equal(measures[TRACE_VECTOR].hits, 4000);
}

TEST(errors)
{
    const struct trace_options options = {
        .width = 4, .height = 4, .queue = 4, .model = prior_model
    };
    struct speedup_subject subject = speedup_subjects[0];
    struct speedup_measure measured;
    c205_error error = { "" };
    subject.regions[1] = "nowhere";
    assert_false(speedup_measure(&subject, &view, &options, &measured, &error));
    assert_non_null(strstr(error.message, "no region nowhere"));
    subject.shape = "sphere { 0 }";
    assert_false(speedup_measure(&subject, &view, &options, &measured, &error));
    assert_non_null(strstr(error.message, "sphere"));
}

/* Measures all rows of Table 1, and returns their report. */
static struct speedup_report *report_all(void)
{
    struct speedup_report *all = speedup_report_new(prior_model);
    for (size_t i = 0; all && i < speedup_subject_count; i++) {
        struct speedup_measure measures[TRACE_FORMS];
        measure(&speedup_subjects[i], &view, measures);
        speedup_report_add(all, &speedup_subjects[i], &view, measures);
    }
    return all;
}

/* The text that the last call of print has written. */
static char text[1 << 17];

static void print(bool (*print_tables)(const struct speedup_report *, enum table_format,
                                       FILE *),
                  enum table_format format)
{
    FILE *stream = NON_NULL(fmemopen(text, sizeof text, "w"));
    assert_true(print_tables(report, format, stream));
    assert_int_equal(fclose(stream), 0);
}

/* The passes are a separate table, printed on request. */
TEST(detail)
{
    print(speedup_report_detail, TABLE_PLAIN);
    assert_non_null(strstr(text, "paper: %"));
    assert_null(strstr(text, "pass by pass"));
    assert_null(strstr(text, "% of brackets"));
    print(speedup_report_passes, TABLE_PLAIN);
    assert_null(strstr(text, "paper: %"));
    assert_non_null(strstr(text, "pass by pass"));
    assert_non_null(strstr(text, "% of brackets"));
}

/* Reads a table of the detailed report by its heading. */
static void read_detail(const char *heading, struct csv_table *table)
{
    print(speedup_report_detail, TABLE_CSV);
    const char *at = NON_NULL(strstr(text, heading));
    csv_table(strchr(at, '\n') + 1, table);
}

/* The table of times has two rows for each row of the table of rays. Names contain
 * commas. */
TEST(times)
{
    static struct csv_table rays, times;
    read_detail("# The rays\n", &rays);
    read_detail("# The kernels and their calls\n", &times);
    assert_int_equal(times.cells[0], 4);
    assert_int_equal(rays.rows, 1 + speedup_subject_count);
    assert_int_equal(times.rows, 1 + 2 * speedup_subject_count);
    for (size_t i = 0; i < speedup_subject_count; i++) {
        assert_string_equal(rays.cell[1 + i][0], speedup_subjects[i].name);
        assert_string_equal(rays.cell[1 + i][rays.cells[0] - 1],
                            speedup_subjects[i].shape);
    }
    for (size_t i = 1; i < times.rows; i++) {
        const char *subject = speedup_subjects[(i - 1) / 2].name;
        double traced = strtod(rays.cell[(i - 1) / 2 + 1][1], NULL);
        assert_string_equal(times.cell[i][0], subject);
        assert_string_equal(times.cell[i][1], i % 2 ? "scalar" : "vector");
        assert_true(traced > 0);
        assert_true(fabs(strtod(times.cell[i][2], NULL) / traced
                             / strtod(times.cell[i][3], NULL)
                         - 1)
                    < 1e-12);
    }
}

/* ---- Table 1 ------------------------------------------------------------ */

enum { FIGURES = 5 };

/* The figures that are printed in the paper. */
static const struct {
    const char *primitive;
    double figures[FIGURES];
} printed[] = {
    { "sphere", { .944, .0279, 13.1, 33.81, 469 } },
    { "cylinder", { 2.729, .1614, 51.48, 16.91, 318 } },
    { "Steiner", { 11.157, 1.047, 216.0, 10.67, 206 } },
};

/* Reads Table 1 from its CSV. The heading is a comment. */
static const struct csv_table *read_table1(void)
{
    static struct csv_table table;
    print(speedup_report_table1, TABLE_CSV);
    assert_int_equal(strncmp(text, "\n# Table 1", 10), 0);
    assert_string_equal(csv_table(strchr(text + 1, '\n') + 1, &table), "");
    assert_int_equal(table.cells[0], 2 + FIGURES);
    return &table;
}

/* Asserts that two numbers differ only by rounding. */
static void assert_near(double a, double b)
{
    FAIL_IF(!(fabs(a - b) <= 1e-12 * fabs(b) + 1e-11), "%.17g is not %.17g", a, b);
}

static double figure(const struct csv_table *table, size_t row, int column)
{
    char *end;
    const char *cell = table->cell[row][2 + column];
    double value = strtod(cell, &end);
    FAIL_IF(*cell == '\0' || *end != '\0', "no number: %s", cell);
    return value;
}

/* Returns the row of a primitive, or 0 if there is none. */
static size_t line_of(const struct csv_table *table, const char *primitive,
                      const char *whose)
{
    for (size_t row = 1; row < table->rows; row++)
        if (strcmp(table->cell[row][0], primitive) == 0
            && strcmp(table->cell[row][1], whose) == 0)
            return row;
    return 0;
}

TEST(paper_lines)
{
    const struct csv_table *table = read_table1();
    for (size_t i = 0; i < COUNT(printed); i++) {
        size_t ours = line_of(table, printed[i].primitive, "ours");
        size_t paper = line_of(table, printed[i].primitive, "paper");
        size_t error = line_of(table, printed[i].primitive, "error %");
        assert_true(ours > 0 && paper > 0 && error > 0);
        for (int k = 0; k < FIGURES; k++) {
            double reported = printed[i].figures[k];
            assert_true(figure(table, paper, k) == reported);
            assert_near(figure(table, error, k),
                        100 * (figure(table, ours, k) / reported - 1));
        }
    }
}

/* Each subject has one row. Only subjects of the paper have more rows. */
TEST(our_lines)
{
    const struct csv_table *table = read_table1();
    size_t lines = 1 + speedup_subject_count + 2 * COUNT(printed);
    assert_int_equal(table->rows, lines);
    for (size_t i = 0; i < speedup_subject_count; i++) {
        size_t row = line_of(table, speedup_subjects[i].name, "ours");
        assert_true(row > 0);
        double vector = figure(table, row, 1);
        assert_near(figure(table, row, 3), figure(table, row, 0) / vector);
        assert_near(figure(table, row, 4), figure(table, row, 2) / vector);
    }
}

/* Seconds are scaled to 100,000 rays, at 20 ns per clock. */
TEST(scale)
{
    const struct csv_table *table = read_table1();
    struct speedup_measure measures[TRACE_FORMS];
    measure(&speedup_subjects[0], &view, measures);
    for (int mode = 0; mode < TRACE_FORMS; mode++)
        assert_near(figure(table, 1, mode), 25 * 20e-9 * (double)measures[mode].total);
    assert_near(figure(table, 1, 2),
                25 * measures[TRACE_SCALAR].projected[SPEEDUP_720]);
}

/* No line of Table 1 has more than 110 characters. */
TEST(width)
{
    print(speedup_report_table1, TABLE_PLAIN);
    for (const char *line = text; *line != '\0';) {
        size_t length = strcspn(line, "\n");
        assert_in_range(length, 0, 110);
        line += length + 1;
    }
}

/* ---- Formulations ---------------------------------------------------------- */

/* All formulations produce the same image, with different clocks. The first formulation
 * is the cylinder of Table 1. */
TEST(formulations)
{
    FREED struct speedup_measure(
        *measures)[TRACE_FORMS] = calloc(speedup_formulation_count, sizeof *measures);
    const struct csv_table *table1 = read_table1();
    static struct csv_table csv;
    assert_non_null(measures);
    for (size_t i = 0; i < speedup_formulation_count; i++) {
        measure(&speedup_formulations[i], &view, measures[i]);
        assert_true(measures[i][TRACE_SCALAR].checksum
                    == measures[i][TRACE_VECTOR].checksum);
        assert_int_equal(measures[i][TRACE_SCALAR].hits,
                         measures[0][TRACE_SCALAR].hits);
        for (size_t k = 0; k < i; k++)
            for (int mode = 0; mode < TRACE_FORMS; mode++)
                assert_true(measures[i][mode].total != measures[k][mode].total);
    }
    SCOPED(table) *table =
        formulations_table(prior_model,
                           (const struct speedup_measure(*)[TRACE_FORMS])measures);
    FILE *stream = fmemopen(text, sizeof text, "w");
    assert_true(table && stream);
    assert_true(table_write(table, TABLE_CSV, stream));
    assert_int_equal(fclose(stream), 0);
    assert_string_equal(csv_table(text, &csv), "");
    assert_int_equal(csv.rows, 2 + speedup_formulation_count);
    for (int i = 0; i < TRACE_FORMS + 1; i++) {
        double reported = strtod(csv.cell[1][1 + 2 * i], NULL);
        assert_true(reported == printed[1].figures[i]);
        assert_string_equal(csv.cell[1][2 + 2 * i], "");
        assert_near(strtod(csv.cell[2][1 + 2 * i], NULL),
                    figure(table1, line_of(table1, "cylinder", "ours"), i));
        for (size_t row = 2; row < csv.rows; row++)
            assert_near(strtod(csv.cell[row][2 + 2 * i], NULL),
                        100 * (strtod(csv.cell[row][1 + 2 * i], NULL) / reported - 1));
    }
}

/* ---- Formats ------------------------------------------------------------ */

TEST(markdown)
{
    print(speedup_report_table1, TABLE_MARKDOWN);
    const char *rule = NON_NULL(strstr(text, "\n|:-"));
    assert_int_equal(strncmp(text, "\n## Table 1", 11), 0);
    assert_non_null(strstr(rule, "-:|"));
    assert_non_null(strstr(rule, "\n| sphere "));
}

/* ---- Projections -------------------------------------------------------- */

/* Models are compared with the 720's prior model, fitted ones with its fitted model. */
TEST(projection_models)
{
    static const char *const rows[][2] = {
        { "cyber205-2pipe", "cyber720" },
        { "cyber205-4pipe", "cyber720" },
        { "cyber205-2pipe-prior", "cyber720-prior" },
        { "cyber205-1pipe-prior", "cyber720-prior" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(c205_model) *on = NON_NULL(c205_model_find(rows[i][0], &failure));
        assert_string_equal(speedup_projection_model(on, SPEEDUP_720), rows[i][1]);
        assert_string_equal(speedup_projection_model(on, SPEEDUP_6600), "cdc6600");
    }
}

/* The scalar form does the same work on both models of the 205, so the difference comes
 * from the models of the 720. */
TEST(projected)
{
    c205_model *priors = prior_model;
    struct speedup_measure prior[TRACE_FORMS], fitted[TRACE_FORMS];
    measure(&speedup_subjects[0], &view, prior);
    prior_model = c205_model_find("cyber205-2pipe", &failure);
    measure(&speedup_subjects[0], &view, fitted);
    c205_model_free(prior_model);
    prior_model = priors;
    assert_true(prior[TRACE_SCALAR].projected[SPEEDUP_720]
                != fitted[TRACE_SCALAR].projected[SPEEDUP_720]);
    assert_true(prior[TRACE_SCALAR].projected[SPEEDUP_6600]
                == fitted[TRACE_SCALAR].projected[SPEEDUP_6600]);
}

FIXTURE(set_up)
{
    if (set_up_model(test_state) == 0)
        report = report_all();
    return !report;
}

FIXTURE(tear_down)
{
    speedup_report_free(report);
    return tear_down_model(test_state);
}

GROUP(set_up, tear_down);
