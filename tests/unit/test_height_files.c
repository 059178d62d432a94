/* test_height_files.c - the heights that a height_field reads from files of all kinds
 * are compared with heights that POV-Ray 3.7 printed for the same bytes. A wrong byte
 * order, palette or rounding, or an invalid file that is accepted, fails here. */
#include "tests/unit/field_reading.h"

/* ---- Kinds of files ------------------------------------------------------ */

struct known_file {
    const char *word;
    const char *bytes;
    size_t count;
    int heights[6]; /* heights of an image of 3 x 2 pixels: the upper row, then the
                     * lower row */
};
#define FILE_OF(word, bytes) word, bytes, sizeof bytes - 1

/* A PNG file of 3 x 2 pixels: the rest of its header, and all but its last chunk. */
#define PNG_OF(bytes) \
    FILE_OF("png", "\x89PNG\x0d\x0a\x1a\x0a\x00\x00\x00\x0dIHDR" \
                   "\x00\x00\x00\x03\x00\x00\x00\x02" bytes \
                   "\x00\x00\x00\x00IEND\xae\x42`\x82")

/* The grey images have the values 0, 50 .. 250, the coloured ones COLORS. */
#define GREYS "\x00\x32\x64\x96\xc8\xfa"
#define COLORS \
    "\xff\x00\x00\x00\xff\x00\x00\x00\xff\x0a\x14\x1e\xc8\x64\x32\xff\xff\xff"
#define BGRS "\x00\x00\xff\x00\xff\x00\xff\x00\x00\x1e\x14\x0a\x32\x64\xc8\xff\xff\xff"

