/* pattern.h - the patterns of pigments and textures.
 *
 * rt/scene/patterns.def lists the patterns that pigments and normals support. For all
 * others, and in textures, the first colour or the first texture is used.
 */
#ifndef RT_SCENE_PATTERN_H
#define RT_SCENE_PATTERN_H

#include "rt/scene/language/scene_statement.h"

/* Patterns of POV-Ray that rt/scene/patterns.def does not have. */
#define UNSUPPORTED_PATTERNS \
    "agate aoi average bozo bumps cells crackle cubic density_file dents facets " \
    "function granite image_pattern julia magnet mandel marble object pavement " \
    "pigment_pattern ripples slope spiral1 spiral2 spotted square tiling " \
    "triangular waves wood wrinkles"

/* Sets a pigment to a pattern with its own defaults. */
void pattern_begin(struct pigment *pigment, enum pattern_function function);
/* These read a pattern and its modifiers into a pigment. */
item_reader map_pattern_read, list_pattern_read, checker_pattern_read,
    gradient_pattern_read, image_map_read;
extern const struct keyword pattern_words[];
/* Completes a pigment that has been read. A gradient that was changed becomes a
 * PATTERN_GRADIENT; a pattern without a map gets its default map; a checker gets its two
 * colours. */
bool pattern_finish(struct reader *reader, struct pigment *pigment,
                    const struct scene_token *at);
/* Reads up to `count` colours after the word of a pattern. Colours that are not given
 * are left unchanged. */
bool pigment_colors(struct reader *reader, struct numbers *colors, size_t count);

/* Modifiers of patterns in pigments and textures that are ignored. */
extern const struct keyword pattern_words_left_out[];

typedef bool body_reader(struct reader *reader, const struct block *block,
                         void *subject);
body_reader pigment_body, texture_body, normal_body;
/* Reads the first entry of a map, { [ number body ] ... }, or of a named map of the
 * kind. */
bool map_first(struct reader *reader, enum scene_value_kind kind, body_reader *body,
               void *subject, size_t size);
/* A normal that is being read. The pattern of its bump holds its space; the bump is the
 * first member, so that the words of patterns modify it. */
struct normal_reading {
    struct bump_list list;
    bool unscaled;
    const struct block *block; /* the block that is read */
};
void normal_begin(struct normal_reading *reading, const struct bumps *bumps);
/* These read the maps of a normal, and the normals of a list. */
item_reader read_slope_map, read_normal_map;
bool normal_list_read(struct reader *reader, struct normal_reading *reading,
                      size_t count);
/* A kind of map, { [ .. ] .. } or { NAME }. */
struct map_kind {
    enum scene_value_kind kind; /* of a named map */
    void (*take)(void *map, const struct scene_value *named);
    /* Reads an entry and adds it to the map, whose capacity is *room. */
    bool (*entry)(struct reader *reader, void *map, size_t *room);
};
/* Reads an empty map. */
bool map_read(struct reader *reader, const struct map_kind *kind, void *map);
/* Fails if a map has as many entries as it can have. */
enum { MAX_ENTRIES = 256 }; /* as in POV-Ray */
bool map_has_room(struct reader *reader, size_t count);
/* Maps from black to white, and from cyan over yellow and magenta to cyan. */
extern const struct color_map color_map_gray, color_map_round;
/* Makes a map between the colours of a list, at 0, 1, .. count - 1. */
bool color_map_listed(struct reader *reader, const struct numbers *colors, size_t count,
                      struct color_map *map);

#endif
