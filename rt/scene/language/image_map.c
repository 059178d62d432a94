/* image_map.c - parses image_map { ... }, a pigment from an image. */
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/image_file.h"
#include "rt/scene/language/pattern.h"
#include "rt/scene/transfer.h"
#include "rt/scene/vector3.h"

#include <stdlib.h>
#include <string.h>

/* An image of the scene, with the file and the transfer function from which it was
 * decoded. A file is decoded once for each transfer function. */
struct kept_image {
    const struct kept_image *next;
    const struct scene_source *source;
    struct transfer_function transfer;
    bool clear; /* a pixel is transparent */
    struct image_table table;
};

struct image_reading {
    struct image_file file;
    struct transfer_function transfer;
    bool transfer_given;
    struct image_map map;
};

/* ---- Tables -------------------------------------------------------------- */

static double *decode(struct reader *reader, const struct raster *raster,
                      const struct image_file *file,
                      const struct transfer_function *transfer)
{
    double gamma = reader->scene->assumed_gamma;
    bool in_steps = file->kind == RASTER_PNG && raster->channels == 1
                    && raster->most == UINT8_MAX;
    double *light = arena_take(&reader->scene->kept,
                               (raster->most + 1) * sizeof *light);
    for (uint32_t i = 0; light && i <= raster->most; i++) {
        double share = (double)i / (double)raster->most;
        light[i] = transfer_light(transfer, share, gamma);
        if (in_steps)
            light[i] = (double)grey_png_steps((float)light[i]) / UINT8_MAX;
    }
    return light;
}

/* Stores the samples of an image. A grey pixel gets three equal samples. */
static bool take_samples(struct reader *reader, const struct raster *raster,
                         struct kept_image *kept)
{
    size_t pixels = raster->width * raster->height, n = raster->channels;
    uint16_t *samples = arena_take(&reader->scene->kept, 3 * pixels * sizeof *samples);
    if (!samples)
        return reader_no_memory(reader);
    for (size_t i = 0; i < pixels; i++) {
        const uint16_t *pixel = raster->samples + n * i;
        for (size_t k = 0; k < 3; k++)
            samples[3 * i + k] = pixel[n < 3 ? 0 : k];
        if (n % 2 == 0 && pixel[n - 1] < raster->most)
            kept->clear = true;
    }
    kept->table.samples = samples;
    return true;
}

/* Checks the number of images and pixels. The pixels are added to the cost of reading,
 * because a loop may decode images repeatedly. */
static bool check_size(struct reader *reader, const struct raster *raster,
                       const struct scene_token *at)
{
    size_t pixels = raster->width * raster->height;
    if (reader->scene->image_count == MAX_IMAGES)
        return reader_fault(reader, at, "more than %d images", MAX_IMAGES);
    if (pixels > MAX_IMAGE_PIXELS - reader->image_pixels)
        return reader_fault(reader, at,
                            "the images of the scene have more than %d pixels",
                            MAX_IMAGE_PIXELS);
    reader->image_pixels += pixels;
    return reader_spend(reader, pixels + raster->most);
}

static bool take_table(struct reader *reader, const struct raster *raster,
                       const struct image_reading *reading, struct kept_image *kept)
{
    if (!check_size(reader, raster, &reading->file.at))
        return false;
    kept->source = reading->file.source;
    kept->transfer = reading->transfer;
    kept->table.number = reader->scene->image_count++;
    kept->table.width = raster->width;
    kept->table.height = raster->height;
    kept->table.most = raster->most;
    kept->table.light = decode(reader, raster, &reading->file, &reading->transfer);
    if (!kept->table.light)
        return reader_no_memory(reader);
    return take_samples(reader, raster, kept);
}

static const struct kept_image *new_image(struct reader *reader,
                                          const struct image_reading *reading)
{
    struct kept_image *kept = arena_take(&reader->scene->kept, sizeof *kept);
    struct raster raster = { 0 };
    bool done;
    if (!kept) {
        reader_no_memory(reader);
        return NULL;
    }
    done = image_file_pixels(reader, &reading->file, reading->file.source->text,
                             &raster)
           && take_table(reader, &raster, reading, kept);
    free(raster.samples);
    if (!done)
        return NULL;
    kept->next = reader->images;
    return reader->images = kept;
}

static const struct kept_image *image_of(struct reader *reader,
                                         const struct image_reading *reading)
{
    const struct transfer_function *transfer = &reading->transfer;
    const struct kept_image *kept = reader->images;
    while (kept
           && (kept->source != reading->file.source
               || kept->transfer.kind != transfer->kind
               || kept->transfer.exponent != transfer->exponent))
        kept = kept->next;
    return kept ? kept : new_image(reader, reading);
}

/* ---- Words --------------------------------------------------------------- */

/* Reads the mapping of an image, which is one of POV-Ray's numbers 0, 1, 2 and 5. */
static bool read_type(struct reader *reader, const struct item *item)
{
    static const int types[IMAGE_MAPPINGS] = { 0, 1, 2, 5 };
    struct image_reading *reading = item->subject;
    double type;
    if (!read_number(reader, &type))
        return false;
    for (int i = 0; i < IMAGE_MAPPINGS; i++)
        if (types[i] == trunc(type)) {
            reading->map.mapping = (enum image_mapping)i;
            return true;
        }
    reader_report(reader, &item->at,
                  "'map_type %g' is not supported; 0 is used instead", type);
    reading->map.mapping = IMAGE_PLANAR;
    return true;
}

