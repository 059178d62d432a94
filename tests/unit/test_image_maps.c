/* test_image_maps.c - the samples of image files of all kinds are compared with POV-Ray
 * 3.7's pictures of the same bytes, and the words of an image_map with its fields. A
 * wrong gamma, channel order or place of a report fails here. */
#include "tests/unit/field_reading.h"

#define SEEN 6e-5 /* POV-Ray's pictures have four decimals */

/* ---- Files --------------------------------------------------------------- */

#define OLD_VERSION "#version 3.6; global_settings { assumed_gamma 1 }"

/* Returns a sphere with the image map of `words`, after the text `before`. */
static const char *image_text(const char *before, const char *words)
{
    static char text[1000];
    snprintf(text, sizeof text, "%s sphere { 0, 1 pigment { image_map { ", before);
    snprintf(text + strlen(text), sizeof text - strlen(text), words, field_path);
    return strcat(text, " } } }");
}

/* Reads an image map that causes `count` reports, the first with `message`. */
static struct scene *expect_reports(const char *before, const char *words, size_t count,
                                    const char *message)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    struct scene *scene = read_versioned("test.pov", image_text(before, words),
                                         &with_images, &reports);
    if (!scene || reports.count != count
        || (count > 0 && !strstr(reports.items->message, message))) {
        diagnostics_print(&reports, stderr);
        fail_msg("not %zu reports: '%s'", count, message);
    }
    assert_int_equal(scene->primitives->pigment.kind, PIGMENT_IMAGE);
    return scene;
}

static void expect_fault(const char *words, size_t column, const char *message)
{
    assert_error(image_text("", words), &with_images, 1,
                 column + sizeof "sphere { 0, 1 pigment { image_map { ", message);
}

/* ---- Samples ------------------------------------------------------------- */

/* Images of one row: 0, 10, 11, 64, 128, 200, 250, 255 of 255, or as parts of 65535. */
enum { SHADES = 8 };
#define GREYS "\x00\x0a\x0b@\x80\xc8\xfa\xff"
#define GREYS16 "\0\0\x0a\x0a\x0b\x0b@@\x80\x80\xc8\xc8\xfa\xfa\xff\xff"
#define COLORS \
    "\0\0\0\x0a\x0a\x0a\x0b\x0b\x0b@@@\x80\x80\x80\xc8\xc8\xc8\xfa\xfa\xfa" \
    "\xff\xff\xff"
#define FILE_OF(bytes) bytes, sizeof bytes - 1

/* The values that POV-Ray shows for these samples. */
static const double as_they_are[SHADES] = { 0,     .0392, .0431, .2510,
                                            .5020, .7843, .9804, 1 };
static const double as_srgb[SHADES] = {
    0, .0030, .0033, .0513, .2159, .5776, .9560, 1
};
static const double to_the_2_2[SHADES] = { 0,     .0008, .0010, .0478,
                                           .2195, .5860, .9574, 1 };
static const double grey_png[SHADES] = { 0, 0, 0, .0510, .2157, .5765, .9529, 1 };
static const double grey_png_1[SHADES] = { 0,     .0353, .0431, .2510,
                                           .5020, .7804, .9804, 1 };
static const double grey_png_2_2[SHADES] = { 0, 0, 0, .0471, .2157, .5843, .9569, 1 };

/* A PNG file of 8 x 1 pixels: the rest of its header, and all but its last chunk. */
#define PNG_OF(bytes) \
    "\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR\x00\x00\x00\x08\x00\x00\x00\x01" bytes \
    "\x00\x00\x00\x00IEND\xae\x42`\x82"
/* The grey values, after chunks about their gamma. */
#define GREY_PNG(gamma) \
    PNG_OF("\x08\x00\x00\x00\x00\xc6k\xb0\x9f" gamma \
           "\x00\x00\x00\x11IDATx\x9c\x63`\xe0\xe2vh8\xf1\xeb\x3f\x00\x09" \
           "\x1c\x03\x97\x90\x37\x30\x14")
