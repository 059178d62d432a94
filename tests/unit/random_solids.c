/* random_solids.c - writes random shapes, materials, motions and trees of solids. */
#include "random_solids.h"

#include <ctype.h>

#include "rt/shapes/shape.h"

struct solids solids;

size_t below(size_t count)
{
    return (size_t)(xorshift(&traced.random) % count);
}

double size_between(double low, double high)
{
    double size = between(low, high);
    return solids.gridded ? ceil(4 * size) / 4 : size;
}

double place_between(double low, double high)
{
    double place = between(low, high);
    return solids.gridded ? round(4 * place) / 4 : place;
}

double angle(void)
{
    double degrees = between(-90, 90);
    return solids.gridded ? 90 * round(degrees / 90) : degrees;
}

/* ---- Random texts ------------------------------------------------------- */

enum { MAX_PARTS = 24, PART = 200 };

/* Returns the end of the number or choice that begins here. */
static const char *part_end(const char *part)
{
    return *part == '^' ? strchr(part + 1, '^') + 1 : strchr(part, ']') + 1;
}

static void draw_number(const char *part, char *drawn)
{
    char kind = part[2], *end;
    double low = strtod(part + 2 + (isalpha((unsigned char)kind) != 0), &end);
    double high = strtod(end + 1, NULL);
    sprintf(drawn, "%.*f", part[1] - '0',
            kind == 's'   ? size_between(low, high)
            : kind == 'p' ? place_between(low, high)
            : kind == 'a' ? angle()
                          : between(low, high));
}

static void draw_choice(const char *part, char *drawn)
{
    char *begin;
    size_t which = below(strtoul(part + 1, &begin, 10));
    const char *from = begin + 1;
    for (; which > 0 && from[strcspn(from, "|]")] == '|'; which--)
        from += strcspn(from, "|]") + 1;
    sprintf(drawn, "%.*s", (int)strcspn(from, "|]"), from);
}

/* Adds the text up to the next point or $. and returns its end. */
static const char *add_parts(char *text, size_t size, const char *pattern)
{
    char drawn[MAX_PARTS][PART];
    const char *part[MAX_PARTS], *end = pattern;
    size_t count = 0;
    while (*end && *end != '@' && strncmp(end, "$.", 2) != 0)
        if (*end == '^' || *end == '$')
            end = part_end(part[count++] = end);
        else
            end++;
    for (size_t i = count; i-- > 0;)
        (*part[i] == '^' ? draw_number : draw_choice)(part[i], drawn[i]);
    for (size_t i = 0; i < count; i++) {
        add_text(text, size, "%.*s%s", (int)(part[i] - pattern), pattern, drawn[i]);
        pattern = part_end(part[i]);
    }
    add_text(text, size, "%.*s", (int)(end - pattern), pattern);
    return end;
}

void add_random(char *text, size_t size, const char *format, ...)
{
    char pattern[2000], *rest;
    va_list list;
    va_start(list, format);
    vsnprintf(pattern, sizeof pattern, format, list);
    va_end(list);
    for (const char *at = pattern; *(at = add_parts(text, size, at));)
        if (*at == '@') {
            add_point(text, size, strtod(at + 1, &rest));
            at = rest + 1;
        } else {
            at += 2;
        }
}

/* ---- Modifiers ---------------------------------------------------------- */

static void add_color(char *text, size_t size)
{
    double filter = solids.clear && below(2) ? between(0, .7) : 0;
    add_random(text, size, "$3[checker|] rgbft <^30:1^, ^30:1^, ^30:1^, %.3f, %.3f> ",
               filter, filter / 3);
}

/* Writes a gradient with one to six stops. Some stops coincide. */
void add_gradient(char *text, size_t size)
{
    double at = between(-.1, .4);
    add_random(text, size, "gradient @1@ color_map { ");
    for (size_t left = 1 + below(6); left > 0; left--) {
        add_random(text, size, "[%.3f rgb <^30:1^, ^30:1^, ^30:1^>] ", at);
        at += below(4) ? between(.02, .4) : 0;
    }
    add_text(text, size, "} ");
}

