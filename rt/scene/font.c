/* font.c - reads fonts with FreeType and converts outlines to parabolas.
 *
 * A TrueType curve is a parabola. A cubic curve is split at equal parameter steps, and
 * each part is replaced by a parabola with the same end points. The tangents of the
 * cubic at the two ends give two estimates of the handle, and the handle is their mean.
 * Let d be the third difference of the cubic's points. The distance between curve and
 * parabola is at most
 *
 *     3^(1/2) / 36  |d| / parts^3  <=  FLATNESS
 *
 * and the number of parts is the least with this bound.
 *
 * Source: derived here, from the difference of the cubic and the parabola.
 */
#include "rt/scene/font.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "rt/platform/dynamic_library.h"
#include "rt/scene/elementary.h"
#include "rt/scene/vector3.h"

#define FLATNESS 1e-5 /* in em */
enum { MAX_PARTS = 64 /* largest number of parts of a curve */, MAX_TURNS = 100 };

/* ---- The library --------------------------------------------------------- */

/* The functions of FreeType that are called. Its reference describes them. */
struct freetype {
    FT_Error (*init)(FT_Library *library);
    FT_Error (*done)(FT_Library library);
    FT_Error (*new_face)(FT_Library library, const FT_Byte *bytes, FT_Long length,
                         FT_Long index, FT_Face *face);
    FT_Error (*done_face)(FT_Face face);
    FT_UInt (*char_index)(FT_Face face, FT_ULong character);
    FT_Error (*load_glyph)(FT_Face face, FT_UInt glyph, FT_Int32 flags);
    FT_Error (*decompose)(FT_Outline *outline, const FT_Outline_Funcs *functions,
                          void *context);
    FT_Error (*kerning)(FT_Face face, FT_UInt left, FT_UInt right, FT_UInt mode,
                        FT_Vector *kerning);
};

struct font {
    struct freetype calls;
    FT_Library library;
    FT_Face face;
};

static bool open_library(struct freetype *calls)
{
    void *library = dynamic_library("libfreetype.so.6");
    return library && dynamic_call(library, "FT_Init_FreeType", &calls->init)
           && dynamic_call(library, "FT_Done_FreeType", &calls->done)
           && dynamic_call(library, "FT_New_Memory_Face", &calls->new_face)
           && dynamic_call(library, "FT_Done_Face", &calls->done_face)
           && dynamic_call(library, "FT_Get_Char_Index", &calls->char_index)
           && dynamic_call(library, "FT_Load_Glyph", &calls->load_glyph)
           && dynamic_call(library, "FT_Outline_Decompose", &calls->decompose)
           && dynamic_call(library, "FT_Get_Kerning", &calls->kerning);
}

static const char *open_face(struct font *font, const char *bytes, size_t length)
{
    if (!open_library(&font->calls))
        return "fonts require FreeType, but libfreetype.so.6 cannot be loaded";
    if (font->calls.init(&font->library))
        return "FreeType cannot be initialized";
    if (font->calls.new_face(font->library, (const FT_Byte *)bytes, (FT_Long)length, 0,
                             &font->face))
        return "the file is not a font";
    return FT_IS_SCALABLE(font->face) ? NULL : "the font has no outlines";
}

struct font *font_open(const char *bytes, size_t length, const char **fault)
{
    struct font *font = calloc(1, sizeof *font);
    *fault = font ? open_face(font, bytes, length) : "there is not enough memory";
    if (!*fault)
        return font;
    font_close(font);
    return NULL;
}

/* Closes the font. The library stays loaded, because other threads may use it. */
void font_close(struct font *font)
{
    if (!font)
        return;
    if (font->face)
        font->calls.done_face(font->face);
    if (font->library)
        font->calls.done(font->library);
    free(font);
}

/* ---- Outlines ------------------------------------------------------------ */

struct drawing {
    struct arena *arena;
    struct glyph *glyph;
    size_t capacity, first; /* index of the first point of the loop */
    double unit;            /* size of a font unit in em */
};