#define GREY_PNG_1 GREY_PNG("\x00\x00\x00\x04gAMA\x00\x01\x86\xa0\x31\xe8\x96_")
#define GREY_PNG_2_2 GREY_PNG("\x00\x00\x00\x04gAMA\x00\x00\xb1\x8f\x0b\xfc\x61\x05")
#define GREY_PNG_SRGB GREY_PNG("\x00\x00\x00\x01sRGB\x00\xae\xce\x1c\xe9")
#define GREY_PNG_16 \
    PNG_OF("\x10\x00\x00\x00\x00\x96\xfbl\xdc\x00\x00\x00\x19IDATx\x9c\x63``\xe0" \
           "\xe2\xe2\xe6vphh8q\xe2\xd7\xaf\xff\xff\x01 \xc7\x07-\x1f\x30\x14]")
#define COLOR_PNG \
    PNG_OF("\x08\x02\x00\x00\x00lbx\x14\x00\x00\x00\"IDATx\x9c\x63```\xe0\xe2" \
           "\xe2\xe2\xe6\xe6vpphhh8q\xe2\xc4\xaf_\xbf\xfe\xff\xff\x0f\x00G\x02" \
           "\x0a\xc3JI|\xff")
#define TABLE_PNG \
    PNG_OF("\x08\x03\x00\x00\x00\xd4\xde\x1fq\x00\x00\x00\x18PLTE\x00\x00\x00" \
           "\x0a\x0a\x0a\x0b\x0b\x0b@@@\x80\x80\x80\xc8\xc8\xc8\xfa\xfa\xfa\xff" \
           "\xff\xff\x62-#\x97\x00\x00\x00\x11IDATx\x9c\x63``dbfaec\x07\x00\x00]" \
           "\x00\x1d\xb3\xba\xa5\x0a")
#define CLEAR_PNG \
    PNG_OF("\x08\x04\x00\x00\x00I\x09'\xc8\x00\x00\x00\x1aIDATx\x9c\x63`\xf8\xcf" \
           "\xf5\x90\xfb\xb0\xc3\xd2\x86\xf6\x13\x99\xbf\xbc\xff\xeb\x02\x00\x41" \
           "\x8f\x08G,\xf7\xb7\x8c")

#define COLOR_TIFF \
    "II*\x00\x08\x00\x00\x00\x0a\x00\x00\x01\x03\x00\x01\x00\x00\x00\x08\x00\x00\x00" \
    "\x01\x01\x03\x00\x01\x00\x00\x00\x01\x00\x00\x00\x02\x01\x03\x00\x03\x00\x00\x00" \
    "\x86\x00\x00\x00\x03\x01\x03\x00\x01\x00\x00\x00\x01\x00\x00\x00\x06\x01\x03\x00" \
    "\x01\x00\x00\x00\x02\x00\x00\x00\x11\x01\x04\x00\x01\x00\x00\x00\x8c\x00\x00\x00" \
    "\x15\x01\x03\x00\x01\x00\x00\x00\x03\x00\x00\x00\x16\x01\x03\x00\x01\x00\x00\x00" \
    "\x01\x00\x00\x00\x17\x01\x04\x00\x01\x00\x00\x00\x18\x00\x00\x00\x1c\x01\x03\x00" \
    "\x01\x00\x00\x00\x01\x00\x00\x00\x00\x00\x00\x00\x08\x00\x08\x00\x08\x00\x00\x00" \
    "\x00\x0a\x0a\x0a\x0b\x0b\x0b@@@\x80\x80\x80\xc8\xc8\xc8\xfa\xfa\xfa\xff\xff\xff"

#define TABLE_GIF \
    "GIF89a\x08\x00\x01\x00\xa2\x00\x00\x00\x00\x00\x0a\x0a\x0a\x0b\x0b\x0b@@@\x80" \
    "\x80\x80\xc8\xc8\xc8\xfa\xfa\xfa\xff\xff\xff,\x00\x00\x00\x00\x08\x00\x01\x00" \
    "\x00\x03\x06\x08!8Th\x97\x00;"
#define COLOR_BMP \
    "BMN\x00\x00\x00\x00\x00\x00\x00\x36\x00\x00\x00(\x00\x00\x00\x08\x00\x00\x00\x01" \
    "\x00\x00\x00\x01\x00\x18\x00\x00\x00\x00\x00\x18\x00\x00\x00\x13\x0b\x00\x00\x13" \
    "\x0b\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x0a\x0a\x0a\x0b\x0b\x0b" \
    "@@@\x80\x80\x80\xc8\xc8\xc8\xfa\xfa\xfa\xff\xff\xff"

