/* test_picture.c - pictures of all formats are written, read and compared with the
 * frame, within the precision of their samples. A wrong transfer function, a lost note,
 * or an old file that a failure destroys fails here. */
#include "rt/picture/picture.h"
#include "base/file.h"
#include "tests/unit/temporary_folder.h"

#include <math.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { WIDTH = 37, HEIGHT = 23, PIXELS = WIDTH * HEIGHT };

static const struct picture_note notes[] = {
    { "c205:scene", "gear.pov" },
    { "c205:clocks", "123456" },
    { NULL, NULL },
};

/* Returns a frame with smooth colours, some above 1, and channels of many sizes. */
static struct frame sample_frame(void)
{
    struct frame frame;
    assert_true(frame_allocate(&frame, WIDTH, HEIGHT));
    for (size_t i = 0; i < PIXELS; i++) {
        double u = (double)(i % WIDTH) / (WIDTH - 1);
        double v = (double)(i / WIDTH) / (HEIGHT - 1);
        frame.channel[CHANNEL_RED][i] = 1.25 * u;
        frame.channel[CHANNEL_GREEN][i] = v;
        frame.channel[CHANNEL_BLUE][i] = .5 * u * v;
        frame.channel[CHANNEL_DEPTH][i] = 1000 * u + v;
        frame.channel[CHANNEL_NORMAL_X][i] = -u;
        frame.channel[CHANNEL_NORMAL_Y][i] = v - .5;
        frame.channel[CHANNEL_NORMAL_Z][i] = u * u;
        frame.channel[CHANNEL_ID][i] = (double)(100000 + i);
    }
    return frame;
}

struct round_trip {
    const char *name;
    bool half, clip;
    size_t channels;
    double relative, absolute; /* tolerances for colours */
};

/* An 8-bit sRGB step is at most .0091 in linear light, near white. JPEG may differ by
 * several steps. Half has 11 bits, float has 24 bits. */
static const struct round_trip round_trips[] = {
    { "a.png", false, true, 3, 0, .0046 },
    { "a.jpg", false, true, 3, 0, .05 },
    { "a.jpeg", true, true, 3, 0, .05 },
    { "half.exr", true, false, 8, 0x1p-11, 1e-7 },
    { "float.exr", false, false, 8, 0x1p-24, 0 },
    { "a.tif", false, false, 8, 0x1p-24, 0 },
    { "A.TIFF", true, false, 8, 0x1p-24, 0 },
};

static void compare(const struct round_trip *trip, const struct frame *frame,
                    const struct frame *back, size_t channel)
{
    bool color = channel <= CHANNEL_BLUE;
    for (size_t i = 0; i < PIXELS; i++) {
        double raw = frame->channel[channel][i];
        double value = color && trip->clip ? fmin(1, fmax(0, raw)) : raw;
        double kept = channel < trip->channels ? value : 0;
        double allowed = (color ? trip->relative : 0x1p-24) * fabs(kept)
                         + (color ? trip->absolute : 0);
        FAIL_IF(fabs(back->channel[channel][i] - kept) > allowed,
                "%s, channel %zu, pixel %zu: %g is %g", trip->name, channel, i, kept,
                back->channel[channel][i]);
    }
}

TEST(round_trips)
{
    SCOPED_VALUE(frame) frame = sample_frame();
    c205_error error = { "" };
    for (size_t i = 0; i < COUNT(round_trips); i++) {
        SCOPED_VALUE(frame) back;
        const struct round_trip *trip = &round_trips[i];
        const char *path = in_folder(trip->name);
        REQUIRE_OF(picture_write(path, &frame, notes, trip->half, &error)
                       && picture_read(path, &back, &error),
                   error);
        assert_int_equal(back.width, WIDTH);
        assert_int_equal(back.height, HEIGHT);
        for (size_t channel = 0; channel < FRAME_CHANNELS; channel++)
            compare(trip, &frame, &back, channel);
    }
    assert_int_equal(empty_folder(), COUNT(round_trips));
}

TEST(half_is_smaller)
{
    SCOPED_VALUE(frame) frame = sample_frame();
    c205_error error;
    struct stat half, whole;
    assert_true(picture_write(in_folder("h.exr"), &frame, NULL, true, &error));
    assert_int_equal(stat(in_folder("h.exr"), &half), 0);
    assert_true(picture_write(in_folder("f.exr"), &frame, NULL, false, &error));
    assert_int_equal(stat(in_folder("f.exr"), &whole), 0);
    assert_true(half.st_size < whole.st_size);
}

/* In sRGB, mid grey in linear light is 188 of 255, and values above 1 are 255. A
 * thousandth, which is on the linear part of the curve, is 3. */
