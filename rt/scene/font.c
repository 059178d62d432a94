/* font.c - fonts by FreeType, and outlines by straight edges.
 *
 * A curve of the degree n, with no greater second difference of its points than
 * d, becomes so many edges of equal steps that they are nowhere farther from it
 * than FLATNESS:
 *
 *     n (n - 1) / 8  d / edges^2  <=  FLATNESS
 *
 * Source: the second derivative of Bernstein's polynomials, and the error of
 * linear interpolation, an eighth of it times the step squared.
 */
#include "rt/scene/font.h"

#include <dlfcn.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#define FLATNESS 1e-4 /* em: a curved side is shaded as a curve's */
enum { EDGES_MOST = 64 /* of one curve */, TURNS_MOST = 100 };

/* ---- The library --------------------------------------------------------- */

/* What is called of it; see FreeType's reference. */
struct freetype {
    FT_Error (*init)(FT_Library *library);
    FT_Error (*done)(FT_Library library);
    FT_Error (*new_face)(FT_Library library, const FT_Byte *bytes,
                         FT_Long length, FT_Long index, FT_Face *face);
    FT_Error (*done_face)(FT_Face face);
    FT_UInt (*char_index)(FT_Face face, FT_ULong character);
    FT_Error (*load_glyph)(FT_Face face, FT_UInt glyph, FT_Int32 flags);
    FT_Error (*decompose)(FT_Outline *outline,
                          const FT_Outline_Funcs *functions, void *context);
    FT_Error (*kerning)(FT_Face face, FT_UInt left, FT_UInt right,
                        FT_UInt mode, FT_Vector *kerning);
};

struct font {
    struct freetype calls;
    FT_Library library;
    FT_Face face;
};

/* Function pointers are no objects in C99; POSIX lets this be done. */
static bool find_call(void *object, const char *name, void *call)
{
    void *found = dlsym(object, name);

    memcpy(call, &found, sizeof found);
    return found != NULL;
}

static bool open_library(struct freetype *calls)
{
    void *object = dlopen("libfreetype.so.6", RTLD_LAZY | RTLD_LOCAL);

    return object && find_call(object, "FT_Init_FreeType", &calls->init)
           && find_call(object, "FT_Done_FreeType", &calls->done)
           && find_call(object, "FT_New_Memory_Face", &calls->new_face)
           && find_call(object, "FT_Done_Face", &calls->done_face)
           && find_call(object, "FT_Get_Char_Index", &calls->char_index)
           && find_call(object, "FT_Load_Glyph", &calls->load_glyph)
           && find_call(object, "FT_Outline_Decompose", &calls->decompose)
           && find_call(object, "FT_Get_Kerning", &calls->kerning);
}

static const char *open_face(struct font *font, const char *bytes,
                             size_t length)
{
    if (!open_library(&font->calls))
        return "there is no FreeType (libfreetype.so.6) to read fonts";
    if (font->calls.init(&font->library))
        return "FreeType does not work";
    if (font->calls.new_face(font->library, (const FT_Byte *)bytes,
                             (FT_Long)length, 0, &font->face))
        return "it is not a font";
    return FT_IS_SCALABLE(font->face) ? NULL : "the font has no outlines";
}

struct font *font_open(const char *bytes, size_t length, const char **fault)
{
    struct font *font = calloc(1, sizeof *font);

    *fault = font ? open_face(font, bytes, length)
                  : "there is not enough memory";
    if (!*fault)
        return font;
    font_close(font);
    return NULL;
}

/* The library stays open: others may be at work with it. */
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
    size_t capacity, first; /* where the loop begins */
    double unit;            /* em */
};

static bool add_point(struct drawing *drawing, double x, double y)
{
    struct glyph *glyph = drawing->glyph;
    double(*points)[2] = arena_grow(drawing->arena, glyph->points,
                                    glyph->count, &drawing->capacity,
                                    sizeof *points);

    if (!points)
        return false;
    glyph->points = points;
    points[glyph->count][0] = x;
    points[glyph->count][1] = y;
    glyph->count++;
    return true;
}

static bool is_at(const double a[2], const double b[2])
{
    return a[0] == b[0] && a[1] == b[1];
}

/* Whether another point of the loop is where this one is. */
static bool is_repeated(const double (*points)[2], size_t count, size_t which)
{
    for (size_t i = 0; i < count; i++)
        if (i != which && is_at(points[i], points[which]))
            return true;
    return false;
}

