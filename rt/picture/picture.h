/* picture.h - a frame as a picture file.
 *
 * The file's ending chooses the kind: .png and .jpg hold 8-bit sRGB colours;
 * .exr and .tif hold linear colours with the channels Z (distance along the
 * ray), N.X, N.Y, N.Z (unit normal, world) and id (primitive number, from 1;
 * 0 is background).  The writing is OpenImageIO's; its adapter, a shared
 * object by the name of rt205_oiio.so, is loaded when a picture is first
 * touched or announced, so that a command which makes no picture does not pay for it.  It
 * is looked for in the folder that the environment's RT205_LIBDIR names,
 * beside the running program, and in ../lib/rt205 from there, where it is
 * installed.
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

/* Planes of height x width samples, the top row first. */
struct frame {
    size_t width, height;
    double *channel[FRAME_CHANNELS];
    bool gamma_off; /* colours are as displayed: files have them as they are */
    /* The name of one plane more, which pictures of linear colours have as a
     * channel, and that plane, the caller's own; NULL: there is none. */
    const char *layer;
    double *value;
};

struct picture_note {
    const char *name, *text; /* "c205:clocks", "123456" */
};

struct picture_error {
    char message[256];
};

/* Write the frame, whole or not at all.  notes: metadata, ended by a NULL
 * name; each is an attribute of its own where the kind of file has them (EXR,
 * PNG), and all are lines of the picture's description everywhere.  half:
 * 16-bit samples for the colours of EXR (else 32-bit); depth, normal and id
 * are always 32-bit.  To stdout, "-", goes a .png.  The bytes do not
 * depend on the time of day: a picture has a date only if the environment's
 * SOURCE_DATE_EPOCH names one. */
bool picture_write(const char *path, const struct frame *frame,
                   const struct picture_note *notes, bool half,
                   struct picture_error *error);

/* The same of a frame that comes in parts, from its first row on.  begin: NULL,
 * and the error says why.  rows: the next ones, as many as the part has.  end
 * commits the picture, if all rows came and good is said, else leaves the old
 * file; it frees the picture in any case.  All parts have the layer, or none
 * (NULL).  What is written in parts is the same file if all parts but the last
 * have PICTURE_PART rows. */
enum { PICTURE_PART = 32 };
struct picture;
struct picture *picture_begin(const char *path, size_t width, size_t height,
                              const struct picture_note *notes, bool half,
                              const char *layer, struct picture_error *error);
bool picture_rows(struct picture *picture, const struct frame *part,
                  struct picture_error *error);
bool picture_end(struct picture *picture, bool good, struct picture_error *error);

/* Load the adapter in a thread, for a picture that is to be written later;
 * whoever needs it waits for it.  NULL: the adapter is nowhere; any other fault
 * is told by who writes.  picture_loaded waits for the thread, which must not
 * outlive the program, and frees it. */
struct picture_loader *picture_load(struct picture_error *error);
void picture_loaded(struct picture_loader *loader);

/* Could the path be written?  Tells an unknown ending or a missing folder
 * before a long frame is traced. */
bool picture_check_path(const char *path, struct picture_error *error);
/* Is the ending that of a picture? */
bool picture_is_named(const char *path);
/* Can a file of that ending hold 16-bit samples? */
bool picture_holds_half(const char *path);

/* A picture back into a frame, which the caller frees: colours as linear
 * light, the other channels where the file has them and 0 elsewhere. */
bool picture_read(const char *path, struct frame *frame, struct picture_error *error);

/* .. and of a layer, whose samples become frame->value, which the caller frees,
 * too; 0 where the file has none of that name; of .tif, which has no names, the
 * one plane behind the channels. */
bool picture_read_layer(const char *path, const char *layer, struct frame *frame,
                        struct picture_error *error);

/* The text of one note of a picture, "" when it has none. */
bool picture_read_note(const char *path, const char *name, char *text, size_t size,
                       struct picture_error *error);

/* Linear light, between 0 and 1, encoded as the 8-bit pictures have it; beyond is
 * clipped, and what is not a number is black. */
double picture_srgb(double linear);
/* The value of a colour in a file of 8-bit samples: 0 to 1. */
double picture_shown(const struct frame *frame, double color);

/* A file's bytes as they are, for the reader of scenes. */
raster_reader picture_read_raster;

/* All samples 0.  The picture has at least one pixel; false when memory is
 * short. */
bool frame_allocate(struct frame *frame, size_t width, size_t height);
void frame_free(struct frame *frame);

#endif
