/* language_image.c - random pigments that are images. */
#include "tests/oracle/language_parts.h"
#include "tests/oracle/language_scene.h"

const char language_image[] =
    "P3\n"
    "8 6\n"
    "255\n"
    "133 153 166  176 104 102  51 125 93  208 132 248  60 62 48  185 115 37  171 95 243  81 82 80\n"
    "78 248 110  76 197 183  55 48 125  188 185 200  242 184 163  139 113 252  254 232 163  109 57 178\n"
    "168 87 38  241 124 37  228 55 87  155 74 208  47 246 75  139 116 239  121 198 209  56 193 207\n"
    "44 47 145  187 237 127  129 225 95  98 191 123  131 37 88  206 133 90  144 233 195  51 223 196\n"
    "183 48 179  183 41 32  56 67 65  95 207 46  154 229 68  176 134 217  185 190 135  78 176 89\n"
    "89 157 208  180 250 128  253 79 136  89 252 198  156 115 126  138 99 223  196 238 191  51 232 133\n";

/* Writes an image, with a transparent surround if it is not repeated. */
static void write_image(struct language *draw, bool clear)
{
    static const char *const types[] = { "", "map_type 0", "map_type 2", "map_type 1",
                                         "map_type 5" };
    static const char *const gammas[] = { "", "", "gamma 2.2", "gamma srgb" };
    static const char *const between_them[] = { "", "interpolate 2", "interpolate 4" };
    size_t type = below(&draw->state, clear ? 3 : 5);
    size_t smooth = below(&draw->state, 3), gamma = below(&draw->state, 4);
    write_text(draw, "image_map { $2[ppm|$] \"%s\" %s %s %s", LANGUAGE_IMAGE,
               gammas[gamma], types[type], between_them[smooth]);
    write_text(draw, clear ? " once }\n" : type >= 3 ? "$3[ once|$] }\n" : " }\n");
    /* The borders of pixels must not be in the planes of the objects. */
    write_text(draw, "$2[rotate <^2-90:90^, ^2-90:90^, ^2-90:90^>\n|$]scale ^4.7:2^\n"
                     "$.translate <^4.1:.3^, ^4.1:.3^, ^4.1:.3^>\n");
}

void begin_image(struct language *draw, size_t one_of, bool clear)
{
    uint64_t kept = draw->state;
    draw->state = stream_beside(kept, 7, 3);
    if (one_in(&draw->state, one_of)) {
        write_image(draw, clear);
        draw->text_of_all = draw->text;
        draw->text = fopen("/dev/null", "w");
    }
    draw->state = kept;
}

void end_image(struct language *draw)
{
    if (!draw->text_of_all)
        return;
    fclose(draw->text);
    draw->text = draw->text_of_all;
    draw->text_of_all = NULL;
}
