/* test_profile.c - the profiles of the three stages are compared. They must have the
 * same frames and rays, parts that sum to all clocks, and tables that sum to the parts.
 * A region without a part, or a missing row, fails here. */
#include "tests/unit/traced_frame.h"

#include "rt/study/profile.h"

#define SCENE \
    AHEAD "light_source { <5, 9, -7>, 1 }" \
          "plane { y, -1 pigment { checker rgb 1, rgb .2 } }" \
          "sphere { 0, 1 pigment { rgb <1, .5, .2> } }"

static struct scene *scene;
static struct profile profile;

static double clocks_of_frame(int i)
{
    return (double)trace_accounts(profile.traces[i])->clocks;
}

TEST(stages)
{
    for (int i = 0; i < TRACE_MODES; i++) {
        const struct accounts *accounts = trace_accounts(profile.traces[i]);
        enum profile_part part;
        for (size_t k = 0; k < accounts->count; k++)
            assert_true(profile_part_of(accounts->items[k].name, &part));
        assert_true(trace_checksum(profile.traces[i])
                    == trace_checksum(profile.traces[0]));
        for (int kind = 0; kind < RAY_KINDS; kind++)
            assert_int_equal(trace_rays(profile.traces[i], (enum ray_kind)kind),
                             trace_rays(profile.traces[0], (enum ray_kind)kind));
    }
    assert_int_equal(trace_rays(profile.traces[0], RAY_PRIMARY), WIDTH * HEIGHT);
}

/* ---- The tables ---------------------------------------------------------- */

/* Returns a table as JSON. The caller frees it. */
static char *table_text_of(enum profile_table kind)
{
    char *text;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    SCOPED(table) *table = NON_NULL(profile_table(kind, &profile));
    struct json *json = NON_NULL(json_open_stream(file, NULL, &failure));
    table_json(table, json, "rows");
    assert_true(json_close(json, &failure));
    fclose(file);
    return text;
}

/* Returns the number of a key in the row that begins here. */
static double number_of(const char *row, const char *key)
{
    const char *at = NON_NULL(strstr(row, key));
    return strtod(strchr(at, ':') + 1, NULL);
}

/* The clocks of all parts sum to the clocks of the frame, and those of all kernels to
 * the clocks of their part. */
TEST(sums)
{
    enum { FRAME, PARTS, KERNELS, INTERSECT, SUMS };
    static const char *const keys[TRACE_MODES] = { "\"scalar_clocks\"",
                                                   "\"kernels_clocks\"",
                                                   "\"vector_clocks\"" };
    static const char row[] = "\"part\": \"";
    double sums[SUMS][TRACE_MODES] = { { 0 } };
    FREED char *text = table_text_of(PROFILE_CLOCKS);
    size_t rows = 0;
    for (const char *at = text; (at = strstr(at, row)) != NULL; rows++) {
        bool is_part = strncmp(strstr(at, "\"kernel\": "), "\"kernel\": \"\"", 12) == 0;
        at += strlen(row);
        bool is_frame = strncmp(at, "the frame", 9) == 0;
        for (int i = 0; i < TRACE_MODES; i++) {
            double clocks = number_of(at, keys[i]);
            sums[is_frame ? FRAME : is_part ? PARTS : KERNELS][i] += clocks;
            if (is_part && strncmp(at, "intersect", 9) == 0)
                sums[INTERSECT][i] += clocks;
        }
    }
    assert_true(rows > PROFILE_PARTS + 1);
    for (int i = 0; i < TRACE_MODES; i++) {
        assert_true(sums[FRAME][i] == clocks_of_frame(i));
        assert_true(sums[PARTS][i] == sums[FRAME][i]);
        assert_true(sums[KERNELS][i] == sums[INTERSECT][i]);
    }
}

/* Columns of clocks in the table of groups. The percentages are next to them. */
static const size_t millions[TRACE_MODES] = { 1, 3, 6 };

/* Sums the displayed rows: the groups, or their members, which are indented. */
static double sum_of_rows(const struct table *table, const char *text, size_t column,
                          bool members)
{
    const char *line = strchr(text, '\n') + 1;
    double sum = 0;
    for (size_t row = 0; row < table_rows(table); row++) {
        bool is_member = line[0] == ' ';
        bool is_frame = strncmp(line, "the frame", 9) == 0;
        if (!is_frame && is_member == members)
            sum += table_value(table, row, column);
        line = strchr(line, '\n') + 1;
    }
    return sum;
}

/* The groups and their percentages sum to the frame, the members to the group. */
TEST(groups)
{
    static char text[8192];
    SCOPED(table) *table = NON_NULL(profile_table(PROFILE_GROUPS, &profile));
    FILE *file = fmemopen(text, sizeof text, "w");
    assert_true(table_print(table, file));
    fclose(file);
    for (int i = 0; i < TRACE_MODES; i++)
        for (int members = 0; members < 2; members++) {
            double sum = sum_of_rows(table, text, millions[i], members);
            double shares = sum_of_rows(table, text, millions[i] + 1, members);
            assert_true(fabs(sum - clocks_of_frame(i) / 1e6) < 1e-9);
            assert_true(fabs(shares - 100) < 1e-9);
        }
    for (const char *line = text; *line; line = strchr(line, '\n') + 1)
        assert_in_range(strcspn(line, "\n"), 1, 100);
    for (const char *const *name =
             (const char *const[]){ "\nrays ", "\nintersections ", "\nsurfaces ",
                                    "\nthe frame ", NULL };
         *name; name++)
        assert_non_null(strstr(text, *name));
}

/* Amdahl's law gives the measured speedup if all parts are in vector form. */
TEST(amdahl)
{
    FREED char *text = table_text_of(PROFILE_SPEEDUP);
    const char *last = text;
    double speedup = clocks_of_frame(0) / clocks_of_frame(2);
    for (const char *at = text; (at = strstr(at, "\"stage\"")) != NULL; at++)
        last = at;
    assert_float_equal(number_of(last, "\"share_percent\""), 100, 1e-9);
    assert_float_equal(number_of(last, "\"part_speedup\""), speedup, 1e-9);
    assert_float_equal(number_of(last, "\"amdahl\""), speedup, 1e-9);
    assert_float_equal(number_of(last, "\"measured\""), speedup, 1e-9);
}

/* ---- All stages ---------------------------------------------------------- */

FIXTURE(trace_stages)
{
    if (set_up_frames(test_state) != 0)
        return 1;
    scene = read_text(SCENE);
    struct trace_options options = ON_PRIOR(.width = WIDTH, .height = HEIGHT,
                                            .queue = 200, .band = 5 * WIDTH, .jobs = 2);
    REQUIRE(profile_run(&profile, scene, &options, &failure));
    return 0;
}

FIXTURE(free_stages)
{
    profile_free(&profile);
    scene_free(scene);
    return tear_down_model(test_state);
}

GROUP(trace_stages, free_stages);
