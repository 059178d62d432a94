/* transfer.h - the transfer functions of image files.
 *
 * Measured with POV-Ray 3.7, in a scene of #version 3.7: samples of PNG, JPEG, GIF, TGA
 * and BMP are sRGB. If a PNG file specifies another gamma, its samples are a power of
 * the light. Samples of TIFF, PGM and PPM are the scene's colours, unchanged.
 */
#ifndef RT_SCENE_TRANSFER_H
#define RT_SCENE_TRANSFER_H

#include "rt/scene/raster.h"

enum transfer_kind { TRANSFER_NONE, TRANSFER_SRGB, TRANSFER_POWER };
struct transfer_function {
    enum transfer_kind kind;
    double exponent; /* only of TRANSFER_POWER */
};

/* Returns the transfer function of a file, from its kind and from the chunks of a PNG
 * file, or `otherwise` if they do not determine it. */
struct transfer_function transfer_of(enum raster_kind kind, const char *bytes,
                                     size_t length, enum transfer_kind otherwise);
/* Converts a sample to the value in the scene. `share` is the sample divided by the
 * greatest sample. assumed_gamma 0: not specified. */
double transfer_light(const struct transfer_function *transfer, double share,
                      double assumed_gamma);
/* Returns the linear light of an sRGB value from 0 to 1 (IEC 61966-2-1). */
double srgb_light(double share);

/* Returns the integer part of the grey value of `share` in 255ths. POV-Ray computes the
 * grey value of a PNG file with 8 bits as .297 g + .589 g + .114 g in 32-bit floats,
 * and truncates it. */
uint32_t grey_png_steps(float share);

#endif
