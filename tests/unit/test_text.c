/* test_text.c - the scene language. The extents of characters of fonts are compared
 * with POV-Ray for the same texts, and outlines with their rules. A wrong bearing,
 * kerning or loop fails here. */
#include "base/file.h"
#include "rt/scene/font.h"
#include "rt/scene/transform.h"
#include "rt/shapes/path.h"
#include "tests/random.h"
#include "tests/unit/scene_reading.h"

/* A character's prism: its points for each corner (2 with handles), and its ends. */
struct character {
    const struct outline *path;
    size_t apart;
    double low, high;
};

static struct character character_of(const struct primitive *primitive)
{
    if (primitive->kind == PRIMITIVE_PRISM)
        return (struct character){ &primitive->shape.prism.path, 1,
                                   primitive->shape.prism.low,
                                   primitive->shape.prism.high };
    assert_int_equal(primitive->kind, PRIMITIVE_QUADRATIC_PRISM);
    return (struct character){ &primitive->shape.quadratic_prism.path, 2,
                               primitive->shape.quadratic_prism.low,
                               primitive->shape.quadratic_prism.high };
}

static void widen(const struct primitive *primitive, double x, double height, double z,
                  double low[3], double high[3])
{
    double point[3] = { x, height, z };
    transform_point(&primitive->to_world, point);
    for (int k = 0; k < 3; k++) {
        low[k] = fmin(low[k], point[k]);
        high[k] = fmax(high[k], point[k]);
    }
}

/* Returns point w of a parabola with a handle. */
static double along(const double *points, size_t k, double w)
{
    double s = 1 - w;
    return s * s * points[k] + 2 * s * w * points[2 + k] + w * w * points[4 + k];
}

/* Returns the parameter of the extremum, clamped to the ends. */
static double turning(const double *points, size_t k)
{
    double lead = points[2 + k] - points[k];
    double bend = points[k] - 2 * points[2 + k] + points[4 + k];
    return bend == 0 ? 0 : fmax(0, fmin(1, -lead / bend));
}

/* Computes the extent of a scene's prisms in world space. */
static void extent_of(const struct scene *scene, double low[3], double high[3])
{
    for (int k = 0; k < 3; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
    }
    for (size_t i = 0; i < scene->primitive_count; i++) {
        const struct primitive *primitive = &scene->primitives[i];
        struct character one = character_of(primitive);
        struct path_walk walk = { .path = one.path, .apart = one.apart };
        while (path_next(&walk)) {
            const double *at = walk.from;
            widen(primitive, at[0], one.low, at[1], low, high);
            widen(primitive, at[0], one.high, at[1], low, high);
            if (one.apart == 1)
                continue;
            path_next(&walk);
            for (size_t k = 0; k < 2; k++) {
                double w = turning(at, k);
                widen(primitive, along(at, 0, w), one.low, along(at, 1, w), low, high);
            }
        }
    }
}

/* POV-Ray's bounds are about 2e-5 too large. */
#define WITHIN 1e-4

/* The min_extent and max_extent of POV-Ray for the same text, with bearings, kerning,
 * offsets, blanks, and characters outside of ASCII. */
TEST(extents)
{
    static const struct {
        const char *font, *string, *offset;
        double extent[4]; /* the low corner, then the high corner */
    } rows[] = {
        { "cyrvetic", "C", "0", { 0, -.02102, .63602, .74901 } },
        { "cyrvetic", "@", "0", { 0, -.15102, .90602, .71602 } },
        { "cyrvetic", "CC", "0", { 0, -.02102, 1.33402, .74902 } },
        { "cyrvetic", "CC", "<.1, .05, .2>", { 0, -.02102, 1.43402, .79903 } },
        { "cyrvetic", "Crystal @", "0", { 0, -.22302, 4.23602, .74907 } },
        { "timrom", "A", "0", { 0, 0, .73602, .69601 } },
        { "timrom", "AV", "0", { 0, -.01602, 1.27802, .69602 } },
        { "timrom", "AVTo 205&gi", "0", { 0, -.21202, 5.69102, .6961 } },
        { "timrom", "WAVE Tolstoy", "0", { 0, -.21202, 6.00102, .6961 } },
        { "timrom", "\\u00c9\\u00fc", "0", { 0, 0, 1.01202, .61802 } },
        { "crystal", "CDC", "0", { 0, -.00783, 1.4048, .68704 } },
        { "crystal", "205, Cyber!", "<-.1, .2, 0>", { 0, .00096, 4.51564, 2.68514 } },
        { "povlogo", "P", "0", { 0, .00194, .66994, 1.00196 } },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        double low[3], high[3];
        SCOPED(scene) *scene = read_format("text { ttf \"%s.ttf\" \"%s\" 1, %s }",
                                           rows[i].font, rows[i].string,
                                           rows[i].offset);
        extent_of(scene, low, high);
        for (int k = 0; k < 2; k++) {
            assert_close(low[k], rows[i].extent[k], WITHIN);
            assert_close(high[k], rows[i].extent[2 + k], WITHIN);
        }
        assert_close(low[2], 0, 0);
        assert_close(high[2], 1, 0);
    }
}

