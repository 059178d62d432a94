/* png.h - what writes pictures where there is no OpenImageIO: PNG, as the
 * tables of picture_oiio.h have it, and reads none.
 *
 * The pixels are those of OpenImageIO's file, not squeezed: a picture in the
 * page is small, and its readers do not mind.
 * Source: Portable Network Graphics, second edition (ISO/IEC 15948); RFC 1950
 * and 1951.
 */
#ifndef WEB_TRACER_PNG_H
#define WEB_TRACER_PNG_H

#include "rt/picture/picture_oiio.h"

extern const struct picture_adapter png_adapter;

/* An encoded sample between 0 and 1 as 8 bits, as OpenImageIO rounds it. */
unsigned char png_byte(float sample);

#endif