static bool read_sampling(struct reader *reader, const struct item *item)
{
    struct image_reading *reading = item->subject;
    double number;
    if (!read_number(reader, &number))
        return false;
    number = trunc(number);
    if (!(number >= 2 && number <= 4))
        return reader_fault(reader, &item->at, "'interpolate' must be 2, 3 or 4");
    reading->map.sampling = number == 4 ? IMAGE_BY_DISTANCE : IMAGE_BILINEAR;
    if (number == 3)
        reader_report(reader, &item->at,
                      "'interpolate 3' is not supported; 2 is used instead");
    return true;
}

static bool read_gamma(struct reader *reader, const struct item *item)
{
    struct image_reading *reading = item->subject;
    struct transfer_function *transfer = &reading->transfer;
    reading->transfer_given = true;
    *transfer = (struct transfer_function){ TRANSFER_SRGB, 1 };
    if (reader_accept(reader, "srgb"))
        return true;
    transfer->kind = TRANSFER_POWER;
    if (!read_number(reader, &transfer->exponent))
        return false;
    return transfer->exponent > 0
           || reader_fault(reader, &item->at, "the gamma must be above 0");
}

static void report_opaque(struct reader *reader, const struct scene_token *at)
{
    reader_report(reader, at, "a transparent image is drawn opaque");
}

/* Skips filter or transmit of an image, which apply to one palette index or to all. */
static bool read_passing(struct reader *reader, const struct item *item)
{
    report_opaque(reader, &item->at);
    reader_accept(reader, "all");
    skip_arguments(reader);
    return true;
}

static const struct keyword words[] = {
    { "once", item_flag, offsetof(struct image_reading, map.once) },
    { "map_type", read_type, 0 },
    { "interpolate", read_sampling, 0 },
    { "gamma", read_gamma, 0 },
    { "filter transmit", read_passing, 0 },
    { "offset", item_left_out, 0 },
    { "premultiplied use_alpha use_color use_colour use_index", item_ignored, 0 },
    { NULL, NULL, 0 },
};

static const struct grammar grammar = { "a keyword of image_map", .tables = { words } };

/* ---- The pigment --------------------------------------------------------- */

/* Sets the colours of a pigment from an image. The outside of a bounded image is
 * transparent. */
static void show(const struct image_map *map, struct pigment *pigment)
{
    const struct image_table *table = map->table;
    pigment->kind = PIGMENT_IMAGE;
    pigment->image = *map;
    for (int i = 0; i < 3; i++) {
        pigment->color[0][i] = table->light[table->samples[i]];
        pigment->color[1][i] = 1;
    }
    pigment->filter[0] = pigment->transmit[0] = pigment->filter[1] = 0;
    pigment->transmit[1] = image_is_bounded(map);
}

/* Returns the transfer function of a file without `gamma`. Before version 3.7 only a
 * PNG file that contains its gamma is decoded. Without assumed_gamma no file is
 * decoded. */
static struct transfer_function default_transfer(const struct reader *reader,
                                                 const struct image_file *file)
{
    const struct scene_source *source = file->source;
    bool before = reader_is_before(reader, 3.7);
    if (before && reader->scene->assumed_gamma == 0)
        return (struct transfer_function){ TRANSFER_NONE, 1 };
    return transfer_of(file->kind, source->text, source->length,
                       before ? TRANSFER_NONE : TRANSFER_SRGB);
}

static bool take_image(struct reader *reader, struct image_reading *reading,
                       struct pigment *pigment)
{
    const struct kept_image *kept;
    if (!reading->transfer_given)
        reading->transfer = default_transfer(reader, &reading->file);
    kept = image_of(reader, reading);
    if (!kept)
        return false;
    if (kept->clear)
        report_opaque(reader, &reading->file.at);
    reading->map.table = &kept->table;
    show(&reading->map, pigment);
    return true;
}

/* Reads the optional vector before the file name, by which old scenes select the axes
 * of the image. */
static bool read_way(struct reader *reader)
{
    static const double usual[3] = { 1, -1, 0 };
    struct scene_token at = reader->token;
    double way[3];
    if (!starts_expression(reader))
        return true;
    if (!read_vector(reader, way))
        return false;
    reader_comma(reader);
    if (memcmp(way, usual, sizeof way) != 0)
        reader_report(reader, &at,
                      "the vector of an image is not supported; <1, -1, "
                      "0> is used instead");
    return true;
}

/* Skips an image that is not in a file, or whose kind is not supported. The pigment
 * becomes black. */
static bool leave_out(struct reader *reader, const struct block *block,
                      struct pigment *pigment, const char *what)
{
    reader_report(reader, &reader->token,
                  "an image of the kind '%s' is not supported and is drawn black",
                  what);
    pigment->kind = PIGMENT_COLOR;
    memset(pigment->color, 0, sizeof pigment->color);
    pigment->filter[0] = pigment->transmit[0] = 0;
    return block_finish(reader, block);
}

/* Reads an image as the pigment. As in POV-Ray, it sets the frequency to 0, which a
 * later pattern in the same pigment then keeps. */
bool image_map_read(struct reader *reader, const struct item *item)
{
    struct image_reading reading = { .map = { .mapping = IMAGE_PLANAR } };
    struct pigment *pigment = item->subject;
    const char *other;
    struct block block;
    bool good;
    pigment->pattern.frequency = 0;
    if (!block_open(reader, &block, '{'))
        return false;
    good = read_way(reader);
    other = image_kind_unsupported(reader);
    if (good && !other)
        other = is_token(&reader->token, "function")  ? "function"
                : is_token(&reader->token, "pigment") ? "pigment"
                                                      : NULL;
    if (good && other)
        return leave_out(reader, &block, pigment, other);
    good = good
           && image_file_read(reader, "the kind of an image, or its name",
                              &reading.file);
    return block_items(reader, &block, &grammar, &reading, good)
           && take_image(reader, &reading, pigment);
}