/* Writes a finish that depends on the angle. Clear materials are not metallic, because
 * POV-Ray's metallic checkers differ. It uses no random number. */
static void add_gloss(char *text, size_t size)
{
    static const char *const glosses[] = {
        "brilliance 2.5 ",
        "reflection { .1, rgb <.3, .5, .2> falloff 3 } ",
        "emission .1 ",
        "phong .4 metallic .7 ",
        "specular .3 brilliance .7 metallic ",
        "reflection { .4 metallic } ",
    };
    size_t count = COUNT(glosses);
    size_t which = strlen(text) % (4 * count);
    if (which < (solids.clear ? count / 2 : count))
        add_text(text, size, "%s", glosses[which]);
}

void add_look(char *text, size_t size)
{
    add_text(text, size, "pigment { ");
    if (below(5))
        add_color(text, size);
    else
        add_gradient(text, size);
    add_random(text, size, "scale ^3.2:.6^ } finish { ambient .2 diffuse .6 ");
    if (below(3) == 0)
        add_random(text, size, "phong ^20:1^ ");
    if (solids.clear && below(3) == 0)
        add_random(text, size, "reflection ^2.1:.5^ ");
    add_gloss(text, size);
    add_text(text, size, "} ");
}

static void add_motion(char *text, size_t size)
{
    if (below(2))
        add_random(text, size, "rotate <^2a^, ^2a^, ^2a^> ");
    if (below(4) == 0)
        add_random(text, size, "scale <^2s.6:1.4^, ^2s.6:1.4^, ^2s.6:1.4^> ");
    add_random(text, size, "translate <^3p-.6:.6^, ^3p-.6:.6^, ^3p-.6:.6^> ");
}

void add_turn(char *text, size_t size, double larger)
{
    add_random(text, size,
               " scale %.1f rotate <^2-90:90^, ^2-90:90^, ^2-90:90^> translate @1.3@ ",
               larger);
}

/* ---- Shapes ------------------------------------------------------------- */

#define PATTERN(name, pattern) \
    static void name(char *text, size_t size) \
    { \
        add_random(text, size, pattern); \
    }
#define CORNER "<^4s.3:1.2^, ^4s.3:1.2^, ^4s.3:1.2^>"

PATTERN(random_sphere, "sphere { 0, ^4s.5:1.2^ ")
PATTERN(random_box, "box { -" CORNER ", " CORNER " ")
PATTERN(random_cylinder, "cylinder { -^4s.3:1.4^*y, ^4s.3:1.4^*y, ^4s.3:.8^ $4[open|] ")
PATTERN(random_cone,
        "cone { -^4s.3:1.4^*y, ^4s.4:.9^, ^4s.3:1.4^*y, ^4p0:.3^ $4[open|] ")
PATTERN(random_quadric,
        "quadric { <1, ^4p-1:1^, 1>, <0, 0, ^4p-.5:.5^>, 0, -^4s.2:.8^ ")
PATTERN(random_elliptical_torus, "elliptical_torus { ^4s.6:1^, ^4s.15:.4^, ^4s.15:.6^ ")
PATTERN(random_quartic, "quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,"
                        "0,0,0,0,0,0,0,1,0,0,^4p-.3:.3^,-^4s.4:1^> ")

static void random_plane(char *text, size_t size)
{
    add_random(text, size,
               solids.gridded ? "plane { $3[x|y|z]$., ^4p-.3:.6^ "
                              : "plane { @1@, ^4p-.3:.6^ ");
}

/* Writes a disc. Every second disc is a ring. */
static void random_disc(char *text, size_t size)
{
    add_random(text, size,
               solids.gridded ? "disc { @.3@, $3[x|y|z]$., ^4s.5:1.5^ "
                              : "disc { @.3@, @1@, ^4s.5:1.5^ ");
    if (below(2))
        add_random(text, size, ", ^4s.1:.5^ ");
}

PATTERN(random_torus, "torus { ^4s.6:1^, ^4s.15:.4^ ")

