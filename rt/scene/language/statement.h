/* statement.h - the statements of the language, one reader each.
 *
 * Each is called after its word, which is item->at, and reads its block into
 * what it is given.
 */
#ifndef RT_SCENE_STATEMENT_H
#define RT_SCENE_STATEMENT_H

#include "rt/scene/language/block.h"
#include "rt/shapes/primitive.h"

/* translate, rotate, scale, matrix, transform: rows of a grammar's table. */
enum step { STEP_TRANSLATE, STEP_ROTATE, STEP_SCALE, STEP_MATRIX, STEP_NAMED };
/* clang-format off */
#define STEP_WORDS(read) \
    { "translate", read, STEP_TRANSLATE }, \
    { "rotate", read, STEP_ROTATE }, { "scale", read, STEP_SCALE }, \
    { "matrix", read, STEP_MATRIX }, { "transform", read, STEP_NAMED }
/* clang-format on */
bool step_read(struct reader *reader, const struct item *item, struct placement *step);
/* The block of transform { ... }. */
bool transform_read(struct reader *reader, struct placement *placement);

/* Each changes what it finds: start from the scene's defaults. */
bool pigment_read(struct reader *reader, struct pigment *pigment);
bool finish_read(struct reader *reader, struct finish *finish);
bool normal_read(struct reader *reader, struct bumps *bumps);
bool texture_read(struct reader *reader, struct texture *texture);
/* Another texture, on one that there is. */
bool texture_layer_read(struct reader *reader, const struct scene_token *at,
                        struct texture *texture);
/* All of a map, of which the first is the pigment's colour, if it is no
 * gradient. */
bool color_map_read(struct reader *reader, struct pigment *pigment);
/* Of these the first entry is read. */
bool pigment_map_read(struct reader *reader, struct pigment *pigment);
bool texture_map_read(struct reader *reader, struct texture *texture);
/* All entries of these. */
bool normal_map_read(struct reader *reader, struct bumps *bumps);
bool slope_map_read(struct reader *reader, struct bumps *bumps);
/* The block of #default, and of the statement of that name. */
bool default_read(struct reader *reader);
bool interior_read(struct reader *reader, double *ior);
/* Texture and interior of an object, which may have no parts. */
bool material_read(struct reader *reader, struct scene_object *object);

bool camera_read(struct reader *reader, const struct scene_token *at,
                 struct camera_setting *setting);
extern const struct camera_setting camera_default;
bool settings_read(struct reader *reader, struct scene *scene);
/* The blocks of sky_sphere and fog, which may begin with a name; what the scene
 * has of them. */
bool sky_read(struct reader *reader, struct sky_setting *sky);
void sky_take(struct reader *reader, const struct sky_setting *sky,
              const struct scene_token *at);
bool fog_read(struct reader *reader, struct fog_setting *fog);
bool fog_take(struct reader *reader, const struct fog_setting *fog,
              const struct scene_token *at);

/* What a shape's word stands for: its PRIMITIVE_KIND, or one of these. */
enum shape_word {
    SHAPE_UNION = PRIMITIVE_KINDS, /* in the order of enum joining, up to the
                                      difference */
    SHAPE_MERGE,
    SHAPE_INTERSECTION,
    SHAPE_DIFFERENCE,
    SHAPE_OBJECT,
    SHAPE_NAMED, /* the name of an object without a block */
    SHAPE_LIGHT,
    SHAPE_LIGHT_GROUP,
    SHAPE_CUBIC, /* .. of which a quartic or a quadric is made */
    SHAPE_POLY,
    SHAPE_TEXT, /* of prisms */
    SHAPE_BICUBIC_PATCH,
    SHAPE_POLYGON,
    SHAPE_HEIGHT_FIELD,
    SHAPE_TRIANGLE, /* from here on .. of which a mesh is made */
    SHAPE_SMOOTH_TRIANGLE,
    SHAPE_MESH2
};
/* clang-format off */
#define OTHER_SHAPE_WORDS(read) \
    { "union", read, SHAPE_UNION }, { "merge", read, SHAPE_MERGE }, \
    { "intersection", read, SHAPE_INTERSECTION }, \
    { "difference", read, SHAPE_DIFFERENCE }, \
    { "object", read, SHAPE_OBJECT }, \
    { "light_source", read, SHAPE_LIGHT }, \
    { "light_group", read, SHAPE_LIGHT_GROUP }, \
    { "cubic", read, SHAPE_CUBIC }, { "poly", read, SHAPE_POLY }, \
    { "text", read, SHAPE_TEXT }, { "triangle", read, SHAPE_TRIANGLE }, \
    { "smooth_triangle", read, SHAPE_SMOOTH_TRIANGLE }, \
    { "mesh2", read, SHAPE_MESH2 }, \
    { "bicubic_patch", read, SHAPE_BICUBIC_PATCH }, \
    { "polygon", read, SHAPE_POLYGON }, \
    { "height_field", read, SHAPE_HEIGHT_FIELD }
/* clang-format on */
/* Into an empty object; the caller frees it also after an error. */
bool shape_read(struct reader *reader, struct scene_object *object,
                const struct item *item);
/* The arguments of one primitive, behind its '{'. */
bool primitive_read(struct reader *reader, enum primitive_kind kind,
                    struct primitive *primitive);
/* What is read becomes what is traced.  A shape of which nothing is seen is
 * reported, and left out of the scene: it is the empty set in a solid. */
bool primitive_finish(struct reader *reader, struct primitive *primitive,
                      const struct scene_token *at);
/* The same of any shape, for a reason. */
void primitive_leave_out(struct reader *reader, struct primitive *primitive,
                         const struct scene_token *at, const char *reason);
/* Surfaces of a polynomial: cubic is of the order 3, poly says of which. */
bool polynomial_read(struct reader *reader, enum shape_word word,
                     struct primitive *primitive);
/* The arguments of text, behind its '{': a prism for each character. */
bool text_read(struct reader *reader, struct scene_object *object,
               const struct scene_token *at);
/* The whole block of triangle, smooth_triangle, mesh or mesh2: one
 * primitive. */
bool mesh_read(struct reader *reader, struct scene_object *object,
               const struct item *item);
/* Counts n more primitives and lights, at most MAX_PRIMITIVES. */
bool shape_count(struct reader *reader, size_t more, const struct scene_token *at);
/* Another primitive, which is `at`, within the bound of MAX_PRIMITIVES. */
bool shape_add(struct reader *reader, struct scene_object *object,
               struct primitive *primitive, const struct scene_token *at);
/* A shape of which nothing is seen. */
bool shape_leave_out(struct reader *reader, struct scene_object *object,
                     const struct scene_token *at, const char *reason);
bool light_read(struct reader *reader, struct scene_object *object);
/* The block of looks_like: a thing whose origin is a light's position. */
bool looks_like_read(struct reader *reader, struct scene_object *object,
                     const double position[3]);
/* An interior of its own, of this index of refraction. */
void object_fill(struct reader *reader, struct scene_object *object, double ior);
/* Another copy of an object, within the bound of MAX_PRIMITIVES; its interiors
 * are others. */
bool shape_copy(struct reader *reader, struct scene_object *copy,
                const struct scene_object *object);
/* Shapes of POV-Ray that are not supported. */
extern const struct keyword unsupported_shapes[];

item_reader spline_read; /* its subject: a value */
/* The next token is the name of a spline without a parameter after it. */
bool spline_is_alone(struct reader *reader);

extern const struct grammar file_grammar;
extern const struct grammar modifier_grammar;

#endif
