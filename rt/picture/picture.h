/* picture.h - writes a frame to a picture file, and reads it back.
 *
 * The file's ending selects the kind. Files .png and .jpg have 8-bit sRGB colours.
 * Files .exr and .tif have linear colours and the channels Z (distance along the ray),
 * N.X, N.Y, N.Z (unit normal in world space) and id (primitive number from 1; 0 is
 * background). OpenImageIO writes the files. Its adapter is the shared object
 * rt205_oiio.so, which is loaded when the first picture is accessed or announced. A
 * command without a picture therefore does not load it. The adapter is searched for in
 * the folder in the environment variable RT205_LIBDIR, in the folder of the program,
 * and in the installation folder ../lib/rt205 relative to the program.
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

/* A frame. Each plane has height x width samples, with the top row first. */
struct frame {
    size_t width, height;
    double *channel[FRAME_CHANNELS];
    bool gamma_off; /* the colours are displayed without correction, so files store them
                     * unchanged */
    /* An additional plane of values, and its name. Pictures with linear colours contain
     * it as a channel. The caller owns the plane and the name. NULL: no such plane. */
    const char *layer;
    double *value;
};

struct picture_note {
    const char *name, *text; /* such as "c205:clocks", "123456" */
};

/* Writes the frame, completely or not at all. `notes` is metadata, and ends with a NULL
 * name. In EXR and PNG files each note is an attribute. In all files each note is also
 * a line of the picture's description. half: an EXR file has 16-bit colour samples
 * instead of 32-bit samples; depth, normal and id always have 32 bits. A picture for
 * stdout, "-", is a .png. The bytes do not depend on the time, because a picture has a
 * date only if the environment variable SOURCE_DATE_EPOCH contains one. */
bool picture_write(const char *path, const struct frame *frame,
                   const struct picture_note *notes, bool half, c205_error *error);

/* These functions write a frame in parts, starting with its first row. picture_begin
 * returns NULL on failure and sets the error. picture_rows adds the rows of a part.
 * picture_end commits the picture if all rows have been written and `good` is true.
 * Otherwise the old file stays. picture_end frees the picture in all cases. Either all
 * parts have the layer or none of them (NULL). If all parts except the last have
 * PICTURE_PART rows, picture_write would write the same file. */
enum { PICTURE_PART = 32 };
struct picture;
struct picture *picture_begin(const char *path, size_t width, size_t height,
                              const struct picture_note *notes, bool half,
                              const char *layer, c205_error *error);
bool picture_rows(struct picture *picture, const struct frame *part, c205_error *error);
bool picture_end(struct picture *picture, bool good, c205_error *error);

/* picture_load loads the OpenImageIO adapter in a thread, for a picture that is written
 * later. Other functions wait for the adapter. picture_load returns NULL if there is no
 * adapter. The writing functions report any other error. picture_loaded waits for the
 * thread, and frees the loader. Call picture_loaded before the program ends. */
struct picture_loader *picture_load(c205_error *error);
void picture_loaded(struct picture_loader *loader);

/* Checks that the path can be written. Call this before tracing a long frame, to reject
 * an unknown ending or a missing folder. */
bool picture_check_path(const char *path, c205_error *error);
/* Returns true if the name has the ending of a picture. */
bool picture_is_named(const char *path);
/* Returns true if a file with this name can have 16-bit samples. */
bool picture_holds_half(const char *path);

/* Reads a picture into a frame, which the caller frees. Colours become linear light.
 * Channels that are not in the file become 0. */
bool picture_read(const char *path, struct frame *frame, c205_error *error);

/* Like picture_read, but also reads a layer into frame->value, which the caller frees,
 * too. The values are 0 if the file has no layer with this name. The channels of a .tif
 * have no names; its layer is a single plane after the channels. */
bool picture_read_layer(const char *path, const char *layer, struct frame *frame,
                        c205_error *error);

/* Reads the text of a picture's note. The text is "" if the picture has no such
 * note. */
bool picture_read_note(const char *path, const char *name, char *text, size_t size,
                       c205_error *error);

/* Encodes linear light from 0 to 1 as in 8-bit pictures. Other values are clipped. NaN
 * becomes black. */
double picture_srgb(double linear);
/* Returns the value from 0 to 1 that a file with 8-bit samples stores for a colour of
 * the frame. */
double picture_shown(const struct frame *frame, double color);

/* Decodes the bytes of an image file for the scene reader. It does not change the
 * samples. */
raster_reader picture_read_raster;

/* Allocates a frame of at least one pixel, with all samples 0. Returns false if
 * out of memory. */
bool frame_allocate(struct frame *frame, size_t width, size_t height);
void frame_free(struct frame *frame);

#endif