static bool add_point(struct drawing *drawing, double x, double y)
{
    struct glyph *glyph = drawing->glyph;
    double point[2] = { x, y };
    return arena_add(drawing->arena, &glyph->points, &glyph->count, &drawing->capacity,
                     point, sizeof point);
}

/* Returns true if another corner of the loop is equal to this corner. */
static bool is_repeated(const double (*points)[2], size_t count, size_t apart,
                        size_t which)
{
    for (size_t i = 0; i < count; i += apart)
        if (i != which && equal2(points[i], points[which]))
            return true;
    return false;
}

static void turn_by_one(double (*points)[2], size_t count)
{
    double first[2] = { points[0][0], points[0][1] };
    memmove(points, points + 1, (count - 1) * sizeof *points);
    memcpy(points[count - 1], first, sizeof first);
}

void font_turn_loop(double (*points)[2], size_t count, size_t apart)
{
    const double(*fixed)[2] = (const double(*)[2])points;
    size_t turns = 0;
    while (turns < MAX_TURNS * apart && turns < count
           && is_repeated(fixed, count, apart, turns))
        turns += apart;
    if (turns == MAX_TURNS * apart || turns == count)
        return;
    for (; turns; turns--)
        turn_by_one(points, count);
}

static const double *last_point(const struct drawing *drawing)
{
    return drawing->glyph->points[drawing->glyph->count - 1];
}

/* Adds a line to a point. If the outline has curves, the midpoint of the line is its
 * handle. Adds nothing if the outline is already at the point. */
static bool add_line(struct drawing *drawing, const double to[2])
{
    const double *from = last_point(drawing);
    double middle[2] = { (from[0] + to[0]) / 2, (from[1] + to[1]) / 2 };
    if (equal2(from, to))
        return true;
    return (drawing->glyph->apart == 1 || add_point(drawing, middle[0], middle[1]))
           && add_point(drawing, to[0], to[1]);
}

/* Closes the current loop. Rotates it so that its first corner occurs only once (see
 * font_turn_loop). A loop of one point, which fonts use as a mark, is dropped. */
static bool close_loop(struct drawing *drawing)
{
    struct glyph *glyph = drawing->glyph;
    double first[2], (*loop)[2];
    if (glyph->count == drawing->first)
        return true;
    memcpy(first, glyph->points[drawing->first], sizeof first);
    if (!add_line(drawing, first))
        return false;
    glyph->count--;
    if (glyph->count <= drawing->first)
        return true;
    loop = glyph->points + drawing->first;
    font_turn_loop(loop, glyph->count - drawing->first, glyph->apart);
    return add_point(drawing, loop[0][0], loop[0][1]);
}

static int move_to(const FT_Vector *to, void *context)
{
    struct drawing *drawing = context;
    if (!close_loop(drawing))
        return 1;
    drawing->first = drawing->glyph->count;
    return !add_point(drawing, (double)to->x * drawing->unit,
                      (double)to->y * drawing->unit);
}

/* Converts a point of an outline from font units to em. */
static void point_of(const struct drawing *drawing, const FT_Vector *vector,
                     double point[2])
{
    point[0] = (double)vector->x * drawing->unit;
    point[1] = (double)vector->y * drawing->unit;
}

static int line_to(const FT_Vector *to, void *context)
{
    struct drawing *drawing = context;
    double end[2];
    point_of(drawing, to, end);
    return !add_line(drawing, end);
}

static int conic_to(const FT_Vector *by, const FT_Vector *to, void *context)
{
    struct drawing *drawing = context;
    double handle[2], end[2];
    point_of(drawing, by, handle);
    point_of(drawing, to, end);
    if (equal2(last_point(drawing), handle) || equal2(handle, end))
        return !add_line(drawing, end);
    return !add_point(drawing, handle[0], handle[1])
           || !add_point(drawing, end[0], end[1]);
}

/* Return the value at t of a cubic curve in Bernstein form with the control points p,
 * and its derivative. */