static const struct known_file known_files[] = {
    { FILE_OF("pgm", "P5\n3 2\n255\n" GREYS),
      { 0, 12850, 25700, 38550, 51400, 64250 } },
    { FILE_OF("pgm", "P2\n3 2\n100\n0 10 33 50 77 100\n"),
      { 0, 6553, 21626, 32767, 50461, 65535 } },
    { FILE_OF("pgm", "P2\n3 2\n1000\n0 10 333 500 777 1000"),
      { 0, 655, 21823, 32767, 50920, 65535 } },
    { FILE_OF("pgm", "P5 3 2 65535\n\0\0\x27\x10\x4e\x20\x75\x30\x9c\x40"
                     "\xc3\x50"),
      { 0, 10000, 20000, 30000, 40000, 50000 } },
    { FILE_OF("ppm", "P6\n3 2\n255\n" COLORS), { 65280, 255, 0, 2580, 51300, 65535 } },
    { FILE_OF("ppm", "P3\n3 2\n100\n0 10 33 50 77 100 100 0 0 0 100 0 0 0 100 "
                     "99 98 97\n"),
      { 25, 32836, 65280, 255, 0, 64877 } },
    { FILE_OF("ppm", "P3\n3 2\n65535\n65535 0 0 0 65535 0 0 0 65535 2570 5140 "
                     "7710 51400 25700 12850 65535 65535 65535"),
      { 19463, 38600, 7470, 4669, 31868, 65534 } },
    { FILE_OF("tga", "\0\0\x02\0\0\0\0\0\0\0\0\0\x03\0\x02\0\x18\x20" BGRS),
      { 65280, 255, 0, 2580, 51300, 65535 } },
    { FILE_OF("tga", "\0\0\x02\0\0\0\0\0\0\0\0\0\x03\0\x02\0\x18\0" BGRS),
      { 2580, 51300, 65535, 65280, 255, 0 } },
    { FILE_OF("tga", "\0\0\x02\0\0\0\0\0\0\0\0\0\x03\0\x02\0\x10\x20\0\x7c"
                     "\xe0\x03\x1f\0\x43\x04\x86\x65\xff\x7f"),
      { 63488, 248, 0, 2064, 51296, 63736 } },
    { FILE_OF("tga", "\0\0\x03\0\0\0\0\0\0\0\0\0\x03\0\x02\0\x08\x20" GREYS),
      { 0, 12850, 25700, 38550, 51400, 64250 } },
    { FILE_OF("tga", "\0\x01\x01\0\0\x06\0\x18\0\0\0\0\x03\0\x02\0\x08\x20" BGRS
                     "\0\x01\x02\x03\x04\x05"),
      { 0, 256, 512, 768, 1024, 1280 } },
    { FILE_OF("gif", "GIF89a\x03\0\x02\0\xf2\0\0" COLORS "\x01\x02\x03\x04\x05"
                     "\x06,\0\0\0\0\x03\0\x02\0\0\x03\x05\x08\x21\x38\x54\x09"
                     "\0;"),
      { 0, 256, 512, 768, 1024, 1280 } },
    { PNG_OF("\x08\x00\x00\x00\x00\xb8\x1f\x39\xc6\x00\x00\x00\x13IDATx\x01\x01"
             "\x08\x00\xf7\xff\x00\x00\x32\x64\x00\x96\xc8\xfa\x07t\x02\xef\x03"
             "\x12^\x0b"),
      { 0, 12593, 25443, 38293, 51143, 64250 } },
    { PNG_OF("\x10\x00\x00\x00\x00\xe8\x8f\xe5\x85\x00\x00\x00\x19IDATx\x01\x01"
             "\x0e\x00\xf1\xff\x00\x00\x00'\x10N \x00u0\x9c@\xc3P\x0e\xcd\x03:"
             "\x8e\xf5Y\xa5"),
      { 0, 10000, 20000, 30000, 40000, 50000 } },
    { PNG_OF("\x08\x02\x00\x00\x00\x12\x16\xf1M\x00\x00\x00\x1fIDATx\x01\x01\x14"
             "\x00\xeb\xff\x00\xff\x00\x00\x00\xff\x00\x00\x00\xff\x00\x0a\x14"
             "\x1e\xc8\x64\x32\xff\xff\xff<\x19\x07\x95\x1b\xa7\xeb\xb9"),
      { 65280, 255, 0, 2580, 51300, 65535 } },
    { PNG_OF("\x08\x06\x00\x00\x00\x9dtf\x1a\x00\x00\x00%IDATx\x01\x01\x1a\x00"
             "\xe5\xff\x00\xff\x00\x00\x80\x00\xff\x00\x80\x00\x00\xff\x80\x00"
             "\x0a\x14\x1e\xff\xc8\x64\x32\xff\xff\xff\xff\xff{n\x0c\x12\x97M\xe1\xd7"),
      { 65280, 255, 0, 2580, 51300, 65535 } },
    { PNG_OF("\x08\x03\x00\x00\x00\xaa\xaa\x96(\x00\x00\x00\x12PLTE\xff\x00\x00"
             "\x00\xff\x00\x00\x00\xff\x0a\x14\x1e\xc8\x64\x32\xff\xff\xff>3\xf9"
             "\xf6\x00\x00\x00\x13IDATx\x01\x01\x08\x00\xf7\xff\x00\x00\x01\x02"
             "\x00\x03\x04\x05\x00.\x00\x10]\xd9\xc1\x16"),
      { 0, 256, 512, 768, 1024, 1280 } },
    { PNG_OF("\x04\x03\x00\x00\x00oZ{)\x00\x00\x00\x12PLTE\xff\x00\x00\x00\xff"
             "\x00\x00\x00\xff\x0a\x14\x1e\xc8\x64\x32\xff\xff\xff>3\xf9\xf6\x00"
             "\x00\x00\x11IDATx\x01\x01\x06\x00\xf9\xff\x00\x01 \x00\x34P\x01"
             "\x43\x00\xa6\x63~\xb7\x9a"),
      { 0, 256, 512, 768, 1024, 1280 } },
    /* The palette contains each colour twice; the second belongs to the image. */
    { FILE_OF("gif", "GIF89a\x03\0\x02\0\x72\0\0!\xfe\x02yo\0,\0\0\0\0\x03\0"
                     "\x02\0\x82"
                     "aaaaaabbbbbbccccccdddddd\x03\x05\x08\x21\x38\x54\x09\0;"),
      { 0, 256, 512, 768, 1024, 1280 } },
    { FILE_OF("bmp", "BM\x4e\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x03\0\0\0\x02\0\0"
                     "\0\x01\0\x18\0\0\0\0\0\x18\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"
                     "\0\0\0\0\x1e\x14\x0a\x32\x64\xc8\xff\xff\xff\0\0\0"
                     "\0\0\xff\0\xff\0\xff\0\0\0\0\0"),
      { 65280, 255, 0, 2580, 51300, 65535 } },
    /* A header of 12 bytes, and colours of three bytes. */
    { FILE_OF("bmp", "BM\x52\0\0\0\0\0\0\0\x4a\0\0\0\x0c\0\0\0\x03\0\x02\0\x01\0\x04\0"
                     "aaaaaabbbbbbccccccddddddeeeeeeffffffgggggghhhhhh"
                     "\x34\x50\0\0\x01\x20\0\0"),
      { 0, 256, 512, 768, 1024, 1280 } },
};