static double area_of(const double from[2], const double handle[2], const double to[2])
{
    double way[2] = { to[0] - from[0], to[1] - from[1] };
    double lead[2] = { handle[0] - from[0], handle[1] - from[1] };
    return (from[0] * to[1] - to[0] * from[1]) / 2
           + (lead[0] * way[1] - lead[1] * way[0]) / 3;
}

/* The dot of this font is round. Its parabolas enclose the area of an ellipse. */
TEST(curves)
{
    SCOPED(scene) *scene = read_scene("text { ttf \"timrom.ttf\" \".\" 1, 0 }");
    struct character dot = character_of(scene->primitives);
    const double(*points)[2] = (const double(*)[2])dot.path->points;
    double low[3], high[3], area = 0;
    assert_int_equal(dot.apart, 2);
    extent_of(scene, low, high);
    double ellipse = atan(1) * (high[0] - low[0]) * (high[1] - low[1]);
    for (size_t i = 0; i + 2 < dot.path->count; i += 2)
        area += area_of(points[i], points[i + 1], points[i + 2]);
    assert_close(fabs(area) / ellipse, 1, .01);
}

/* The letter has small curves at its feet. Its other edges are straight, and some are
 * slanted. The area between its curves and their chords is nearly zero. */
TEST(slanted)
{
    SCOPED(scene) *scene = read_scene("text { ttf \"timrom.ttf\" \"A\" 1, 0 }");
    struct character letter = character_of(scene->primitives);
    struct path_walk walk = { .path = letter.path, .apart = letter.apart };
    double bows = 0, area = 0;
    assert_int_equal(letter.apart, 2);
    while (path_next(&walk)) {
        const double *from = walk.from;
        path_next(&walk);
        double chord = area_of(from, from, from + 4);
        bows += fabs(area_of(from, from + 2, from + 4) - chord);
        area += chord;
    }
    assert_close(bows / fabs(area), 0, .03);
}

/* Characters without curves are prisms with straight edges. */
TEST(straight)
{
    SCOPED(scene) *scene = read_scene("text { ttf \"cyrvetic.ttf\" \"TI\" 1, 0 }");
    assert_int_equal(scene->primitive_count, 2);
    for (size_t i = 0; i < 2; i++)
        assert_int_equal(character_of(&scene->primitives[i]).apart, 1);
}

/* ---- Unusual fonts --------------------------------------------------------- */

static unsigned two_bytes(const unsigned char *at)
{
    return (unsigned)at[0] << 8 | at[1];
}

static size_t four_bytes(const unsigned char *at)
{
    return (size_t)two_bytes(at) << 16 | two_bytes(at + 2);
}

/* Returns a table of a TrueType file by the position in the directory. */
static unsigned char *table_of(unsigned char *font, const char *name)
{
    unsigned count = two_bytes(font + 4);
    for (unsigned char *row = font + 12; count > 0; count--, row += 16)
        if (!memcmp(row, name, 4))
            return font + four_bytes(row + 8);
    fail_msg("the font has no table %s", name);
    return NULL;
}

/* Reduces the first of several loops to a point, which fonts use as a mark. */
static void leave_points(unsigned char *font)
{
    const unsigned char *places = table_of(font, "loca");
    unsigned char *glyphs = table_of(font, "glyf");
    bool is_long = two_bytes(table_of(font, "head") + 50) != 0;
    unsigned count = two_bytes(table_of(font, "maxp") + 4);
    for (size_t i = 0; i < count; i++) {
        size_t begin = is_long ? four_bytes(places + 4 * i)
                               : 2 * two_bytes(places + 2 * i);
        size_t end = is_long ? four_bytes(places + 4 * i + 4)
                             : 2 * two_bytes(places + 2 * i + 2);
        unsigned loops = end > begin ? two_bytes(glyphs + begin) : 0;
        if (loops > 1 && loops < 0x8000)
            glyphs[begin + 10] = glyphs[begin + 11] = 0;
    }
}