static const struct known_file {
    const char *word;
    const char *bytes;
    size_t count;
    const double *light;
} known_files[] = {
    { "pgm", FILE_OF("P5\n8 1\n255\n" GREYS), as_they_are },
    { "pgm", FILE_OF("P5\n8 1\n65535\n" GREYS16), as_they_are },
    { "ppm", FILE_OF("P6\n8 1\n255\n" COLORS), as_they_are },
    { "tiff", FILE_OF(COLOR_TIFF), as_they_are },
    { "tga", FILE_OF("\0\0\x02\0\0\0\0\0\0\0\0\0\x08\0\x01\0\x18\x20" COLORS),
      as_srgb },
    { "tga", FILE_OF("\0\0\x03\0\0\0\0\0\0\0\0\0\x08\0\x01\0\x08\x20" GREYS), as_srgb },
    { "bmp", FILE_OF(COLOR_BMP), as_srgb },
    { "gif", FILE_OF(TABLE_GIF), as_srgb },
    { "png", FILE_OF(COLOR_PNG), as_srgb },
    { "png", FILE_OF(TABLE_PNG), as_srgb },
    { "png", FILE_OF(GREY_PNG_16), as_srgb },
    { "png", FILE_OF(GREY_PNG("")), grey_png },
    { "png", FILE_OF(GREY_PNG_SRGB), grey_png },
    { "png", FILE_OF(GREY_PNG_1), grey_png_1 },
    { "png", FILE_OF(GREY_PNG_2_2), grey_png_2_2 },
};

static void expect_light(const char *before, const char *words,
                         const double light[SHADES])
{
    SCOPED(scene) *scene = expect_reports(before, words, 0, "");
    const struct image_table *table = scene->primitives->pigment.image.table;
    assert_int_equal(table->width, SHADES);
    assert_int_equal(table->height, 1);
    for (size_t i = 0; i < 3 * SHADES; i++) {
        double found = table->light[table->samples[i]];
        FAIL_IF(fabs(found - light[i / 3]) > SEEN, "%s, sample %zu: %.6f, not %.4f",
                words, i, found, light[i / 3]);
    }
}

TEST(kinds)
{
    for (size_t i = 0; i < COUNT(known_files); i++) {
        const struct known_file *file = &known_files[i];
        field_keep(file->bytes, file->count);
        expect_light("#version 3.7;", formatted("%s \"%%s\"", file->word), file->light);
        expect_light("", "\"%s\"", file->light);
    }
}

/* A gamma in the scene overrides the gamma of the file or its format. */
TEST(gammas)
{
    static const double working[SHADES] = { 0,     .0717, .0750, .2592,
                                            .4981, .7792, .9797, 1 };
    field_keep(FILE_OF("P5\n8 1\n255\n" GREYS));
    expect_light("", "\"%s\" gamma srgb", as_srgb);
    expect_light("", "\"%s\" gamma 2.2", to_the_2_2);
    expect_light("global_settings { assumed_gamma 2.2 }", "\"%s\"", as_they_are);
    field_keep(FILE_OF(GREY_PNG_1));
    expect_light("", "\"%s\" gamma 2.2", grey_png_2_2);
    expect_light("", "\"%s\" gamma srgb", grey_png);
    field_keep(FILE_OF(COLOR_PNG));
    expect_light("", "\"%s\" gamma 1", as_they_are);
    expect_light("global_settings { assumed_gamma 2.2 }", "\"%s\"", working);
    expect_light(OLD_VERSION, "\"%s\"", as_they_are);
    expect_light(OLD_VERSION, "\"%s\" gamma 2.2", to_the_2_2);
}

/* ---- Words --------------------------------------------------------------- */

static void expect_map(const char *words, enum image_mapping mapping,
                       enum image_sampling sampling, bool once, bool clear)
{
    SCOPED(scene) *scene = expect_reports("", words, 0, "");
    const struct image_map *map = &scene->primitives->pigment.image;
    assert_int_equal(map->mapping, mapping);
    assert_int_equal(map->sampling, sampling);
    assert_int_equal(map->once, once);
    assert_int_equal(pigment_is_clear(&scene->primitives->pigment), clear);
    assert_int_equal(pigment_cells(&scene->primitives->pigment), 1 + clear);
}