/* Writes a lathe with two radii, closed or open, with level and vertical segments. */
static void random_lathe(char *text, size_t size)
{
    double large = size_between(.6, 1), small = size_between(.15, .4);
    bool open = below(4) == 0;
    add_text(text, size,
             "lathe { %d, %s<%.4f, -%.4f>, <%.4f, -%.4f>, <%.4f, %.4f>, "
             "<%.4f, %.4f>, <%.4f, %.4f>%s ",
             open ? 5 : 7, open ? "" : "<0, -1>, ", small, large, large, small, large,
             small, small, small, small, large, open ? "" : ", <0, .75>");
}

/* Writes a corner piece, an arrow or parabolas. */
static void add_outline(char *text, size_t size, bool curved)
{
    double x = size_between(.4, 1.1), z = size_between(.4, 1.1);
    char end[40] = "", start[40] = "6";
    if (curved) {
        snprintf(start, sizeof start, "8, <-%.4f, 0>", x);
        snprintf(end, sizeof end, ", <-%.4f, -%.4f>", x, z);
    }
    add_text(text, size,
             "prism { %s-%.4f, %.4f, %s, <-%.4f, -%.4f>, <%.4f, -%.4f>, "
             "<%.4f, %.4f>, <%.4f, %.4f>, <0, %.4f>, <-%.4f, %.4f>%s %s ",
             curved ? "quadratic_spline " : "", size_between(.3, 1),
             size_between(.3, 1), start, x, z, x, z, x, place_between(-.3, .3),
             place_between(-.2, .2), place_between(-.3, .3), z, x, z, end,
             below(4) ? "" : "open");
}

static void random_prism(char *text, size_t size)
{
    add_outline(text, size, false);
}

static void random_quadratic_prism(char *text, size_t size)
{
    add_outline(text, size, true);
}

static void random_steiner_patch(char *text, size_t size)
{
    add_random(text, size,
               "steiner_patch { <-1, 0, 0>, <0, 2, 0>, <1, 0, 0>, "
               "<-1, 1, -^4s.2:1^>, <1, 1, ^4p-1:1^>, <0, -.5, -^4s.2:1^> ");
    if (below(2))
        add_random(text, size, "weights 1, 1, 1, ^2s.5:2^, .5, 1 ");
}

/* Writes a mesh: a roof, its smooth gable, or both. Both form a closed body. */
static void random_mesh(char *text, size_t size)
{
    double x = size_between(.3, 1), y = place_between(-.5, 1);
    double z = size_between(.3, 1);
    add_text(text, size,
             "mesh { triangle { <-%.4f, 0, 0>, <%.4f, 0, 0>, <0, %.4f, %.4f> }"
             " triangle { <-%.4f, 0, 0>, <%.4f, 0, 0>, <0, %.4f, -%.4f> }"
             " smooth_triangle { <0, %.4f, %.4f>, y, <0, %.4f, -%.4f>, y + z,"
             " <%.4f, 0, 0>, y - z } ",
             x, x, y, z, x, x, y, z, y, z, y, z, x);
    if (below(2))
        add_text(text, size,
                 "triangle { <0, %.4f, %.4f>, <0, %.4f, -%.4f>, <-%.4f, 0, 0>"
                 " } inside_vector <.3, .8, .1> ",
                 y, z, y, z, x);
}

/* Writes two balls and a rod. */
PATTERN(random_blob,
        "blob { threshold ^4.2:.6^ sphere { <^4p-.5:0^, 0, 0>, ^4s.5:1^, 1 }"
        " cylinder { <^4p0:.5^, -^4s.25:.5^, 0>, <^4p0:.5^, ^4s.25:.5^, 0>,"
        " ^4s.4:.8^, 1 }"
        " sphere { <0, ^4p-.5:.5^, ^4p-.5:.5^>, ^4s.4:.8^, $2[|-].8 } ")

add_words *const random_shapes[PRIMITIVE_KINDS] = {
#define SHAPE(KIND, name, ...) random_##name,
#include "rt/shapes/shapes.def"
};