TEST(kinds)
{
    for (size_t k = 0; k < COUNT(known_files); k++) {
        const struct known_file *file = &known_files[k];
        field_keep(file->bytes, file->count);
        SCOPED(scene) *scene = field_expect(file->word, "");
        for (int i = 0; i < 6; i++) {
            double x = i % 3 / 2., z = i < 3;
            double height = -1, x_in = x + (x < .5 ? 1 : -1) * 1e-9;
            FAIL_IF(!field_meet(triangles_of(scene), x_in, z + (i < 3 ? -1 : 1) * 1e-9,
                                &height),
                    "%s %d: nothing is met", file->word, i);
            FAIL_IF(fabs(height * 65536 - file->heights[i]) > .01,
                    "%s %d: %.3f, not %d", file->word, i, height * 65536,
                    file->heights[i]);
        }
    }
}

/* A truncated file causes one error or is accepted. PNG is skipped: for an invalid file
 * the library leaks memory, which a leak checker would report. */
TEST(broken)
{
    for (size_t i = 0; i < COUNT(known_files); i++)
        for (size_t k = 0; k < 8 && strcmp(known_files[i].word, "png"); k++) {
            const struct known_file *file = &known_files[i];
            SCOPED_VALUE(diagnostics) reports = { 0 };
            field_keep(file->bytes, file->count * k / 8);
            SCOPED(scene) *scene = field_read(file->word, "", &with_images, &reports);
            assert_true(scene || reports.errors == 1);
        }
}

/* ---- Invalid input ------------------------------------------------------- */

static void expect_file_fault(const char *word, const char *bytes, const char *message)
{
    field_keep(bytes, strlen(bytes));
    field_expect_fault(word, "", 17 + strlen(word), message);
}

TEST(faulty_files)
{
    expect_file_fault("pgm", "", "empty");
    expect_file_fault("", "P2 3 1 255 1 2 3", "two rows of two heights");
    expect_file_fault("", "P2 1 3 255 1 2 3", "two rows of two heights");
    expect_file_fault("", "P2 2 2 255 1 2 3", "the file ends after 3 of 4 samples");
    expect_file_fault("", "P5 2 2 255 123", "the file ends after 3 of 4 samples");
    expect_file_fault("", "P2 2 2 255 1 2 3 256", "a sample is 256");
    expect_file_fault("", "P2 2 2 65536 1 2 3 4", "between 1 and 65535");
    expect_file_fault("", "P2 2 2 0 0 0 0 0", "between 1 and 65535");
    expect_file_fault("", "P2 0 2 255", "no pixels");
    expect_file_fault("", "P2 x", "in the header is not a valid number");
    expect_file_fault("", "P2 9999 9999 255", "more than 8388608 pixels");
    expect_file_fault("pgm", "P3 2 2 1 1 1 1", "not an image of the kind 'pgm'");
    expect_file_fault("png", "what is this", "not an image of the kind 'png'");
    expect_file_fault("tga", "what is this", "cannot read the image");
    expect_file_fault("gif", "GIF89a", "colour table of the image is invalid");
}

TEST(large_file)
{
    enum { SIDE = 1500 };
    FREED char *bytes = NON_NULL(calloc(1, SIDE * SIDE + 100));
    int head = sprintf(bytes, "P5 %d %d 255\n", SIDE, SIDE);
    field_keep(bytes, (size_t)head + SIDE * SIDE);
    field_expect_fault("pgm", "", 20, "more than 4000000 triangles");
}

/* Only PGM can be read without the library adapter. */
TEST(no_adapter)
{
    for (size_t i = 0; i < COUNT(known_files); i++) {
        const struct known_file *file = &known_files[i];
        SCOPED_VALUE(diagnostics) reports = { 0 };
        bool own = *file->word == 'p' && file->word[1] != 'n';
        field_keep(file->bytes, file->count);
        SCOPED(scene) *scene = field_read(file->word, "", &reading_options, &reports);
        assert_int_equal(!scene, !own);
        assert_int_equal(reports.errors, !own);
        if (!own)
            assert_non_null(strstr(reports.items->message, "are supported here"));
    }
}