TEST(words)
{
    field_keep(FILE_OF("P6\n8 1\n255\n" COLORS));
    expect_map("\"%s\"", IMAGE_PLANAR, IMAGE_NEAREST, false, false);
    expect_map("ppm \"%s\" map_type 0 once", IMAGE_PLANAR, IMAGE_NEAREST, true, true);
    expect_map("<1, -1, 0> ppm \"%s\" map_type 1 once interpolate 2", IMAGE_SPHERICAL,
               IMAGE_BILINEAR, true, false);
    expect_map("\"%s\" once map_type 2 interpolate 4", IMAGE_CYLINDRICAL,
               IMAGE_BY_DISTANCE, true, true);
    expect_map("\"%s\" interpolate 2.7 map_type 5 once use_color", IMAGE_TORUS,
               IMAGE_BILINEAR, true, false);
    expect_map("\"%s\" map_type 2 use_alpha premultiplied off", IMAGE_CYLINDRICAL,
               IMAGE_NEAREST, false, false);
}

/* One table is stored for each file and gamma. */
TEST(tables)
{
    field_keep(FILE_OF("P6\n8 1\n255\n" COLORS));
    SCOPED(scene) *scene =
        read_format("#declare P = pigment { image_map { \"%s\" } }\n"
                    "sphere { 0, 1 pigment { P } }\n"
                    "sphere { 0, 1 pigment { image_map { ppm \"%s\" once } } }\n"
                    "sphere { 0, 1 pigment { image_map { \"%s\" gamma 2 } } }\n"
                    "sphere { 0, 1 pigment { image_map { \"%s\" gamma 2 } } }",
                    field_path, field_path, field_path, field_path);
    assert_int_equal(scene->image_count, 2);
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(scene->primitives[i].pigment.image.table->number, i / 2);
}

/* A pattern that replaces an image has no waves, unless a frequency is set. */
TEST(replaced)
{
    field_keep(FILE_OF("P6\n8 1\n255\n" COLORS));
    SCOPED(scene) *scene = read_format(
        "#declare P = pigment { onion frequency 3 }\n"
        "#declare Q = pigment { P image_map { \"%s\" } }\n"
        "sphere { 0, 1 pigment { Q radial phase .5 } }\n"
        "object { sphere { 0, 1 pigment { Q } } pigment { Q frequency 2 gradient x } }",
        field_path);
    assert_int_equal(scene->primitives[0].pigment.kind, PIGMENT_PATTERN);
    assert_close(scene->primitives[0].pigment.pattern.frequency, 0, 0);
    assert_close(scene->primitives[1].pigment.pattern.frequency, 2, 0);
}

/* ---- Reports --------------------------------------------------------------- */

static void expect_report(const char *words, const char *message)
{
    scene_free(expect_reports("", words, 1, message));
}

TEST(reports)
{
    field_keep(FILE_OF(CLEAR_PNG));
    expect_report("png \"%s\"", "a transparent image is drawn opaque");
    field_keep(FILE_OF("P6\n8 1\n255\n" COLORS));
    expect_report("\"%s\" filter all .5", "a transparent image is drawn opaque");
    expect_report("\"%s\" transmit 3, .5", "a transparent image is drawn opaque");
    expect_report("\"%s\" map_type 7", "'map_type 7'");
    expect_report("\"%s\" interpolate 3", "'interpolate 3'");
    expect_report("\"%s\" offset <.5, 0>", "'offset'");
    expect_report("<1, 0, -1> \"%s\"", "the vector of an image");
}

/* Images of unsupported kinds are black. */
TEST(kinds_left_out)
{
    static const char *const words[] = { "hdr \"a.hdr\" once", "exr \"a.exr\" gamma 2",
                                         "function 9, 9 { x }",
                                         "pigment 9, 9 { rgb 1 }" };
    for (size_t i = 0; i < COUNT(words); i++) {
        const char *text =
            formatted("sphere { 0, 1 pigment { image_map { %s } scale 2 } }", words[i]);
        SCOPED(scene) *scene = read_with(text, 1);
        assert_int_equal(scene->primitives->pigment.kind, PIGMENT_COLOR);
        assert_vector(scene->primitives->pigment.color[0], 0, 0, 0);
    }
}

