/* transfer.h - what the samples of image files stand for.
 *
 * Measured with POV-Ray 3.7, in a scene of #version 3.7: of PNG, JPEG, GIF, TGA
 * and BMP they are as in sRGB, of a PNG file that has another gamma a power; of
 * TIFF, PGM and PPM they are the scene's colours as they are.
 */
#ifndef RT_SCENE_TRANSFER_H
#define RT_SCENE_TRANSFER_H

#include "rt/scene/raster.h"

enum transfer_kind { TRANSFER_NONE, TRANSFER_SRGB, TRANSFER_POWER };
struct transfer_function {
    enum transfer_kind kind;
    double exponent; /* of a power */
};

/* Of a file by its kind, and by what a PNG file states; otherwise as given. */
struct transfer_function transfer_of(enum raster_kind kind, const char *bytes,
                                     size_t length, enum transfer_kind otherwise);
/* A share of the greatest sample as the scene has it, of this assumed_gamma; 0:
 * none is given. */
double transfer_light(const struct transfer_function *transfer, double share,
                      double assumed_gamma);
/* Linear light of a share that is as in sRGB (IEC 61966-2-1). */
double srgb_light(double share);

/* POV-Ray has grey PNG files of 8 bits as .297 g + .589 g + .114 g, in 32 bits,
 * of which whole 255ths remain: so many of a share. */
uint32_t grey_png_steps(float share);

#endif
