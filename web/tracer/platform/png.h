/* png.h - writes PNG files in the page, where OpenImageIO is not available, through the
 * function table of picture_oiio.h. It cannot read pictures.
 *
 * The pixels equal the pixels of a file by OpenImageIO. They are not compressed,
 * because pictures in the page are small and every reader accepts stored blocks.
 *
 * Source: Portable Network Graphics, second edition (ISO/IEC 15948); RFC 1950 and 1951.
 */
#ifndef WEB_TRACER_PNG_H
#define WEB_TRACER_PNG_H

#include "rt/picture/picture_oiio.h"

extern const struct picture_adapter png_adapter;

/* Converts an encoded sample between 0 and 1 to 8 bits, rounded as in OpenImageIO. */
unsigned char png_byte(float sample);

#endif
