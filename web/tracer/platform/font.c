/* font.c - fonts in the page. There are none, because FreeType is not available. */
#include "rt/scene/font.h"

struct font *font_open(const char *bytes, size_t length, const char **fault)
{
    (void)bytes, (void)length;
    *fault = "fonts cannot be read in the page: FreeType is not available";
    return NULL;
}

void font_close(struct font *font)
{
    (void)font;
}

bool font_glyph(const struct font *font, uint32_t character, struct arena *arena,
                struct glyph *glyph)
{
    (void)font, (void)character, (void)arena, (void)glyph;
    return false;
}

double font_kerning(const struct font *font, uint32_t left, uint32_t right)
{
    (void)font, (void)left, (void)right;
    return 0;
}
