/* picture.h - writes a frame to a picture file, and reads it back.
 *
 * The file's ending selects the kind: .png and .jpg have 8-bit sRGB colours; .exr and
 * .tif have linear colours and the channels Z (distance along the ray), N.X, N.Y, N.Z
 * (unit normal, world) and id (primitive number, from 1; 0 is background). OpenImageIO
 * does the writing. Its adapter, a shared object named rt205_oiio.so, is loaded when a
 * picture is first accessed or announced, so a command without a picture does not load
 * it. It is searched for in the folder in the environment variable RT205_LIBDIR, in the
 * folder of the running program, and in ../lib/rt205 from there, where it is installed.
 */
#ifndef RT_PICTURE_H
#define RT_PICTURE_H

#include <stdbool.h>
#include <stddef.h>

#include "rt/scene/raster.h"

enum frame_channel {
    CHANNEL_RED,
    CHANNEL_GREEN,
    CHANNEL_BLUE,
    CHANNEL_DEPTH,
    CHANNEL_NORMAL_X,
    CHANNEL_NORMAL_Y,
    CHANNEL_NORMAL_Z,
    CHANNEL_ID,
    FRAME_CHANNELS
};

/* A frame: planes of height x width samples, top row first. */
struct frame {
    size_t width, height;
    double *channel[FRAME_CHANNELS];
    bool gamma_off; /* colours are as displayed; files store them unchanged */
    /* The name of an additional plane, which pictures with linear colours have as a
     * channel, and the plane, which the caller owns. NULL: none. */
    const char *layer;
    double *value;
};

struct picture_note {
    const char *name, *text; /* "c205:clocks", "123456" */
};

/* Writes the frame, completely or not at all. notes is metadata that ends with a
 * NULL name. Each note is an attribute of its own if the kind of file has them
 * (EXR, PNG), and a line of the picture's description in all kinds. half selects
 * 16-bit colour samples for EXR, instead of 32-bit ones; depth, normal and id
 * always have 32 bits. A picture for stdout, "-", is a .png. The bytes do not
 * depend on the time of day: a picture has a date only if the environment variable
 * SOURCE_DATE_EPOCH gives one. */
bool picture_write(const char *path, const struct frame *frame,
                   const struct picture_note *notes, bool half, c205_error *error);

/* Writes a frame in parts, from its first row on. picture_begin returns NULL with
 * the reason in the error. picture_rows adds the next rows, as many as the part
 * has. picture_end commits the picture if all rows have been written and good is
 * true, and otherwise leaves the old file; it frees the picture in any case.
 * Either all parts have the layer or none (NULL). The file is the same as by
 * picture_write if all parts except the last have PICTURE_PART rows. */
enum { PICTURE_PART = 32 };
struct picture;
struct picture *picture_begin(const char *path, size_t width, size_t height,
                              const struct picture_note *notes, bool half,
                              const char *layer, c205_error *error);
bool picture_rows(struct picture *picture, const struct frame *part, c205_error *error);
bool picture_end(struct picture *picture, bool good, c205_error *error);

/* Loads the adapter in a thread, for a picture that is written later; other
 * functions wait for it. Returns NULL if there is no adapter; any other error is
 * reported by the functions that write. picture_loaded waits for the thread, which
 * must end before the program, and frees the loader. */
struct picture_loader *picture_load(c205_error *error);
void picture_loaded(struct picture_loader *loader);

/* Checks that the path can be written. Call it before a long frame, to reject an
 * unknown ending or a missing folder. */
bool picture_check_path(const char *path, c205_error *error);
/* Returns true if the ending is that of a picture. */
bool picture_is_named(const char *path);
/* Returns true if a file with that ending can have 16-bit samples. */
bool picture_holds_half(const char *path);

/* Reads a picture into a frame, which the caller frees. Colours become linear
 * light. Channels that the file lacks become 0. */
bool picture_read(const char *path, struct frame *frame, c205_error *error);

/* Does the same with a layer, whose samples become frame->value, which the caller
 * also frees. It is 0 if the file has no layer of that name. A .tif has no names;
 * there the layer is the single plane after the channels. */
bool picture_read_layer(const char *path, const char *layer, struct frame *frame,
                        c205_error *error);

/* Reads the text of a note of a picture; "" if it has none. */
bool picture_read_note(const char *path, const char *name, char *text, size_t size,
                       c205_error *error);

/* Encodes linear light between 0 and 1 as 8-bit pictures do. Other values are
 * clipped, and NaN becomes black. */
double picture_srgb(double linear);
/* Returns the value of a colour in a file with 8-bit samples, from 0 to 1. */
double picture_shown(const struct frame *frame, double color);

/* Decodes the bytes of an image file without changing its samples, for the scene
 * reader. */
raster_reader picture_read_raster;

/* Allocates a frame of at least one pixel, with all samples 0. Returns false if
 * out of memory. */
bool frame_allocate(struct frame *frame, size_t width, size_t height);
void frame_free(struct frame *frame);

#endif