void font_turn_loop(double (*points)[2], size_t count)
{
    const double(*fixed)[2] = (const double(*)[2])points;
    size_t turns = 0;

    while (turns < TURNS_MOST && turns < count
           && is_repeated(fixed, count, turns))
        turns++;
    if (turns == TURNS_MOST || turns == count)
        return;
    for (; turns; turns--) {
        double first[2] = { points[0][0], points[0][1] };
        memmove(points, points + 1, (count - 1) * sizeof *points);
        memcpy(points[count - 1], first, sizeof first);
    }
}

static bool close_loop(struct drawing *drawing)
{
    struct glyph *glyph = drawing->glyph;
    size_t count = glyph->count - drawing->first;
    double(*loop)[2];

    if (count == 0)
        return true;
    loop = glyph->points + drawing->first;
    if (count > 1 && is_at(loop[0], loop[count - 1])) {
        count--;
        glyph->count--;
    }
    font_turn_loop(loop, count);
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

static int line_to(const FT_Vector *to, void *context)
{
    struct drawing *drawing = context;

    return !add_point(drawing, (double)to->x * drawing->unit,
                      (double)to->y * drawing->unit);
}

/* Bernstein's polynomials of a curve's points, from the last one drawn on. */
static double curve_at(const double points[4], int degree, double t)
{
    double s = 1 - t;

    return degree == 2
               ? s * s * points[0] + 2 * s * t * points[1] + t * t * points[2]
               : s * s * s * points[0] + 3 * s * s * t * points[1]
                     + 3 * s * t * t * points[2] + t * t * t * points[3];
}

static int edges_of(const double points[2][4], int degree)
{
    double bend = 0, factor = degree * (degree - 1) / 8.;
    int edges;

    for (int i = 0; i + 2 <= degree; i++) {
        double second[2];
        for (int k = 0; k < 2; k++)
            second[k] = points[k][i] - 2 * points[k][i + 1]
                        + points[k][i + 2];
        bend = fmax(bend, hypot(second[0], second[1]));
    }
    edges = (int)ceil(sqrt(factor * bend / FLATNESS));
    return edges < 1 ? 1 : edges > EDGES_MOST ? EDGES_MOST : edges;
}

static int curve_to(struct drawing *drawing, const FT_Vector *const *to,
                    int degree)
{
    const struct glyph *glyph = drawing->glyph;
    double points[2][4];
    int edges;

    for (int k = 0; k < 2; k++)
        points[k][0] = glyph->points[glyph->count - 1][k];
    for (int i = 0; i < degree; i++) {
        points[0][i + 1] = (double)to[i]->x * drawing->unit;
        points[1][i + 1] = (double)to[i]->y * drawing->unit;
    }
    edges = edges_of((const double(*)[4])points, degree);
    for (int i = 1; i <= edges; i++) {
        double t = (double)i / edges;
        if (!add_point(drawing, curve_at(points[0], degree, t),
                       curve_at(points[1], degree, t)))
            return 1;
    }
    return 0;
}

static int conic_to(const FT_Vector *by, const FT_Vector *to, void *context)
{
    const FT_Vector *const points[] = { by, to };

    return curve_to(context, points, 2);
}

static int cubic_to(const FT_Vector *by, const FT_Vector *and_by,
                    const FT_Vector *to, void *context)
{
    const FT_Vector *const points[] = { by, and_by, to };

    return curve_to(context, points, 3);
}

bool font_glyph(const struct font *font, uint32_t character,
                struct arena *arena, struct glyph *glyph)
{
    static const FT_Outline_Funcs functions = { move_to,  line_to, conic_to,
                                                cubic_to, 0,       0 };
    const struct freetype *calls = &font->calls;
    FT_Face face = font->face;
    struct drawing drawing = { arena, glyph, 0, 0, 1. / face->units_per_EM };

    *glyph = (struct glyph){ 0 };
    if (calls->load_glyph(face, calls->char_index(face, character),
                          FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP)
        || face->glyph->format != FT_GLYPH_FORMAT_OUTLINE
        || calls->decompose(&face->glyph->outline, &functions, &drawing)
        || !close_loop(&drawing) || !add_point(&drawing, 0, 0))
        return false;
    glyph->count--; /* the point more that there is room for */
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
