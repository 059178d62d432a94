/* heights.c - reads heights from the pixels of an image, or from a function.
 *
 * A height is an integer from 0 to 65535. The rules of POV-Ray 3.7 were measured:
 *
 *     grey                  65535 f, where f is the sample as a fraction from 0 to 1
 *     grey, 8-bit PNG       65535 (.297 f + .589 f + .114 f), in 32-bit floats
 *     colours, 8 bits       256 red + green
 *     colours, 16 bits      .297 red + .589 green + .114 blue, times 65535
 *     indexed colours       256 times the index
 *
 * Results are truncated to integers. TIFF is read as 8 bits.
 */
#include "rt/scene/language/heights.h"

#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/formula.h"
#include "rt/scene/language/image_file.h"
#include "rt/scene/palette.h"
#include "rt/scene/transfer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* COARSE selects the 5 bits of a byte that a TGA file with 16 bits per pixel uses.
 * TGA_BITS is the file offset of the number of bits per pixel. */
enum { COARSE = 0xf8, TGA_BITS = 16 };

#define MAX_FUNCTION 32000. /* limit of integers in POV-Ray */

static bool allocate(struct reader *reader, struct heights *heights, size_t columns,
                     size_t rows)
{
    heights->columns = columns;
    heights->rows = rows;
    heights->list = malloc(columns * rows * sizeof *heights->list);
    return (heights->list || reader_no_memory(reader))
           && reader_spend(reader, columns * rows);
}

double height_at(const struct heights *heights, size_t x, size_t z)
{
    return heights->list[z * heights->columns + x];
}

/* Checks the size of a height field. A field has at least one cell, and two triangles
 * per cell. */
static bool check_size(struct reader *reader, const struct scene_token *at,
                       double columns, double rows)
{
    if (columns < 2 || rows < 2)
        return reader_fault(reader, at,
                            "a height_field must have at least two rows of two "
                            "heights");
    return 2 * (columns - 1) * (rows - 1) <= MAX_TRIANGLES
           || reader_fault(reader, at, "more than %d triangles in one height_field",
                           MAX_TRIANGLES);
}

/* ---- Pixels -------------------------------------------------------------- */

static uint32_t brightness(const float color[3])
{
    double sum = .297 * (double)color[0] + .589 * (double)color[1]
                 + .114 * (double)color[2];
    return (uint32_t)(sum * UINT16_MAX);
}

struct pixels {
    enum raster_kind kind;
    bool numbers; /* samples are indices of a palette */
    bool coarse;  /* TGA with 5 bits per colour */
    struct raster raster;
};

static uint32_t grey_height(const struct pixels *pixels, uint32_t sample)
{
    uint32_t most = pixels->raster.most;
    if (pixels->kind == RASTER_PNG && most == UINT8_MAX && pixels->raster.channels == 1)
        return 257 * grey_png_steps((float)sample / (float)most);
    return (uint32_t)((uint64_t)sample * UINT16_MAX / most);
}

static uint32_t color_height(const struct pixels *pixels, const uint16_t *sample)
{
    uint32_t most = pixels->raster.most;
    float color[3];
    if (pixels->coarse)
        return 256u * (sample[0] & COARSE) + (sample[1] & COARSE);
    if (most <= UINT8_MAX)
        return (256u * sample[0] + sample[1]) * UINT8_MAX / most;
    for (int i = 0; i < 3; i++)
        color[i] = (float)sample[i] / (float)most;
    return brightness(color);
}

static uint32_t pixel_height(const struct pixels *pixels, size_t i)
{
    const struct raster *raster = &pixels->raster;
    const uint16_t *sample = raster->samples + i * raster->channels;
    if (pixels->numbers)
        return 256u * sample[0];
    return raster->channels < 3 ? grey_height(pixels, *sample)
                                : color_height(pixels, sample);
}

static void cut_to_bytes(struct raster *raster)
{
    size_t count = raster->width * raster->height * raster->channels;
    for (size_t i = 0; i < count && raster->most > UINT8_MAX; i++)
        raster->samples[i] >>= 8;
    raster->most = UINT8_MAX;
}

/* Computes the heights of a field from the pixels of an image. The lowest row of the
 * image is at z = 0. */
