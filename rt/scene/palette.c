/* palette.c - replaces the colours of the colour table in an image file by their
 * indices.
 *
 * Sources: the Portable Network Graphics specification (W3C, second edition); GIF89a
 * (CompuServe); Truevision TGA, version 2.0; Microsoft's description of
 * BITMAPINFOHEADER and BITMAPCOREHEADER.
 */
#include "rt/scene/palette.h"

#include <string.h>

/* Offsets and lengths in the files, in bytes. */
enum {
    PNG_FIRST = 8, /* the first chunk: length, name, data, checksum */
    PNG_HEAD = 8,
    PNG_TAIL = 4, /* the checksum of a chunk */
    PNG_COLOR_TYPE = 25,
    PNG_INDEXED = 3,
    GIF_FLAGS = 10,
    GIF_TABLE = 13,
    GIF_IMAGE = 10, /* before the colour table of an image */
    GIF_HAS_TABLE = 0x80,
    BMP_HEADER = 14,
    BMP_BITS = 28,
    BMP_CORE = 12, /* size of BITMAPCOREHEADER, whose fields are shorter */
    BMP_CORE_BITS = 24,
    TGA_TABLE = 18, /* offset, if there is no identification field */
};

static unsigned byte_at(const char *bytes, size_t i)
{
    return (unsigned char)bytes[i];
}

/* Replaces each of `count` colours by its index: sets the first three of its `size`
 * bytes. Returns false if the table extends beyond the file, or has more than 256
 * colours. */
static bool paint(char *bytes, size_t length, size_t at, size_t count, size_t size)
{
    if (at > length || count > (length - at) / size || count > 256)
        return false;
    for (size_t i = 0; i < count; i++)
        memset(bytes + at + i * size, (int)i, 3);
    return true;
}

/* ---- PNG ----------------------------------------------------------------- */

static size_t long_at(const char *bytes, size_t i)
{
    return (size_t)byte_at(bytes, i) << 24 | byte_at(bytes, i + 1) << 16
           | byte_at(bytes, i + 2) << 8 | byte_at(bytes, i + 3);
}

/* Returns the CRC of a chunk's name and data (annex D). */
static uint32_t check_sum(const char *bytes, size_t count)
{
    uint32_t sum = UINT32_MAX;
    for (size_t i = 0; i < count; i++) {
        sum ^= byte_at(bytes, i);
        for (int bit = 0; bit < 8; bit++)
            sum = sum & 1 ? 0xedb88320 ^ sum >> 1 : sum >> 1;
    }
    return ~sum;
}

static bool paint_png(char *bytes, size_t length)
{
    size_t at = PNG_FIRST, size, rest;
    uint32_t sum;
    for (;; at += PNG_HEAD + size + PNG_TAIL) {
        rest = length - at;
        if (rest < PNG_HEAD + PNG_TAIL)
            return false;
        size = long_at(bytes, at);
        if (size > rest - PNG_HEAD - PNG_TAIL)
            return false;
        if (!memcmp(bytes + at + 4, "PLTE", 4))
            break;
    }
    if (!paint(bytes, length, at + PNG_HEAD, size / 3, 3))
        return false;
    sum = check_sum(bytes + at + 4, size + 4);
    for (size_t i = 0; i < PNG_TAIL; i++)
        bytes[at + PNG_HEAD + size + i] = (char)(sum >> (24 - 8 * i));
    return true;
}

/* ---- GIF ----------------------------------------------------------------- */

/* Returns the offset after a chain of blocks. Each block begins with its size. The last
 * block has size 0. */
static size_t blocks_end(const char *bytes, size_t length, size_t at)
{
    while (at < length && bytes[at])
        at += 1 + byte_at(bytes, at);
    return at + 1;
}

static bool paint_table(char *bytes, size_t length, size_t at, unsigned flags,
                        size_t *end)
{
    size_t count = flags & GIF_HAS_TABLE ? (size_t)2 << (flags & 7) : 0;
    *end = at + 3 * count;
    return paint(bytes, length, at, count, 3);
}

/* Replaces the global colour table and the table of the first image. */
static bool paint_gif(char *bytes, size_t length)
{
    size_t at, ignored;
    if (length < GIF_TABLE
        || !paint_table(bytes, length, GIF_TABLE, byte_at(bytes, GIF_FLAGS), &at))
        return false;
    while (at + 1 < length && bytes[at] == '!')
        at = blocks_end(bytes, length, at + 2);
    return at + GIF_IMAGE <= length && bytes[at] == ','
           && paint_table(bytes, length, at + GIF_IMAGE,
                          byte_at(bytes, at + GIF_IMAGE - 1), &ignored);
}

/* ---- BMP, TGA ------------------------------------------------------------ */

static bool is_core(const char *bytes)
{
    return byte_at(bytes, BMP_HEADER) == BMP_CORE;
}

static bool bmp_has_table(const char *bytes, size_t length)
{
    return length >= BMP_BITS + 2
           && byte_at(bytes, is_core(bytes) ? BMP_CORE_BITS : BMP_BITS) <= 8;
}

/* Replaces the colours of the table, which ends at the offset of the pixels. */
static bool paint_bmp(char *bytes, size_t length)
{
    size_t at, end, size;
    if (length < BMP_BITS + 2)
        return false;
    at = BMP_HEADER + byte_at(bytes, BMP_HEADER);
    end = byte_at(bytes, 10) | byte_at(bytes, 11) << 8;
    size = is_core(bytes) ? 3 : 4;
    return end >= at && paint(bytes, length, at, (end - at) / size, size);
}

static bool paint_tga(char *bytes, size_t length)
{
    size_t bits = byte_at(bytes, 7);
    return (bits == 24 || bits == 32)
           && paint(bytes, length, TGA_TABLE + byte_at(bytes, 0),
                    byte_at(bytes, 5) | byte_at(bytes, 6) << 8, bits / 8);
}

/* ---- All formats --------------------------------------------------------- */

/* Returns true if the file has a colour table. In TGA the types 1 and 9 (run-length
 * encoded) have one. */
bool palette_is_used(enum raster_kind kind, const char *bytes, size_t length)
{
    switch (kind) {
    case RASTER_GIF: return true;
    case RASTER_PNG:
        return length > PNG_COLOR_TYPE && bytes[PNG_COLOR_TYPE] == PNG_INDEXED;
    case RASTER_BMP: return bmp_has_table(bytes, length);
    case RASTER_TGA: return length > TGA_TABLE && (bytes[2] & 7) == 1;
    default: return false;
    }
}

bool palette_to_numbers(enum raster_kind kind, char *bytes, size_t length)
{
    switch (kind) {
    case RASTER_GIF: return paint_gif(bytes, length);
    case RASTER_PNG: return paint_png(bytes, length);
    case RASTER_BMP: return paint_bmp(bytes, length);
    case RASTER_TGA: return paint_tga(bytes, length);
    default: return false;
    }
}