static double cubic_at(const double p[4], double t)
{
    double s = 1 - t;
    return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2]
           + t * t * t * p[3];
}

static double cubic_slope(const double p[4], double t)
{
    double s = 1 - t;
    return 3
           * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1])
              + t * t * (p[3] - p[2]));
}

/* Returns true if all control points coincide. */
static bool is_point(const double points[2][4])
{
    for (int k = 0; k < 2; k++)
        for (int i = 1; i < 4; i++)
            if (points[k][i] != points[k][0])
                return false;
    return true;
}

static int cubic_parts(const double points[2][4])
{
    double third[2], parts;
    for (int k = 0; k < 2; k++)
        third[k] = points[k][3] - 3 * points[k][2] + 3 * points[k][1] - points[k][0];
    parts = ceil(
        elementary_pow(sqrt(3) / 36 * elementary_hypot(third[0], third[1]) / FLATNESS,
                       1. / 3));
    return parts < 1 ? 1 : parts > MAX_PARTS ? MAX_PARTS : (int)parts;
}

static int cubic_to(const FT_Vector *by, const FT_Vector *and_by, const FT_Vector *to,
                    void *context)
{
    struct drawing *drawing = context;
    const FT_Vector *const given[] = { by, and_by, to };
    double points[2][4];
    int parts;
    for (int k = 0; k < 2; k++)
        points[k][0] = last_point(drawing)[k];
    for (int i = 0; i < 3; i++) {
        double point[2];
        point_of(drawing, given[i], point);
        points[0][i + 1] = point[0];
        points[1][i + 1] = point[1];
    }
    if (is_point((const double(*)[4])points))
        return 0;
    parts = cubic_parts((const double(*)[4])points);
    for (int i = 0; i < parts; i++) {
        double t = (double)i / parts, next = (double)(i + 1) / parts;
        double handle[2], end[2];
        for (int k = 0; k < 2; k++) {
            end[k] = cubic_at(points[k], next);
            handle[k] = (cubic_at(points[k], t) + end[k]) / 2
                        + (cubic_slope(points[k], t) - cubic_slope(points[k], next))
                              / (4 * parts);
        }
        if (!add_point(drawing, handle[0], handle[1])
            || !add_point(drawing, end[0], end[1]))
            return 1;
    }
    return 0;
}

static bool is_curved(const FT_Outline *outline)
{
    for (int i = 0; i < outline->n_points; i++)
        if (FT_CURVE_TAG(outline->tags[i]) != FT_CURVE_TAG_ON)
            return true;
    return false;
}

bool font_glyph(const struct font *font, uint32_t character, struct arena *arena,
                struct glyph *glyph)
{
    static const FT_Outline_Funcs functions = { move_to,  line_to, conic_to,
                                                cubic_to, 0,       0 };
    const struct freetype *calls = &font->calls;
    FT_Face face = font->face;
    struct drawing drawing = { arena, glyph, 0, 0, 1. / face->units_per_EM };
    *glyph = (struct glyph){ 0 };
    if (calls->load_glyph(face, calls->char_index(face, character),
                          FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP)
        || face->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
        return false;
    glyph->apart = is_curved(&face->glyph->outline) ? 2 : 1;
    if (calls->decompose(&face->glyph->outline, &functions, &drawing)
        || !close_loop(&drawing) || !add_point(&drawing, 0, 0))
        return false;
    glyph->count--; /* the additional point stays allocated */
    glyph->bearing = (double)face->glyph->metrics.horiBearingX * drawing.unit;
    glyph->advance = (double)face->glyph->metrics.horiAdvance * drawing.unit;
    return true;
}

double font_kerning(const struct font *font, uint32_t left, uint32_t right)
{
    const struct freetype *calls = &font->calls;
    FT_Face face = font->face;
    FT_Vector kerning;
    if (!FT_HAS_KERNING(face)
        || calls->kerning(face, calls->char_index(face, left),
                          calls->char_index(face, right), FT_KERNING_UNSCALED,
                          &kerning))
        return 0;
    return (double)kerning.x / face->units_per_EM;
}