/* All points belong to edges of positive length in closed loops. */
static void check_outline(const struct glyph *glyph)
{
    const struct outline path = { glyph->count, glyph->points };
    struct path_walk walk = { .path = &path, .apart = glyph->apart };
    size_t used = 0;
    while (path_next(&walk)) {
        const double *from = walk.from;
        used += 1 + (size_t)walk.begins;
        used += glyph->apart - 1;
        if (glyph->apart == 2)
            assert_true(path_next(&walk));
        assert_false(!memcmp(from, walk.to, 2 * sizeof *from)
                     && !memcmp(from, from + 2, 2 * sizeof *from));
    }
    assert_int_equal(used, glyph->count);
}

static void check_font(const char *name, bool points)
{
    SCOPED_VALUE(arena) arena = { NULL, false };
    const char *fault;
    size_t length;
    const char *path = formatted("/usr/share/povray-3.7/include/%s.ttf", name);
    FREED char *bytes = NON_NULL(file_read(path, FILE_LARGEST, &length, &failure));
    if (points)
        leave_points((unsigned char *)bytes);
    struct font *font = NON_NULL(font_open(bytes, length, &fault));
    for (uint32_t character = 32; character < 256; character++) {
        struct glyph glyph;
        assert_true(font_glyph(font, character, &arena, &glyph));
        check_outline(&glyph);
    }
    font_close(font);
}

TEST(outlines)
{
    static const char *const names[] = { "timrom", "cyrvetic", "crystal", "povlogo" };
    for (size_t i = 0; i < 2 * COUNT(names); i++)
        check_font(names[i / 2], i % 2);
}

/* ---- Loops that touch themselves --------------------------------------------- */

enum { MAX_LOOP = 24 };

/* Random loops on a small grid touch themselves. The result must be the same loop,
 * starting at another point. If any point occurs only once, so must the first. */
static void check_touching_loop(size_t corners, size_t apart, uint64_t *random)
{
    size_t count = corners * apart, begin = 0;
    double before[MAX_LOOP][2] = { { 0 } }, after[MAX_LOOP][2];
    size_t times[MAX_LOOP] = { 0 };
    for (size_t j = 0; j < count; j++)
        for (int k = 0; k < 2; k++)
            before[j][k] = (double)xorshift_between(random, 0, 2);
    for (size_t j = 0; j < count; j += apart)
        for (size_t k = 0; k < count; k += apart)
            times[j] += !memcmp(before[j], before[k], sizeof *before);
    memcpy(after, before, sizeof after);
    font_turn_loop(after, count, apart);
    while (begin < count && times[begin] > 1)
        begin += apart;
    for (size_t j = 0; j < count; j++)
        assert_memory_equal(after[j], before[(begin + j) % count], sizeof *after);
}

TEST(touching_loops)
{
    uint64_t random = RANDOM_SEED;
    for (size_t i = 0; i < 2000; i++)
        check_touching_loop((size_t)xorshift_between(&random, 1, 12), 1 + i % 2,
                            &random);
}

/* ---- Cubic curves -------------------------------------------------------- */

/* A font in the Compact Font Format whose only character, A, is a cubic curve. A point
 * of the curve is relative to its predecessor. draw_cubic replaces the zeros after each
 * 28 of the curve by a coordinate. */
static const unsigned char cubic_font[] = {
    1,  0, 4,  2,                     /* header */
    0,  1, 1,  1,  2,  'A',           /* name */
    0,  1, 1,  1,  16,                /* offsets of: */
    28, 0, 34, 15,                    /* character set */
    28, 0, 37, 17,                    /* curves */
    28, 0, 0,  28, 0,  71,  18,       /* no private data */
    0,  0, 0,  0,                     /* no strings, no routines */
    0,  0, 34,                        /* the set: A */
    0,  2, 1,  1,  2,  29,  14,       /* curves: of no character */
    28, 0, 0,  28, 0,  0,   21,       /* of A: begin at a point */
    28, 0, 0,  28, 0,  0,   28, 0, 0, /* cubic curve */
    28, 0, 0,  28, 0,  0,   28, 0, 0, 8, 14
};
enum { CUBIC_BEGIN = 44, EM = 1000 };