static void add_random_shape(char *text, size_t size, bool surfaces)
{
    size_t kind = below(PRIMITIVE_KINDS);
    while (!surfaces && shapes[kind]->kernels.segments == 0)
        kind = below(PRIMITIVE_KINDS);
    random_shapes[kind](text, size);
}

/* Clips one object in ten, before it is moved. */
static void add_clip(char *text, size_t size)
{
    if (below(10))
        return;
    add_text(text, size, "clipped_by { ");
    add_random_shape(text, size, false);
    add_motion(text, size);
    add_text(text, size, "%s} } ", below(4) ? "" : "inverse ");
}

static void add_leaf(char *text, size_t size)
{
    add_random_shape(text, size, solids.surfaces);
    add_clip(text, size);
    add_look(text, size);
    add_text(text, size, below(8) ? "" : "inverse ");
    add_motion(text, size);
    add_text(text, size, "}\n");
}

/* ---- Trees -------------------------------------------------------------- */

/* Appends a copy of the part of the text that begins at `from`. */
static void add_again(char *text, size_t size, size_t from)
{
    FREED char *copy = NON_NULL(malloc(size));
    strcpy(copy, text + from);
    add_text(text, size, "%s", copy);
}

static void add_children(char *text, size_t size, size_t depth)
{
    size_t children = 2 + below(2), last = strlen(text);
    for (size_t i = 0; i < children; i++) {
        size_t from = strlen(text);
        if (i > 0 && solids.gridded && below(6) == 0)
            add_again(text, size, last);
        else
            add_solid(text, size, depth - 1);
        last = from;
    }
}

void add_solid(char *text, size_t size, size_t depth)
{
    static const struct {
        const char *word;
        bool meets; /* a surface in it causes a report */
    } joined[] = {
        { "difference", true }, { "difference", true }, { "intersection", true },
        { "merge", false },     { "union", false },
    };
    size_t which = below(COUNT(joined));
    bool surfaces = solids.surfaces;
    if (depth == 0 || below(5) == 0) {
        add_leaf(text, size);
        return;
    }
    solids.surfaces = surfaces && (traced.reported || !joined[which].meets);
    add_text(text, size, "%s {\n", joined[which].word);
    add_children(text, size, depth);
    add_clip(text, size);
    add_motion(text, size);
    add_text(text, size, "}\n");
    solids.surfaces = surfaces;
}

/* ---- Solids with a shape -------------------------------------------------- */

static void add_part(char *text, size_t size, add_words *add_shape)
{
    if (below(3))
        add_shape(text, size);
    else if (below(2))
        random_sphere(text, size);
    else if (below(2))
        random_box(text, size);
    else
        random_torus(text, size);
    add_look(text, size);
    add_text(text, size, below(8) ? "" : "inverse ");
    add_motion(text, size);
    add_text(text, size, "}\n");
}

static void write_solids_with(char *text, size_t size, add_words *add_shape)
{
    static const char *const joined[] = { "difference", "intersection", "merge",
                                          "union" };
    add_random(text, size,
               "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 4 }\n"
               "background { rgb <.2, .3, .5> } light_source { <^1-7:7^, 8, -7>, .7 }\n"
               "camera { location <^3p-2:2^, ^3p-2:2^, -5> look_at 0 angle 45 }\n");
    for (size_t solids_left = 2; solids_left > 0; solids_left--) {
        add_text(text, size, "%s {\n", joined[below(4)]);
        for (size_t i = 2 + below(3); i > 0; i--)
            add_part(text, size, add_shape);
        add_motion(text, size);
        add_text(text, size, "}\n");
    }
}

void check_solids_with(add_words *add_shape)
{
    static char text[1 << 16];
    text[0] = '\0';
    write_solids_with(text, sizeof text, add_shape);
    FREED struct words *words = plain_frame(text);
    check_paper_stage(text, words);
    traced.visible = VISIBLE_EVERY;
    traced.no_bounds = true;
    FREED struct words *others = same_frame(text);
    traced.visible = VISIBLE_DEFAULT;
    traced.no_bounds = false;
    FAIL_IF(memcmp(words, others, sizeof *words) != 0,
            "every crossing without bounds gives another frame of\n%s", text);
}