/* A planar image in a sky always repeats: `once` is ignored, with a report. */
TEST(sky)
{
    for (size_t planar = 0; planar < 2; planar++) {
        field_keep(FILE_OF("P6\n8 1\n255\n" COLORS));
        const char
            *text = formatted("sky_sphere { pigment { image_map { \"%s\" %s once } } }",
                              field_path, planar ? "" : "map_type 1");
        SCOPED(scene) *scene = read_with(text, planar);
        assert_int_equal(scene->sky.kind, PIGMENT_IMAGE);
        assert_int_equal(scene->sky.image.once, !planar);
    }
}

TEST(faults)
{
    static const struct line_error errors[] = {
        { "sphere { 0, 1 pigment { image_map { \"no.png\" } } }", 37, "no such file" },
        { "sphere { 0, 1 pigment { image_map { png \"no.png\" } } }", 41,
          "no such file" },
        { "sphere { 0, 1 pigment { image_map { once } } }", 37,
          "the kind of an image, or its name" },
        { "sphere { 0, 1 pigment { image_map { png once } } }", 41,
          "the name of an image" },
    };
    assert_errors(errors, COUNT(errors));
    field_keep(FILE_OF("P6\n8 1\n255\n" COLORS));
    expect_fault("png \"%s\"", 5, "not an image of the kind 'png'");
    expect_fault("\"%s\" interpolate 1", 4 + strlen(field_path),
                 "'interpolate' must be 2, 3 or 4");
    expect_fault("\"%s\" gamma 0", 4 + strlen(field_path), "must be above 0");
    expect_fault("\"%s\" wibble", 4 + strlen(field_path),
                 "expected a keyword of image_map");
    field_keep("", 0);
    expect_fault("\"%s\"", 1, "the file is empty");
    field_keep(FILE_OF("P6\n8 1\n255\n"));
    expect_fault("\"%s\"", 1, "the file ends after 0 of 24 samples");
    field_keep(FILE_OF("P6\n9999 9999\n255\n"));
    expect_fault("\"%s\"", 1, "more than 8388608 pixels");
}

/* Each image alone is within the limit of pixels. */
TEST(limit)
{
    enum { SIDE = 2100, PIXELS = SIDE * SIDE };
    FREED char *bytes = calloc(1, 100 + PIXELS);
    SCOPED_VALUE(diagnostics) reports = { 0 };
    int head = sprintf(bytes, "P5\n%d %d\n255\n", SIDE, SIDE);
    field_keep(bytes, (size_t)head + PIXELS);
    scene_free(expect_reports("", "\"%s\"", 0, ""));
    const char
        *text = formatted("sphere { 0, 1 pigment { image_map { \"%s\" } } }\n"
                          "sphere { 0, 1 pigment { image_map { \"%s\" gamma 2 } } }",
                          field_path, field_path);
    assert_null(read_versioned("test.pov", text, &with_images, &reports));
    assert_int_equal(reports.count, 1);
    assert_int_equal(reports.items->line, 2);
    assert_int_equal(reports.items->column, 37);
    assert_non_null(strstr(reports.items->message,
                           "the images of the scene have more than 8388608"));
}

/* A loop reads the image with another gamma in each iteration. */
TEST(many)
{
    char text[300];
    field_keep(FILE_OF("P5\n8 1\n255\n" GREYS));
    snprintf(text, sizeof text,
             "#for (I, 1, 1000) sphere { 0, 1 pigment { image_map { \"%s\" "
             "gamma I } } } #end\n"
             "sphere { 0, 1 pigment { image_map { \"%s\" gamma 9 } } }",
             field_path, field_path);
    scene_free(read_scene(text));
    snprintf(text + strlen(text), sizeof text - strlen(text),
             " box { 0, 1 pigment { image_map { \"%s\" gamma .5 } } }", field_path);
    assert_error(text, &with_images, 2, 87 + strlen(field_path),
                 "more than 1000 images");
}