static bool take_pixels(struct reader *reader, const struct scene_token *at,
                        struct pixels *pixels, struct heights *heights)
{
    struct raster *raster = &pixels->raster;
    size_t columns = raster->width, rows = raster->height;
    if (!check_size(reader, at, (double)columns, (double)rows)
        || !allocate(reader, heights, columns, rows))
        return false;
    if (pixels->kind == RASTER_TIFF)
        cut_to_bytes(raster);
    for (size_t i = 0; i < columns * rows; i++)
        heights->list[(rows - 1 - i / columns) * columns + i % columns] = (uint16_t)
            pixel_height(pixels, i);
    return true;
}

/* ---- Images -------------------------------------------------------------- */

/* Decodes an image. In an image with a colour table, the samples become the indices of
 * the colours; `bytes` is modified for this. */
static bool read_pixels(struct reader *reader, const struct image_file *file,
                        char *bytes, struct pixels *pixels)
{
    size_t length = file->source->length;
    pixels->kind = file->kind;
    pixels->coarse = pixels->kind == RASTER_TGA && length > TGA_BITS
                     && (bytes[TGA_BITS] == 15 || bytes[TGA_BITS] == 16);
    pixels->numbers = palette_is_used(pixels->kind, bytes, length);
    if (pixels->numbers && !palette_to_numbers(pixels->kind, bytes, length))
        return reader_fault(reader, &file->at,
                            "the colour table of the image is invalid");
    return image_file_pixels(reader, file, bytes, &pixels->raster);
}

static bool take_file(struct reader *reader, const struct image_file *file,
                      struct heights *heights)
{
    const struct scene_source *source = file->source;
    struct pixels pixels = { .coarse = false };
    char *bytes = malloc(source->length + 1);
    bool done;
    if (!bytes)
        return reader_no_memory(reader);
    memcpy(bytes, source->text, source->length);
    done = read_pixels(reader, file, bytes, &pixels)
           && take_pixels(reader, &file->at, &pixels, heights);
    free(pixels.raster.samples);
    free(bytes);
    return done;
}

static bool read_image(struct reader *reader, struct heights *heights)
{
    struct image_file file;
    return image_file_read(reader, "the kind of an image, its name, or 'function'",
                           &file)
           && take_file(reader, &file, heights);
}

/* ---- Functions ----------------------------------------------------------- */

/* Converts a value to a height. For a value outside of 0 to 1 the height is the lowest
 * 16 bits of the integer, as POV-Ray does. */
static bool take_value(struct reader *reader, const struct scene_token *at,
                       double value, uint16_t *height)
{
    if (value < 0 || value > 1)
        reader_report(reader, at,
                      "the function has values below 0 or above 1, which wrap around");
    if (fabs(value) > MAX_FUNCTION)
        return reader_fault(reader, at,
                            "the function has the value %g, which is out of range",
                            value);
    *height = (uint16_t)(int32_t)(value * UINT16_MAX);
    return true;
}

/* Evaluates the function on the grid. x is from 0 to 1 along the columns. y is from 0
 * to 1 along the rows of an image, which start at the greatest z. z is 0. */
static bool take_values(struct reader *reader, const struct scene_token *at,
                        const struct formula *formula, struct heights *heights)
{
    size_t columns = heights->columns, rows = heights->rows;
    for (size_t i = 0; i < columns * rows; i++) {
        size_t x = i % columns, z = i / columns;
        double place[3] = { (double)x / (double)(columns - 1),
                            (double)(rows - 1 - z) / (double)(rows - 1), 0 };
        double value;
        if (!formula_value(reader, formula, at, place, &value)
            || !take_value(reader, at, value, &heights->list[i]))
            return false;
    }
    return true;
}

static bool read_size(struct reader *reader, double *size)
{
    if (!read_number(reader, size))
        return false;
    *size = trunc(*size);
    reader_comma(reader);
    return true;
}

static bool read_function(struct reader *reader, struct heights *heights)
{
    struct scene_token at = reader->token;
    const struct formula *formula;
    double columns, rows;
    if (!read_size(reader, &columns) || !read_size(reader, &rows)
        || !check_size(reader, &at, columns, rows))
        return false;
    at = reader->token;
    formula = formula_read(reader);
    return formula && allocate(reader, heights, (size_t)columns, (size_t)rows)
           && take_values(reader, &at, formula, heights);
}

bool heights_read(struct reader *reader, struct heights *heights)
{
    memset(heights, 0, sizeof *heights);
    return reader_accept(reader, "function") ? read_function(reader, heights)
                                             : read_image(reader, heights);
}
