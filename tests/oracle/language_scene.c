/* language_scene.c - generates settings, cameras and lights of random scene texts. */
#include "tests/oracle/language_scene.h"

#include "tests/oracle/language_parts.h"
#include "tests/oracle/solid_text.h"

#include <stdlib.h>

/* ---- Declarations -------------------------------------------------------- */

/* Declares an array without macro calls, which POV-Ray does not execute there. */
void declare_array(struct language *draw)
{
    draw->calling = false;
    write_text(draw, "#declare $+List; = array[4] { $f1;, $f1;, $f1;, $f1; }\n$!List;");
    draw->calling = true;
}

void declare_palette(struct language *draw)
{
    draw->calling = false;
    write_text(draw,
               "#declare $+Palette; = array[4] { $color;, $color;, $color;, $color; }\n"
               "$!Palette;");
    draw->calling = true;
}

static void write_declarations(struct language *draw)
{
    if (one_in(&draw->state, 3)) {
        write_text(draw, "#declare Stream = seed(^#0:1000^);\n");
        draw->streams = true;
    }
    write_text(draw, "$float;$*2:8[$declaration;$]");
}

/* ---- Settings ------------------------------------------------------------ */

static void write_settings(struct language *draw)
{
    size_t level = 3 + below(&draw->state, 10);
    write_text(draw,
               "#version 3.7; global_settings { assumed_gamma $4[2.2|1.0$] "
               "max_trace_level %zu }\n"
               "$4[global_settings { ambient_light $color; }\n|$]",
               level);
    draw->library = one_in(&draw->state, 6);
    if (draw->library)
        write_text(draw, "#include \"colors.inc\"\n");
}

static void write_sky(struct language *draw)
{
    write_text(draw, "background { $color; }\n");
    if (!one_in(&draw->state, 4))
        return;
    bool named = one_in(&draw->state, 3);
    write_text(draw, "%ssky_sphere {\npigment {\n", named ? "#declare Heaven = " : "");
    begin_image(draw, 3, false);
    write_text(
        draw,
        "$[gradient y|gradient y triangle_wave|planar|radial frequency 3|boxed"
        "|leopard frequency 2$]\ncolor_map { [0 rgb <.8, .7, ^20:1^>] "
        "[^2.1:.9^ rgb .4] [1 rgb <.1, .3, .6>] }\n$2[scale 2\n|$]translate -.37\n");
    end_image(draw);
    write_text(draw, "}\n}\n");
    if (named)
        write_text(draw, "sky_sphere { Heaven rotate <0, ^2-90:90^, 20> }\n");
}

/* Writes a fog. No object of the scene is then transparent, because here fog fills such
 * an object, but in POV-Ray only if the object is hollow. */
static void write_fog(struct language *draw)
{
    size_t which = below(&draw->state, 5);
    draw->clear = which > 1;
    draw->metals = !draw->clear;
    if (which == 0)
        write_text(draw, "fog { distance ^28:40^ color $3[rgbt <.6, .7, .8, .2>"
                         "|rgbft <.6, .5, .8, .4, .1>|@.2:1@$] }\n");
}

/* ---- Cameras and lights -------------------------------------------------- */

/* The camera looks obliquely, so that no ray is parallel to a face. */
void write_looking_camera(struct language *draw)
{
    write_text(draw, "$5[orthographic\n|$]");
    double turn = between(&draw->state, -3.1, 3.1);
    double far = between(&draw->state, 7, 9);
    write_text(
        draw, "location <%.4f, ^4-1:4^, %.4f>\n$2[$width;|$]$5[|angle ~30:48~\n$]$aim;",
        far * sin(turn), -far * cos(turn));
}

/* Writes an area light. The other random choices do not depend on it. */
void write_area(struct language *draw)
{
    uint64_t kept = draw->state;
    draw->state = stream_beside(kept, 5, 1);
    if (one_in(&draw->state, 5)) {
        size_t across = 1 + below(&draw->state, 6), down = 1 + below(&draw->state, 4);
        write_text(draw,
                   "area_light <^3.3:2^, 0, ^3-1:1^>, <0, ^3-1:1^, 1>, %zu, %zu\n",
                   across, down);
        if (across > 1 && down > 1)
            write_text(draw, "$2[circular\n|$]");
    }
    draw->state = kept;
}

/* --- scenes --------------------------------------------------------------- */

char *language_scene_text(uint64_t seed)
{
    char *words;
    struct language draw = { .state = seed,
                             .text = test_text(&words),
                             .calling = true };
    for (int i = 0; i < 8; i++)
        xorshift(&draw.state);
    write_settings(&draw);
    write_declarations(&draw);
    write_sky(&draw);
    write_fog(&draw);
    write_text(&draw,
               "camera {\n$4[$turned_camera;|$looking_camera;$]}\n$*1:3[$lamp;$]");
    write_text(&draw,
               "$4[#default {\nfinish {\n$finish_words;}\n}\n|$]"
               "$*0:4[$look_declaration;$]$2[$ground;|$]$6[$macro;|$]$*2:5[$thing;$]");
    fclose(draw.text);
    return text_indented(words);
}
