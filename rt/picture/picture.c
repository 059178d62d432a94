/* picture.c - writes frames to picture files and reads them back. */
#include "rt/picture/picture.h"
#include "rt/picture/picture_oiio.h"

#include "base/file.h"
#include "base/atomic_file.h"
#include "rt/platform/dynamic_library.h"
#include "rt/platform/threads.h"
#include "vm/error.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- Kinds of files ------------------------------------------------------- */

struct picture_kind {
    const char *ending;
    bool srgb;       /* colours are 8-bit sRGB, else linear */
    size_t channels; /* number of channels, from the start of enum frame_channel */
    bool half;       /* 16-bit samples are possible, in addition to 32-bit samples */
};

static const struct picture_kind picture_kinds[] = {
    { ".png", true, CHANNEL_BLUE + 1, false },
    { ".jpg", true, CHANNEL_BLUE + 1, false },
    { ".jpeg", true, CHANNEL_BLUE + 1, false },
    { ".exr", false, FRAME_CHANNELS, true },
    { ".tif", false, FRAME_CHANNELS, false },
    { ".tiff", false, FRAME_CHANNELS, false },
};

/* The names of the channels, which are conventional for EXR files and known to their
 * readers. */
static const char *const channel_names[FRAME_CHANNELS] = {
    "R", "G", "B", "Z", "N.X", "N.Y", "N.Z", "id",
};

/* The file name with which a picture for stdout is opened. Its ending selects the
 * format. */
static const char stream_name[] = "-.png";

static const struct picture_kind *kind_of(const char *path)
{
    size_t count = sizeof picture_kinds / sizeof picture_kinds[0];
    const char *name = strrchr(path, '/');
    const char *ending = strrchr(name ? name : path, '.');
    if (file_is_stream(path))
        ending = strrchr(stream_name, '.');
    for (size_t i = 0; ending && i < count; i++)
        if (strcasecmp(ending, picture_kinds[i].ending) == 0)
            return &picture_kinds[i];
    return NULL;
}

/* ---- Colours -------------------------------------------------------------- */

