/* pattern.h - parses the patterns of pigments and textures.
 *
 * rt/scene/patterns.def lists the patterns that pigments and normals support. For all
 * others, and in textures, the first colour or the first texture is used.
 */
#ifndef RT_SCENE_PATTERN_H
#define RT_SCENE_PATTERN_H

#include "rt/scene/language/scene_statement.h"

/* The patterns of POV-Ray that are not in rt/scene/patterns.def. */
#define UNSUPPORTED_PATTERNS \
    "agate aoi average bozo bumps cells crackle cubic density_file dents facets " \
    "function granite image_pattern julia magnet mandel marble object pavement " \
    "pigment_pattern ripples slope spiral1 spiral2 spotted square tiling " \
    "triangular waves wood wrinkles"

/* Makes the pigment a pattern with the default parameters of this function. */
void pattern_begin(struct pigment *pigment, enum pattern_function function);
/* Each function reads a pattern and its modifiers into a pigment. */
item_reader map_pattern_read, list_pattern_read, checker_pattern_read,
    gradient_pattern_read, image_map_read;
extern const struct keyword pattern_words[];
/* Completes a pigment that has been read. A gradient that was changed becomes a
 * PATTERN_GRADIENT. A pattern without a map gets its default map. A checker gets its
 * two colours. */
bool pattern_finish(struct reader *reader, struct pigment *pigment,
                    const struct scene_token *at);
/* Reads up to `count` colours after the keyword of a pattern. If there are fewer
 * colours, the others do not change. */
bool pigment_colors(struct reader *reader, struct numbers *colors, size_t count);

/* Modifiers of patterns in pigments and textures. They are ignored. */
extern const struct keyword pattern_words_left_out[];

typedef bool body_reader(struct reader *reader, const struct block *block,
                         void *subject);
body_reader pigment_body, texture_body, normal_body;
/* Reads the first entry of a map { [ number body ] ... }, or of a named map of this
 * kind. */
bool map_first(struct reader *reader, enum scene_value_kind kind, body_reader *body,
               void *subject, size_t size);
/* A normal that is being read. The pattern of list.bump is at the start of the struct,
 * so that the keywords that modify patterns apply to it. Its to_local maps to the space
 * of the normal. */
struct normal_reading {
    struct bump_list list;
    bool unscaled;
    const struct block *block; /* the block that is being read */
};
void normal_begin(struct normal_reading *reading, const struct bumps *bumps);
/* The first two functions read the maps of a normal. normal_list_read reads the `count`
 * normals of a pattern with a list, such as checker. */
item_reader read_slope_map, read_normal_map;
bool normal_list_read(struct reader *reader, struct normal_reading *reading,
                      size_t count);
/* A kind of map, such as color_map. A map is written as { [ entry ] ... }, or as the
 * name of a map in braces. */
struct map_kind {
    enum scene_value_kind kind; /* kind of a named map */
    void (*take)(void *map, const struct scene_value *named);
    /* Reads an entry and adds it to the map, whose capacity is *room. */
    bool (*entry)(struct reader *reader, void *map, size_t *room);
};
/* Reads the entries of a map, or the name of a map, into *map, which is empty. */
bool map_read(struct reader *reader, const struct map_kind *kind, void *map);
/* map_has_room returns false, after an error report, if a map has the maximum number of
 * entries. */
enum { MAX_ENTRIES = 256 }; /* as in POV-Ray */
bool map_has_room(struct reader *reader, size_t count);
/* A map from black to white, and a map from cyan to yellow, magenta and cyan. */
extern const struct color_map color_map_gray, color_map_round;
/* Makes a map of the colours of a list, at 0, 1, .. count - 1. */
bool color_map_listed(struct reader *reader, const struct numbers *colors, size_t count,
                      struct color_map *map);

#endif