/* Draws a curve and writes it into a font. The points are in em. */
static void draw_cubic(uint64_t *random, double points[4][2],
                       unsigned char font[sizeof cubic_font])
{
    unsigned char *next = font + CUBIC_BEGIN;
    memcpy(font, cubic_font, sizeof cubic_font);
    for (int i = 0; i < 4; i++, next += i == 1)
        for (int k = 0; k < 2; k++, next += 3) {
            int64_t step = xorshift_between(random, -EM, EM);
            next[1] = (unsigned char)(step >> 8);
            next[2] = (unsigned char)step;
            points[i][k] = (i > 0 ? points[i - 1][k] : 0) + (double)step / EM;
        }
}

static double cubic(double points[4][2], int k, double t)
{
    double s = 1 - t;
    return s * s * s * points[0][k] + 3 * s * s * t * points[1][k]
           + 3 * s * t * t * points[2][k] + t * t * t * points[3][k];
}

/* A cubic curve becomes the least number of parabolas that differ from the curve by at
 * most 1e-5 em. A straight line closes the loop. */
TEST(cubic_curves)
{
    uint64_t random = RANDOM_SEED;
    for (int curve = 0; curve < 1000; curve++) {
        SCOPED_VALUE(arena) arena = { NULL, false };
        unsigned char bytes[sizeof cubic_font];
        double points[4][2], worst = 0, third[2];
        const char *fault;
        struct glyph glyph;
        draw_cubic(&random, points, bytes);
        struct font *font = NON_NULL(
            font_open((const char *)bytes, sizeof bytes, &fault));
        assert_true(font_glyph(font, 'A', &arena, &glyph));
        font_close(font);
        assert_true(glyph.count >= 5);
        size_t parts = (glyph.count - 3) / 2;
        for (size_t i = 0; i < 20 * parts; i++) {
            double w = (double)(i % 20) / 20, off[2];
            for (int k = 0; k < 2; k++)
                off[k] = along(glyph.points[i / 20 * 2], (size_t)k, w)
                         - cubic(points, k, ((double)(i / 20) + w) / (double)parts);
            worst = fmax(worst, hypot(off[0], off[1]));
        }
        for (int k = 0; k < 2; k++)
            third[k] = points[3][k] - 3 * points[2][k] + 3 * points[1][k]
                       - points[0][k];
        assert_true(worst < 1.0001e-5);
        assert_true(sqrt(3) / 36 * hypot(third[0], third[1])
                    > 1e-5 * pow((double)parts - 1, 3));
    }
}

TEST(modifiers)
{
    SCOPED(scene) *scene = read_scene(
        "text { ttf concat(\"cyrvetic\", \".ttf\"), \"I I\" -.5, 0"
        " scale 2 translate <1, 2, 3> pigment { rgb x } no_shadow }");
    double low[3], high[3];
    extent_of(scene, low, high);
    assert_int_equal(scene->primitive_count, 2);
    assert_true(scene->primitives[1].no_shadow);
    assert_vector(scene->primitives[1].pigment.color[0], 1, 0, 0);
    assert_close(low[0], 1, CLOSE);
    assert_close(low[1], 2, CLOSE);
    assert_close(low[2], 2, CLOSE);
    assert_close(high[2], 3, CLOSE);
}

TEST(blank)
{
    SCOPED(scene) *scene = read_with("text { ttf \"timrom.ttf\" \" \" 1, 0 }", 1);
    assert_int_equal(scene->primitive_count, 0);
}

static const struct line_error errors[] = {
    { "text { \"a.ttf\" \"a\" 1, 0 }", 8, "expected ttf" },
    { "text { ttf \"no.ttf\" \"a\" 1, 0 }", 12, "no such file" },
    { "text { ttf \"math.inc\" \"a\" 1, 0 }", 1, "the file is not a font" },
    { "text { internal 1 \"a\" 1, 0 }", 8, "built-in fonts" },
    { "text { ttf \"timrom.ttf\" 1, 0 }", 25, "expected a string" },
    { "text { ttf \"timrom.ttf\" \"a\" x, 0 }", 29, "expected a number" },
};

TEST_CALL(errors, assert_errors(errors, COUNT(errors)))
