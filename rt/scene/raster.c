/* raster.c - detects the kind of an image file, and reads PGM and PPM.
 *
 * Source: the manual pages pgm(5) and ppm(5) of Netpbm.
 */
#include "rt/scene/raster.h"

#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "base/plural.h"

/* ---- Kinds --------------------------------------------------------------- */

static const struct raster_mark {
    enum raster_kind kind;
    const char *bytes;
} marks[] = {
    { RASTER_BMP, "BM" },  { RASTER_GIF, "GIF8" }, { RASTER_JPEG, "\xff\xd8\xff" },
    { RASTER_PGM, "P2" },  { RASTER_PGM, "P5" },   { RASTER_PNG, "\x89PNG\r\n\x1a\n" },
    { RASTER_PPM, "P3" },  { RASTER_PPM, "P6" },   { RASTER_TIFF, "II*" },
    { RASTER_TIFF, "MM" },
};

/* The names of the formats in OpenImageIO. */
static const char *const formats[RASTER_KINDS] = {
    [RASTER_BMP] = "bmp", [RASTER_GIF] = "gif",   [RASTER_JPEG] = "jpeg",
    [RASTER_PNG] = "png", [RASTER_TGA] = "targa", [RASTER_TIFF] = "tiff",
};

enum raster_kind raster_kind_of(const char *bytes, size_t length)
{
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++) {
        size_t size = strlen(marks[i].bytes);
        if (length >= size && !memcmp(bytes, marks[i].bytes, size))
            return marks[i].kind;
    }
    return RASTER_TGA;
}

/* ---- Netpbm -------------------------------------------------------------- */

/* A cursor in a Netpbm file. */
struct netpbm {
    const unsigned char *next, *end;
    bool plain; /* samples are decimal text */
    bool wide;  /* a sample has two bytes, most significant byte first */
};

static bool is_space(int byte)
{
    return byte == ' ' || (byte >= '\t' && byte <= '\r');
}

/* Skips blanks and comments. A comment extends from # to the end of the line. */
static void pass_spaces(struct netpbm *file)
{
    bool comment = false;
    for (; file->next < file->end; file->next++) {
        if (*file->next == '#')
            comment = true;
        else if (!comment && !is_space(*file->next))
            return;
        if (*file->next == '\n' || *file->next == '\r')
            comment = false;
    }
}

/* Reads a decimal number. Returns false if there is none, or if it is above
 * RASTER_PIXELS. */
static bool take_number(struct netpbm *file, uint32_t *number)
{
    const unsigned char *first;
    pass_spaces(file);
    first = file->next;
    for (*number = 0; file->next < file->end && *file->next >= '0' && *file->next <= '9'
                      && *number <= RASTER_PIXELS;
         file->next++)
        *number = 10 * *number + (uint32_t)(*file->next - '0');
    return file->next > first && *number <= RASTER_PIXELS;
}

static bool take_sample(struct netpbm *file, uint32_t *sample)
{
    if (file->plain)
        return take_number(file, sample);
    if (file->end - file->next < 1 + file->wide)
        return false;
    *sample = *file->next++;
    if (file->wide)
        *sample = *sample << 8 | *file->next++;
    return true;
}

static bool take_samples(struct netpbm *file, struct raster *raster, c205_error *error)
{
    size_t count = raster->width * raster->height * raster->channels;
    for (size_t i = 0; i < count; i++) {
        uint32_t sample;
        if (!take_sample(file, &sample))
            return error_set(error, "the file ends after %zu of %zu sample%s", i, count,
                             plural(count));
        if (sample > raster->most)
            return error_set(error,
                             "a sample is %lu, above the maximum of %lu in the header",
                             (unsigned long)sample, (unsigned long)raster->most);
        raster->samples[i] = (uint16_t)sample;
    }
    return true;
}

/* Reads width, height and greatest sample, which follow the two letters of the kind. A
 * single blank ends the header. */
static bool take_header(struct netpbm *file, struct raster *raster, c205_error *error)
{
    uint32_t width, height;
    if (!take_number(file, &width) || !take_number(file, &height)
        || !take_number(file, &raster->most))
        return error_set(error, "the width, height or maximum in the header is not "
                                "a valid number");
    if (raster->most == 0 || raster->most > UINT16_MAX)
        return error_set(error, "the maximum in the header must be between 1 and %d",
                         UINT16_MAX);
    if (width == 0 || height == 0)
        return error_set(error, "the image has no pixels");
    if (width > RASTER_PIXELS / height)
        return error_set(error, "the image has more than %d pixels", RASTER_PIXELS);
    file->wide = raster->most > UINT8_MAX;
    file->next += file->next < file->end;
    raster->width = width;
    raster->height = height;
    return true;
}

static bool read_netpbm(const char *bytes, size_t length, struct raster *raster,
                        c205_error *error)
{
    const unsigned char *first = (const unsigned char *)bytes;
    struct netpbm file = { .next = first + 2,
                           .end = first + length,
                           .plain = bytes[1] < '4' };
    if (!take_header(&file, raster, error))
        return false;
    raster->samples = malloc(raster->width * raster->height * raster->channels
                             * sizeof *raster->samples);
    if (!raster->samples)
        return error_set(error, "there is not enough memory");
    if (take_samples(&file, raster, error))
        return true;
    free(raster->samples);
    raster->samples = NULL;
    return false;
}

bool raster_read(enum raster_kind kind, const char *bytes, size_t length,
                 raster_reader *reads, struct raster *raster, c205_error *error)
{
    memset(raster, 0, sizeof *raster);
    if (kind == RASTER_PGM || kind == RASTER_PPM) {
        raster->channels = kind == RASTER_PGM ? 1 : 3;
        return read_netpbm(bytes, length, raster, error);
    }
    return reads ? reads(formats[kind], bytes, length, raster, error)
                 : error_set(error, "only PGM and PPM images are supported here");
}