TEST(bytes_are_srgb)
{
    SCOPED_VALUE(frame) frame, back;
    c205_error error;
    assert_true(frame_allocate(&frame, 5, 1));
    const double in[5] = { .5, 7, -3, NAN, .001 };
    const double out[5] = { pow((188 / 255. + .055) / 1.055, 2.4), 1, 0, 0,
                            3 / 255. / 12.92 };
    for (size_t i = 0; i < 5; i++)
        for (size_t channel = 0; channel <= CHANNEL_BLUE; channel++)
            frame.channel[channel][i] = in[i];
    assert_true(picture_write(in_folder("g.png"), &frame, NULL, false, &error));
    assert_true(picture_read(in_folder("g.png"), &back, &error));
    for (size_t i = 0; i < 5; i++)
        assert_true(fabs(back.channel[CHANNEL_GREEN][i] - out[i]) < 1e-6);
}

TEST(bytes_without_gamma)
{
    SCOPED_VALUE(frame) frame, back;
    c205_error error;
    assert_true(frame_allocate(&frame, 1, 1));
    frame.gamma_off = true;
    frame.channel[CHANNEL_RED][0] = .2;
    assert_true(picture_write(in_folder("o.png"), &frame, NULL, false, &error));
    assert_true(picture_read(in_folder("o.png"), &back, &error));
    assert_true(fabs(picture_srgb(back.channel[CHANNEL_RED][0]) - .2) < 1e-6);
}

static const char described[] = "c205:scene: gear.pov\nc205:clocks: 123456\n";

TEST(notes)
{
    static const struct {
        const char *file, *name, *text;
    } rows[] = {
        { "n.png", "c205:clocks", "123456" },
        { "n.png", "ImageDescription", described },
        { "n.png", "oiio:ColorSpace", "sRGB" },
        { "n.jpg", "ImageDescription", described },
        { "n.jpg", "oiio:ColorSpace", "sRGB" },
        { "n.exr", "c205:scene", "gear.pov" },
        { "n.exr", "ImageDescription", described },
        { "n.tif", "ImageDescription", described },
        { "n.tif", "c205:nothing", "" },
    };
    SCOPED_VALUE(frame) frame = sample_frame();
    c205_error error = { "" };
    for (size_t i = 0; i < COUNT(rows); i++) {
        const char *path = in_folder(rows[i].file);
        char text[256];
        REQUIRE_OF(picture_write(path, &frame, notes, false, &error)
                       && picture_read_note(path, rows[i].name, text, sizeof text,
                                            &error),
                   error);
        assert_string_equal(text, rows[i].text);
    }
}

/* A date is only written on request. An invalid date is ignored. */
TEST(date)
{
    static const struct {
        const char *epoch, *date;
    } cases[] = { { NULL, "" },
                  { "0", "1970:01:01 00:00:00" },
                  { "951786061", "2000:02:29 01:01:01" },
                  { "", "" },
                  { "1e9", "" },
                  { "now", "" } };
    static const char *const names[] = { "d.exr", "d.tif" };
    SCOPED_VALUE(frame) frame = sample_frame();
    c205_error error = { "" };
    for (size_t i = 0; i < 2 * (COUNT(cases)); i++) {
        const char *path = in_folder(names[i % 2]);
        char text[64];
        if (cases[i / 2].epoch)
            setenv("SOURCE_DATE_EPOCH", cases[i / 2].epoch, 1);
        else
            unsetenv("SOURCE_DATE_EPOCH");
        REQUIRE_OF(picture_write(path, &frame, notes, false, &error)
                       && picture_read_note(path, "DateTime", text, sizeof text,
                                            &error),
                   error);
        assert_string_equal(text, cases[i / 2].date);
    }
    unsetenv("SOURCE_DATE_EPOCH");
}

TEST(same_bytes_later)
{
    static const char *const names[] = { "t.png", "t.jpg", "t.exr", "t.tif" };
    char *bytes[4][2];
    size_t length[4][2];
    c205_error message;
    const struct timespec over_a_second = { 1, 100000000 };
    SCOPED_VALUE(frame) frame = sample_frame();
    c205_error error;
    for (size_t round = 0; round < 2; round++) {
        for (size_t i = 0; i < 4; i++) {
            const char *path = in_folder(names[i]);
            assert_true(picture_write(path, &frame, notes, true, &error));
            bytes[i][round] = NON_NULL(
                file_read(path, FILE_LARGEST, &length[i][round], &message));
        }
        if (round == 0)
            nanosleep(&over_a_second, NULL);
    }
    for (size_t i = 0; i < 4; i++) {
        assert_int_equal(length[i][0], length[i][1]);
        assert_memory_equal(bytes[i][0], bytes[i][1], length[i][0]);
        free(bytes[i][0]);
        free(bytes[i][1]);
    }
}

