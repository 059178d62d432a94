/* png.c - writes PNG files with stored (uncompressed) blocks, without a library. */
#include "web/tracer/platform/png.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "vm/error.h"

enum {
    COLORS = 3,
    MAX_BLOCK = 65535, /* bytes of a stored block (RFC 1951, 3.2.4) */
    BLOCK_HEAD = 5,
    ADLER_BASE = 65521
};

/* A picture that is being written. The caller checks the FILE for write errors. */
struct png {
    FILE *file;
    size_t width;
    uint32_t adler[2]; /* checksum of all stored bytes (RFC 1950, 8.2) */
};

/* ---- Chunks -------------------------------------------------------------- */

static void put_number(unsigned char bytes[4], uint32_t number)
{
    for (int i = 0; i < 4; i++)
        bytes[i] = (unsigned char)(number >> (24 - 8 * i));
}

/* Returns the checksum of ISO/IEC 15948, annex D, computed bit by bit. */
static uint32_t crc(uint32_t sum, const unsigned char *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        sum ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            sum = sum & 1 ? sum >> 1 ^ UINT32_C(0xEDB88320) : sum >> 1;
    }
    return sum;
}

static void put_chunk(FILE *file, const char *type, const unsigned char *bytes,
                      size_t count)
{
    const unsigned char *name = (const unsigned char *)type;
    unsigned char number[4];
    put_number(number, (uint32_t)count);
    fwrite(number, 1, 4, file);
    fwrite(name, 1, 4, file);
    fwrite(bytes, 1, count, file);
    put_number(number, ~crc(crc(UINT32_MAX, name, 4), bytes, count));
    fwrite(number, 1, 4, file);
}

/* ---- Stored blocks ------------------------------------------------------- */

static void add_up(uint32_t adler[2], const unsigned char *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        adler[0] = (adler[0] + bytes[i]) % ADLER_BASE;
        adler[1] = (adler[1] + adler[0]) % ADLER_BASE;
    }
}

static unsigned char *put_block(unsigned char *to, const unsigned char *bytes,
                                size_t count, bool last)
{
    const unsigned char head[BLOCK_HEAD] = { last, (unsigned char)count,
                                             (unsigned char)(count >> 8),
                                             (unsigned char)~count,
                                             (unsigned char)(~count >> 8) };
    memcpy(to, head, BLOCK_HEAD);
    if (count > 0)
        memcpy(to + BLOCK_HEAD, bytes, count);
    return to + BLOCK_HEAD + count;
}

/* Writes a chunk of stored blocks. Returns false if memory is exhausted. */
static bool store(struct png *png, const unsigned char *bytes, size_t count)
{
    size_t blocks = count / MAX_BLOCK + 1;
    unsigned char *stored = malloc(count + blocks * BLOCK_HEAD), *end = stored;
    if (!stored)
        return false;
    add_up(png->adler, bytes, count);
    while (count > 0) {
        size_t some = count < MAX_BLOCK ? count : MAX_BLOCK;
        end = put_block(end, bytes, some, false);
        bytes += some;
        count -= some;
    }
    put_chunk(png->file, "IDAT", stored, (size_t)(end - stored));
    free(stored);
    return true;
}

/* ---- A picture ----------------------------------------------------------- */

static void put_head(FILE *file, const struct picture_image *image)
{
    static const unsigned char signature[8] = { 0x89, 'P',  'N',  'G',
                                                '\r', '\n', 0x1A, '\n' };
    unsigned char head[13] = { [8] = 8 /* bits */, [9] = 2 /* RGB */ };
    put_number(head, (uint32_t)image->width);
    put_number(head + 4, (uint32_t)image->height);
    fwrite(signature, 1, sizeof signature, file);
    put_chunk(file, "IHDR", head, sizeof head);
    put_chunk(file, "sRGB", (const unsigned char *)"", 1);
}

/* Writes a tEXt chunk: a name of up to 79 characters, a zero byte, and the text. */
static void put_note(FILE *file, const struct picture_note *note)
{
    unsigned char bytes[512];
    int length = snprintf((char *)bytes, sizeof bytes, "%.79s%c%.400s", note->name,
                          '\0', note->text);
    put_chunk(file, "tEXt", bytes, (size_t)length);
}

static void *begin_png(const char *path, const struct picture_image *image,
                       const struct picture_note *notes, FILE *file, c205_error *error)
{
    static const unsigned char zlib[2] = { 0x78, 0x01 }; /* RFC 1950, 2.2 */
    const char *ending = strrchr(path, '.');
    struct png *png;
    error_set(error, "in the page, the name of a picture must end in .png");
    if (!ending || strcasecmp(ending, ".png") != 0)
        return NULL;
    error_set(error, "out of memory");
    png = malloc(sizeof *png);
    if (!png)
        return NULL;
    *png = (struct png){ file, image->width, { 1, 0 } };
    put_head(file, image);
    for (; notes && notes->name; notes++)
        put_note(file, notes);
    put_chunk(file, "IDAT", zlib, sizeof zlib);
    return png;
}

unsigned char png_byte(float sample)
{
    return (unsigned char)(sample * 255 + .5F);
}

static bool rows(void *picture, size_t first, size_t last, const float *samples,
                 c205_error *error)
{
    struct png *png = picture;
    size_t row = png->width * COLORS, count = (last - first) * (1 + row);
    unsigned char *bytes = malloc(count), *to = bytes;
    bool good;
    if (!bytes)
        return error_set(error, "out of memory");
    for (size_t y = first; y < last; y++) {
        *to++ = 0; /* no filter */
        for (size_t i = 0; i < row; i++)
            *to++ = png_byte(*samples++);
    }
    good = store(png, bytes, count) || error_set(error, "out of memory");
    free(bytes);
    return good;
}

static bool end_png(void *picture, bool whole, c205_error *error)
{
    struct png *png = picture;
    unsigned char tail[BLOCK_HEAD + 4];
    (void)error;
    if (whole) {
        put_number(put_block(tail, NULL, 0, true), png->adler[1] << 16 | png->adler[0]);
        put_chunk(png->file, "IDAT", tail, sizeof tail);
        put_chunk(png->file, "IEND", NULL, 0);
    }
    free(png);
    return true;
}

/* ---- Reading is not supported -------------------------------------------- */

static const char no_reader[] =
    "pictures cannot be read in the page: OpenImageIO is not available";

static bool read(const char *path, struct picture_image *image, c205_error *error)
{
    (void)path, (void)image;
    return error_set(error, no_reader);
}

static bool read_note(const char *path, const char *name, char *text, size_t size,
                      c205_error *error)
{
    (void)path, (void)name, (void)text, (void)size;
    return error_set(error, no_reader);
}

static bool read_raster(const char *format, const char *bytes, size_t length,
                        struct raster *raster, c205_error *error)
{
    (void)format, (void)bytes, (void)length, (void)raster;
    return error_set(error, "%s", no_reader);
}

const struct picture_adapter png_adapter = {
    .begin = begin_png,
    .rows = rows,
    .end = end_png,
    .read = read,
    .read_note = read_note,
    .read_raster = read_raster,
};
