/* test_overlaps.c - the volumes that two parts share are compared with counts of cells,
 * over random boxes with integer coordinates. A missing or repeated pair fails here. */
#include <math.h>

#include "rt/mass/figures.h"
#include "rt/scene/named_parts.h"
#include "tests/oracle/many_scenes.h"
#include "tests/random.h"
#include "tests/unit/unit.h"

#define STUDENT 2.3646 /* Student's t for 7 degrees of freedom */
enum { SIDE = 9, MAX_PARTS = 50, MAX_BOXES = 160, SCENES = 8 };

/* ---- Random boxes ----------------------------------------------------- */

struct box {
    size_t part;
    int low[3], high[3];
};

struct crowd {
    size_t part_count, box_count;
    struct box boxes[MAX_BOXES];
    char *text;
};

/* Each box of a part is a separate object. All of them have the name of the part. */
static void write_text(struct crowd *crowd)
{
    size_t length;
    FILE *file = NON_NULL(open_memstream(&crowd->text, &length));
    for (size_t i = 0; i < crowd->box_count; i++) {
        const struct box *box = &crowd->boxes[i];
        fprintf(file,
                "#declare P%zu = box { <%d, %d, %d>, <%d, %d, %d> }\n"
                "object { P%zu }\n",
                box->part, box->low[0], box->low[1], box->low[2], box->high[0],
                box->high[1], box->high[2], box->part);
    }
    fclose(file);
}

static void draw_box(struct box *box, uint64_t *random)
{
    for (int k = 0; k < 3; k++) {
        int a = (int)xorshift_between(random, 0, SIDE - 1);
        int b = (int)xorshift_between(random, 0, SIDE - 1);
        box->low[k] = a < b ? a : b;
        box->high[k] = (a < b ? b : a) + 1;
    }
}

/* Makes few parts of many boxes, or more parts than a word has bits. */
static void draw(struct crowd *crowd, uint64_t *random)
{
    bool many = xorshift_between(random, 0, 3) == 0;
    crowd->part_count = (size_t)(many ? MAX_PARTS : xorshift_between(random, 1, 5));
    crowd->box_count = 0;
    for (size_t part = 0; part < crowd->part_count; part++) {
        int64_t count = xorshift_between(random, 1, many ? 2 : 9);
        for (int64_t i = 0; i < count; i++) {
            struct box *box = &crowd->boxes[crowd->box_count++];
            box->part = part;
            draw_box(box, random);
        }
    }
    write_text(crowd);
}

/* ---- Expected results ---------------------------------------------------- */

static bool covers(const struct box *box, const int cell[3])
{
    bool inside = true;
    for (int k = 0; k < 3; k++)
        inside = inside && box->low[k] <= cell[k] && cell[k] < box->high[k];
    return inside;
}

/* Counts the cells that both parts of a pair contain. The entry of a part with itself
 * counts the cells that several of its boxes contain. */
static void count_cells(const struct crowd *crowd, double cells[MAX_PARTS][MAX_PARTS])
{
    memset(cells, 0, sizeof(double[MAX_PARTS][MAX_PARTS]));
    for (int i = 0; i < SIDE * SIDE * SIDE; i++) {
        const int cell[3] = { i % SIDE, i / SIDE % SIDE, i / SIDE / SIDE };
        int count[MAX_PARTS] = { 0 };
        for (size_t k = 0; k < crowd->box_count; k++)
            count[crowd->boxes[k].part] += covers(&crowd->boxes[k], cell);
        for (size_t a = 0; a < crowd->part_count; a++)
            for (size_t b = a; b < crowd->part_count; b++)
                cells[a][b] += a == b ? count[a] > 1 : count[a] > 0 && count[b] > 0;
    }
}

struct found {
    struct named_parts parts;
    struct overlaps overlaps;
    struct columns_sums sums;
    uint64_t checksum;
};

static void find(const struct crowd *crowd, enum trace_mode mode, size_t queue,
                 struct found *found)
{
    SCOPED(scene) *scene = scene_of(crowd->text);
    SCOPED(c205_model) *model = usual_model();
    struct columns_options options = {
        .mode = mode,
        .queue = queue,
        .points = POINTS_LATTICE,
        /* with many parts, there are more crossings than in a strip */
        .rays_log = crowd->part_count > 9 ? 6 : 5,
        .repeats = 8,
        .seed = 1,
        .jobs = 2,
        .model = model
    };
    assert_true(named_parts_find(scene, &found->parts));
    assert_true(overlaps_find(scene, found->parts.part_of, found->parts.count,
                              &found->overlaps));
    options.part_count = found->parts.count;
    options.part_of = found->parts.part_of;
    options.overlaps = &found->overlaps;
    FAIL_IF(!columns_sum(scene, &options, &found->sums, &failure), "%s%s", crowd->text,
            failure.message);
    found->checksum = columns_checksum(&found->sums);
}

static void found_free(struct found *found)
{
    columns_sums_free(&found->sums);
    overlaps_free(&found->overlaps);
    named_parts_free(&found->parts);
}

/* Every overlapping pair must be reported with its volume. */
static void check(const struct crowd *crowd, const struct found *found)
{
    static double cells[MAX_PARTS][MAX_PARTS];
    count_cells(crowd, cells);
    assert_int_equal(found->parts.count, crowd->part_count);
    for (size_t i = 0; i < found->overlaps.count; i++) {
        const size_t *parts = found->overlaps.pairs[i].parts;
        double expected = cells[parts[0]][parts[1]], volume, error;
        bool some = mass_overlap_of(&found->sums, i, &volume, &error);
        FAIL_IF(some != (expected > 0)
                    || fabs(volume - expected) > 8 * error / STUDENT + 1e-6,
                "%sP%zu and P%zu claim both %.9g, not %.9g: the error is %.2g",
                crowd->text, parts[0], parts[1], volume, expected, error);
        cells[parts[0]][parts[1]] = 0;
    }
    for (size_t a = 0; a < crowd->part_count; a++)
        for (size_t b = a; b < crowd->part_count; b++)
            FAIL_IF(cells[a][b] > 0, "%sP%zu and P%zu are no pair", crowd->text, a, b);
}

/* ---- The tests ----------------------------------------------------------- */

TEST(boxes)
{
    uint64_t random = RANDOM_SEED + 11;
    for (int i = 0; i < SCENES; i++) {
        struct crowd crowd;
        SCOPED_VALUE(found) vector, scalar;
        draw(&crowd, &random);
        find(&crowd, TRACE_VECTOR, 2000, &vector);
        check(&crowd, &vector);
        find(&crowd, TRACE_SCALAR, 0, &scalar);
        FAIL_IF(vector.checksum != scalar.checksum, "%sthe forms differ", crowd.text);
        free(crowd.text);
    }
}

/* Parts that touch at a face share no volume. Separate parts form no pair. */
TEST(touching)
{
    struct crowd crowd = {
        .part_count = 3,
        .box_count = 4,
        .boxes = { { 0, { 0, 0, 0 }, { 3, 3, 3 } },
                   { 1, { 3, 1, 1 }, { 5, 2, 2 } },
                   { 1, { 5, 0, 0 }, { 6, 9, 9 } },
                   { 2, { 8, 8, 8 }, { 9, 9, 9 } } },
    };
    SCOPED_VALUE(found) found;
    write_text(&crowd);
    find(&crowd, TRACE_VECTOR, 77, &found);
    check(&crowd, &found);
    for (size_t i = 0; i < found.overlaps.count; i++)
        assert_int_not_equal(found.overlaps.pairs[i].parts[1], 2);
    free(crowd.text);
}