TEST(bad_paths)
{
    static const struct {
        const char *name, *message;
    } rows[] = {
        { "a.gif", "the name of a picture must end in" },
        { "png", "the name of a picture must end in" },
        { "x.png/a", "the name of a picture must end in" },
        { "none/a.png", "No such file" },
        { "plain/a.png", "Not a directory" },
        { "folder.png", "not a regular file" },
    };
    SCOPED_VALUE(frame) frame = sample_frame();
    write_file("plain", "");
    assert_int_equal(mkdir(in_folder("folder.png"), 0700), 0);
    for (size_t i = 0; i < COUNT(rows); i++) {
        const char *path = in_folder(rows[i].name);
        c205_error error = { "" };
        assert_false(picture_check_path(path, &error));
        assert_non_null(strstr(error.message, rows[i].message));
        assert_false(picture_write(path, &frame, notes, false, &error));
        assert_non_null(strstr(error.message, rows[i].message));
    }
    assert_int_equal(rmdir(in_folder("folder.png")), 0);
    empty_folder();
}

/* Root can write to any folder, so the test is skipped for root. */
TEST(unwritable_folder)
{
    c205_error error;
    if (geteuid() == 0)
        skip();
    assert_int_equal(chmod(temporary_folder, 0500), 0);
    assert_false(picture_check_path(in_folder("a.png"), &error));
    assert_non_null(strstr(error.message, "Permission denied"));
    assert_int_equal(chmod(temporary_folder, 0700), 0);
}

static void limit_file_size(rlim_t bytes)
{
    struct rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
}

/* The disk is full after some bytes. Only the old file remains. */
TEST(failure_keeps_the_old_file)
{
    static const char *const names[] = { "o.png", "o.jpg", "o.exr", "o.tif" };
    SCOPED_VALUE(frame) frame = sample_frame();
    empty_folder();
    signal(SIGXFSZ, SIG_IGN);
    for (size_t i = 0; i < 4; i++) {
        c205_error error = { "" };
        write_file(names[i], "old");
        const char *path = in_folder(names[i]);
        limit_file_size(200);
        bool written = picture_write(path, &frame, NULL, false, &error);
        limit_file_size(RLIM_INFINITY);
        FAIL_IF(written, "%s is said to be written", names[i]);
        assert_non_null(strstr(error.message, names[i]));
        FREED char *old = text_of_file(names[i]);
        assert_string_equal(old, "old");
        assert_int_equal(empty_folder(), 1);
    }
}

/* Pictures with more channels than colours can have an additional plane. */
TEST(layer)
{
    static const char *const paths[] = { "l.exr", "l.tif", "l.png" };
    for (size_t i = 0; i < 3; i++) {
        SCOPED_VALUE(frame) frame = sample_frame(), back;
        c205_error error = { "" };
        double value[WIDTH * HEIGHT];
        for (size_t k = 0; k < WIDTH * HEIGHT; k++)
            value[k] = (double)k / 8 - 3;
        frame.layer = "flow";
        frame.value = value;
        const char *path = in_folder(paths[i]);
        assert_true(picture_write(path, &frame, NULL, true, &error));
        assert_true(picture_read_layer(path, "flow", &back, &error));
        for (size_t k = 0; k < WIDTH * HEIGHT; k++)
            assert_true(back.value[k] == (i < 2 ? value[k] : 0));
        free(back.value);
        frame_free(&back);
        assert_true(picture_read_layer(path, "factor", &back, &error));
        assert_true(i == 1 || back.value[1] == 0); /* TIFF has no names */
        free(back.value);
        assert_int_equal(remove(path), 0);
    }
}

/* A picture with missing rows, or a picture that is abandoned, is not written. */
TEST(rows_missing)
{
    SCOPED_VALUE(frame) frame = sample_frame();
    for (int given_up = 0; given_up < 2; given_up++) {
        c205_error error = { "" };
        struct picture *picture = NON_NULL(picture_begin(in_folder("p.png"), WIDTH,
                                                         HEIGHT + 1 - (size_t)given_up,
                                                         notes, false, NULL, &error));
        assert_true(picture_rows(picture, &frame, &error));
        assert_false(picture_rows(picture, &frame, &error));
        assert_false(picture_end(picture, !given_up, &error));
        assert_non_null(strstr(error.message, given_up ? "outside" : "are missing"));
        assert_int_equal(empty_folder(), 0);
    }
}

TEST(unreadable)
{
    struct frame frame;
    c205_error error = { "" };
    write_file("bad.exr", "not a picture");
    assert_false(picture_read(in_folder("bad.exr"), &frame, &error));
    assert_non_null(strstr(error.message, "bad.exr"));
    assert_false(picture_read(in_folder("none.png"), &frame, &error));
    assert_int_equal(empty_folder(), 1);
}

TEST(frame_sizes)
{
    SCOPED_VALUE(frame) frame;
    assert_false(frame_allocate(&frame, 0, 3));
    assert_false(frame_allocate(&frame, 3, 0));
    assert_false(frame_allocate(&frame, SIZE_MAX / 2, SIZE_MAX / 2));
}