/* Encodes linear light by the transfer function of IEC 61966-2-1. */
double picture_srgb(double linear)
{
    if (!(linear > 0))
        return 0;
    if (linear >= 1)
        return 1;
    if (linear <= 0.0031308)
        return 12.92 * linear;
    return 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

double picture_shown(const struct frame *frame, double color)
{
    if (!frame->gamma_off)
        return picture_srgb(color);
    return color > 0 ? fmin(color, 1) : 0;
}

static double srgb_decode(double encoded)
{
    if (encoded <= 0.04045)
        return encoded / 12.92;
    return pow((encoded + 0.055) / 1.055, 2.4);
}

/* ---- Frames --------------------------------------------------------------- */

bool frame_allocate(struct frame *frame, size_t width, size_t height)
{
    memset(frame, 0, sizeof *frame);
    if (!width || !height || height > SIZE_MAX / width / FRAME_CHANNELS)
        return false;
    size_t pixels = width * height;
    double *samples = calloc(pixels * FRAME_CHANNELS, sizeof *samples);
    if (!samples)
        return false;
    frame->width = width;
    frame->height = height;
    for (size_t channel = 0; channel < FRAME_CHANNELS; channel++)
        frame->channel[channel] = samples + channel * pixels;
    return true;
}

void frame_free(struct frame *frame)
{
    free(frame->channel[0]);
    memset(frame, 0, sizeof *frame);
}

static bool is_color(size_t channel)
{
    return channel <= CHANNEL_BLUE;
}

/* Returns the plane of a channel, or the layer for the number after the last
 * channel. */
static const double *plane_of(const struct frame *frame, size_t channel)
{
    return channel < FRAME_CHANNELS ? frame->channel[channel] : frame->value;
}

/* Interleaves the planes of some rows, pixel by pixel. */
static void interleave(const struct frame *frame, const struct picture_image *image,
                       float *sample)
{
    for (size_t i = 0; i < frame->width * frame->height; i++)
        for (size_t channel = 0; channel < image->channels; channel++) {
            double value = plane_of(frame, channel)[i];
            *sample++ = (float)(image->srgb ? picture_shown(frame, value) : value);
        }
}

static void separate(const struct picture_image *image, const struct frame *frame)
{
    const float *sample = image->samples;
    for (size_t i = 0; i < frame->width * frame->height; i++)
        for (size_t channel = 0; channel < image->channels; channel++) {
            double value = (double)*sample++;
            if (image->srgb && is_color(channel))
                value = srgb_decode(value);
            if (channel < FRAME_CHANNELS)
                frame->channel[channel][i] = value;
            else
                frame->value[i] = value;
        }
}

/* ---- The adapter ---------------------------------------------------------- */

/* Adds a path or a subject to the start of the error message. */
static bool fail_at(const char *path, c205_error *error)
{
    c205_error cause = *error;
    return error_set(error, "%s: %s", path, cause.message);
}

static bool adapter_path(char path[ADAPTER_PATH], c205_error *error)
{
    return dynamic_find(PICTURE_ADAPTER_FILE, path, error)
           || fail_at("pictures", error);
}

/* Returns the adapter. The first call opens it. It stays open, because the library
 * cannot be closed safely. */
static const struct picture_adapter *adapter(c205_error *error)
{
    char path[ADAPTER_PATH];
    if (!adapter_path(path, error))
        return NULL;
    const void *table = dynamic_open(path, PICTURE_ADAPTER_SYMBOL, false, error);
    if (!table)
        fail_at("pictures", error);
    return table;
}

/* A thread that opens the OpenImageIO adapter. It is NULL if it could not be
 * started. */
struct picture_loader {
    struct thread *thread;
};

static void load_adapter(void *context)
{
    c205_error error;
    (void)context;
    adapter(&error); /* the writing functions open the adapter again, and report its
                        errors */
}

struct picture_loader *picture_load(c205_error *error)
{
    char path[ADAPTER_PATH];
    if (!adapter_path(path, error))
        return NULL;
    struct picture_loader *loader = calloc(1, sizeof *loader);
    if (!loader)
        error_set(error, "out of memory");
    else
        loader->thread = thread_begin(load_adapter, NULL);
    return loader;
}

void picture_loaded(struct picture_loader *loader)
{
    if (loader)
        thread_end(loader->thread);
    free(loader);
}

/* ---- Paths ---------------------------------------------------------------- */

static bool fail_ending(const char *path, c205_error *error)
{
    return error_set(error,
                     "%s: the name of a picture must end in .png, .jpg, .exr or .tif",
                     path);
}

bool picture_is_named(const char *path)
{
    return kind_of(path);
}

bool picture_holds_half(const char *path)
{
    const struct picture_kind *kind = kind_of(path);
    return kind && kind->half;
}

bool picture_check_path(const char *path, c205_error *error)
{
    struct stat status;
    if (!kind_of(path))
        return fail_ending(path, error);
    if (!file_is_stream(path) && stat(path, &status) == 0 && !S_ISREG(status.st_mode))
        return error_set(error, "%s is not a regular file", path);
    return atomic_file_check(path, error);
}

/* ---- Writing and reading -------------------------------------------------- */

static void choose_formats(struct picture_image *image, bool half)
{
    for (size_t channel = 0; channel < image->channels; channel++)
        image->format[channel] = image->srgb                 ? SAMPLE_BYTE
                                 : half && is_color(channel) ? SAMPLE_HALF
                                                             : SAMPLE_FLOAT;
}

struct picture {
    const struct picture_adapter *files;
    struct picture_image image; /* describes the picture; the samples are passed with
                                   the parts */
    const char *names[FRAME_CHANNELS + 1];
    char *layer;
    char *path;
    struct atomic_file *whole;
    void *writing; /* state of the adapter */
    size_t rows;   /* number of rows that have been written */
};

static bool open_file(struct picture *picture, const struct picture_note *notes,
                      c205_error *error)
{
    const char *path = picture->path;
    picture->files = adapter(error);
    if (!picture->files)
        return false;
    picture->whole = atomic_file_open(path, error);
    if (!picture->whole)
        return false;
    const char *name = file_is_stream(path) ? stream_name : path;
    picture->writing = picture->files->begin(name, &picture->image, notes,
                                             picture->whole->file, error);
    return picture->writing || fail_at(path, error);
}

static char *copy_of(const char *text)
{
    char *copy = text ? malloc(strlen(text) + 1) : NULL;
    return copy ? strcpy(copy, text) : NULL;
}

/* Sets the names of the channels. If the kind of file has more channels than colours,
 * the layer is one of them. */
static void name_channels(struct picture *picture)
{
    for (size_t i = 0; i < FRAME_CHANNELS; i++)
        picture->names[i] = channel_names[i];
    picture->names[FRAME_CHANNELS] = picture->layer;
    picture->image.names = picture->names;
    if (picture->layer && picture->image.channels == FRAME_CHANNELS)
        picture->image.channels++;
}

static void free_picture(struct picture *picture)
{
    if (picture) {
        free(picture->path);
        free(picture->layer);
    }
    free(picture);
}

struct picture *picture_begin(const char *path, size_t width, size_t height,
                              const struct picture_note *notes, bool half,
                              const char *layer, c205_error *error)
{
    if (!picture_check_path(path, error))
        return NULL;
    const struct picture_kind *kind = kind_of(path);
    struct picture *picture = calloc(1, sizeof *picture);
    error_set(error, "out of memory");
    if (picture) {
        picture->path = copy_of(path);
        picture->layer = copy_of(layer);
    }
    if (picture && picture->path && (picture->layer || !layer)) {
        picture->image = (struct picture_image){ .width = width,
                                                 .height = height,
                                                 .channels = kind->channels,
                                                 .srgb = kind->srgb };
        name_channels(picture);
        choose_formats(&picture->image, half && kind->half);
        if (open_file(picture, notes, error))
            return picture;
        if (picture->whole)
            atomic_file_discard(picture->whole);
    }
    free_picture(picture);
    return NULL;
}

bool picture_rows(struct picture *picture, const struct frame *part, c205_error *error)
{
    const struct picture_image *image = &picture->image;
    size_t first = picture->rows, last = first + part->height;
    if (part->width != image->width || last > image->height)
        return error_set(error, "%s: the rows are outside of the picture",
                         picture->path);
    float *samples = malloc(part->width * part->height * image->channels
                            * sizeof *samples);
    if (!samples)
        return error_set(error, "out of memory");
    interleave(part, image, samples);
    bool good = picture->files->rows(picture->writing, first, last, samples, error);
    free(samples);
    picture->rows = last;
    return good || fail_at(picture->path, error);
}

bool picture_end(struct picture *picture, bool good, c205_error *error)
{
    c205_error why = { "its last rows are missing" };
    bool whole = good && picture->rows == picture->image.height;
    bool ended = picture->files->end(picture->writing, whole, &why) && whole;
    if (!ended) {
        atomic_file_discard(picture->whole);
        if (good)
            error_set(error, "%s: %s", picture->path, why.message);
    } else {
        ended = atomic_file_commit(picture->whole, error);
    }
    free_picture(picture);
    return ended;
}

/* Returns a part of a frame's rows as a frame. */
static struct frame part_of(const struct frame *frame, size_t first)
{
    size_t left = frame->height - first;
    struct frame part = { .width = frame->width,
                          .gamma_off = frame->gamma_off,
                          .height = left < PICTURE_PART ? left : PICTURE_PART };
    for (size_t i = 0; i < FRAME_CHANNELS; i++)
        part.channel[i] = frame->channel[i] + first * frame->width;
    if (frame->layer)
        part.value = frame->value + first * frame->width;
    return part;
}

bool picture_write(const char *path, const struct frame *frame,
                   const struct picture_note *notes, bool half, c205_error *error)
{
    struct picture *picture = picture_begin(path, frame->width, frame->height, notes,
                                            half, frame->layer, error);
    bool good = picture != NULL;
    for (size_t row = 0; good && row < frame->height; row += PICTURE_PART) {
        struct frame part = part_of(frame, row);
        good = picture_rows(picture, &part, error);
    }
    return picture && picture_end(picture, good, error);
}

/* Reads a frame. The layer may be NULL. */
static bool read_frame(const char *path, const char *layer, struct frame *frame,
                       c205_error *error)
{
    const char *names[FRAME_CHANNELS + 1];
    struct picture_image image = { .channels = FRAME_CHANNELS + (layer != NULL),
                                   .names = names };
    memcpy(names, channel_names, sizeof channel_names);
    names[FRAME_CHANNELS] = layer;
    const struct picture_adapter *files = adapter(error);
    memset(frame, 0, sizeof *frame);
    if (!files)
        return false;
    if (!files->read(path, &image, error))
        return fail_at(path, error);
    bool good = frame_allocate(frame, image.width, image.height);
    frame->layer = layer;
    if (good && layer)
        frame->value = calloc(image.width * image.height, sizeof *frame->value);
    good = good && (frame->value || !layer);
    if (good)
        separate(&image, frame);
    free(image.samples);
    return good || error_set(error, "out of memory");
}

bool picture_read(const char *path, struct frame *frame, c205_error *error)
{
    return read_frame(path, NULL, frame, error);
}

bool picture_read_layer(const char *path, const char *layer, struct frame *frame,
                        c205_error *error)
{
    return read_frame(path, layer, frame, error);
}

bool picture_read_note(const char *path, const char *name, char *text, size_t size,
                       c205_error *error)
{
    const struct picture_adapter *files = adapter(error);
    if (!files)
        return false;
    return files->read_note(path, name, text, size, error) || fail_at(path, error);
}

bool picture_read_raster(const char *format, const char *bytes, size_t length,
                         struct raster *raster, c205_error *error)
{
    const struct picture_adapter *files = adapter(error);
    return files && files->read_raster(format, bytes, length, raster, error);
}
