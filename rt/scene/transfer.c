/* transfer.c - converts the samples of image files to the scene's colours.
 *
 * Source: the Portable Network Graphics specification (W3C, second edition).
 */
#include "rt/scene/transfer.h"

#include <string.h>

#include "rt/scene/elementary.h"

/* A chunk of a PNG file: length, name, data, checksum. */
enum { PNG_FIRST = 8, PNG_HEAD = 8, PNG_TAIL = 4 };
#define PNG_GAMMA 100000. /* value of gAMA for gamma 1 */

static uint32_t long_at(const char *bytes, size_t i)
{
    const unsigned char *b = (const unsigned char *)bytes + i;
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
}

/* Returns the transfer function that the chunks of a file specify, or else
 * `transfer`. */
static struct transfer_function png_transfer(const char *bytes, size_t length,
                                             struct transfer_function transfer)
{
    double power;
    size_t at = PNG_FIRST, size;
    for (; length - at >= PNG_HEAD + PNG_TAIL; at += PNG_HEAD + size + PNG_TAIL) {
        const char *name = bytes + at + 4;
        size = long_at(bytes, at);
        if (size > length - at - PNG_HEAD - PNG_TAIL || !memcmp(name, "IDAT", 4))
            break;
        if (!memcmp(name, "sRGB", 4))
            return (struct transfer_function){ TRANSFER_SRGB, 1 };
        if (memcmp(name, "gAMA", 4) || size != 4)
            continue;
        power = long_at(bytes, at + PNG_HEAD) / PNG_GAMMA;
        if (power > 0)
            transfer = (struct transfer_function){ TRANSFER_POWER, 1 / power };
    }
    return transfer;
}

struct transfer_function transfer_of(enum raster_kind kind, const char *bytes,
                                     size_t length, enum transfer_kind otherwise)
{
    struct transfer_function transfer = { otherwise, 1 };
    if (kind == RASTER_TIFF || kind == RASTER_PGM || kind == RASTER_PPM)
        transfer.kind = TRANSFER_NONE;
    return kind == RASTER_PNG ? png_transfer(bytes, length, transfer) : transfer;
}

double srgb_light(double share)
{
    return share <= 0.04045 ? share / 12.92
                            : elementary_pow((share + 0.055) / 1.055, 2.4);
}

double transfer_light(const struct transfer_function *transfer, double share,
                      double assumed_gamma)
{
    double light;
    if (transfer->kind == TRANSFER_NONE)
        return share;
    light = transfer->kind == TRANSFER_SRGB ? srgb_light(share)
                                            : elementary_pow(share, transfer->exponent);
    return assumed_gamma > 0 && assumed_gamma != 1
               ? elementary_pow(light, 1 / assumed_gamma)
               : light;
}

/* Computes the sum of three parts in 32-bit floats, as POV-Ray does, because its
 * rounding decides the truncated result. */
uint32_t grey_png_steps(float share)
{
    float red = share * .297f, green = share * .589f, blue = share * .114f;
    float sum = red + green;
    sum = sum + blue;
    sum = sum * UINT8_MAX;
    return (uint32_t)sum;
}
