/* scene_statement.h - the parsers of the statements of the language.
 *
 * Each parser is called after the keyword of its statement, which is item->at. It reads
 * the block into its last arguments.
 */
#ifndef RT_SCENE_STATEMENT_H
#define RT_SCENE_STATEMENT_H

#include "rt/scene/language/scene_block.h"
#include "rt/shapes/primitive.h"

/* Reads the block of transform { ... }. */
bool transform_read(struct reader *reader, struct placement *placement);

/* These functions modify their argument, which the caller sets to the scene's
 * defaults. */
bool pigment_read(struct reader *reader, struct pigment *pigment);
bool finish_read(struct reader *reader, struct finish *finish);
bool normal_read(struct reader *reader, struct bumps *bumps);
bool texture_read(struct reader *reader, struct texture *texture);
/* The parts of a texture, which the `detail` members of their keywords select.
 * texture_part_read reads one of these parts into the texture. */
enum texture_part { TEXTURE_PIGMENT, TEXTURE_NORMAL, TEXTURE_FINISH, TEXTURE_WHOLE };
bool texture_part_read(struct reader *reader, const struct item *item,
                       struct texture *texture);
item_reader item_texture_part; /* subject: the texture */
/* Reads a texture and adds it to the top of the texture's layers. */
bool texture_layer_read(struct reader *reader, const struct scene_token *at,
                        struct texture *texture);
/* Reads all entries of a color_map. Sets the colour of the pigment to the first entry,
 * unless the pigment is a gradient. */
bool color_map_read(struct reader *reader, struct pigment *pigment);
/* These functions read all entries of a map, but use only the first. */
bool pigment_map_read(struct reader *reader, struct pigment *pigment);
bool texture_map_read(struct reader *reader, struct texture *texture);
/* These functions read all entries of a map, and use them. */
bool normal_map_read(struct reader *reader, struct bump_list *list);
bool slope_map_read(struct reader *reader, struct bump *bump);
/* Reads a value such as a pigment or a camera. The `detail` of the keyword is the kind
 * of the value. */
item_reader item_statement;
/* Reads the block of #default, and of the statement `default`. */
item_reader default_read;
bool interior_read(struct reader *reader, double *ior);
/* Reads the block of material into an object, which may have no parts. */
bool material_read(struct reader *reader, struct scene_object *object);

bool camera_read(struct reader *reader, const struct scene_token *at,
                 struct camera_setting *setting);
extern const struct camera_setting camera_default;
item_reader settings_read;
/* The _read functions read the blocks of sky_sphere and fog, which may begin with a
 * name. The _take functions add the result to the scene. */
bool sky_read(struct reader *reader, struct sky_setting *sky);
void sky_take(struct reader *reader, const struct sky_setting *sky,
              const struct scene_token *at);
bool fog_read(struct reader *reader, struct fog_setting *fog);
bool fog_take(struct reader *reader, const struct fog_setting *fog,
              const struct scene_token *at);

/* The meaning of a shape's keyword: its primitive kind, or one of these values. */
enum shape_word {
    SHAPE_UNION = PRIMITIVE_KINDS, /* up to SHAPE_DIFFERENCE in the order of enum
                                    * joining */
    SHAPE_MERGE,
    SHAPE_INTERSECTION,
    SHAPE_DIFFERENCE,
    SHAPE_OBJECT,
    SHAPE_NAMED, /* the name of an object, without a block */
    SHAPE_LIGHT,
    SHAPE_LIGHT_GROUP,
    SHAPE_CUBIC, /* a cubic or a poly becomes a quartic or a quadric */
    SHAPE_POLY,
    SHAPE_TEXT, /* becomes prisms */
    SHAPE_BICUBIC_PATCH,
    SHAPE_POLYGON,
    SHAPE_HEIGHT_FIELD,
    SHAPE_TRIANGLE, /* this shape and those after it become meshes */
    SHAPE_SMOOTH_TRIANGLE,
    SHAPE_MESH2
};
/* Reads an object with the function that the grammar of the block specifies for
 * objects. */
item_reader item_object;
/* Reads a shape into an empty object, which the caller frees even after an error. */
bool shape_read(struct reader *reader, struct scene_object *object,
                const struct item *item);
/* Reads the arguments of one primitive, after its '{'. */
bool primitive_read(struct reader *reader, enum primitive_kind kind,
                    struct primitive *primitive);
/* Converts a primitive from its arguments to the form that is traced. An invisible
 * shape is reported and removed. In a solid it counts as the empty set. */
bool primitive_finish(struct reader *reader, struct primitive *primitive,
                      const struct scene_token *at);
/* Removes a primitive, so that no ray hits it, and reports the reason. */
void primitive_leave_out(struct reader *reader, struct primitive *primitive,
                         const struct scene_token *at, const char *reason);
/* Reads a cubic, which has order 3, or a poly, whose order is an argument. */
bool polynomial_read(struct reader *reader, enum shape_word word,
                     struct primitive *primitive);
/* These functions read the arguments of a shape after its '{'. A text becomes one prism
 * for each character, the others become meshes. A shape that is invisible in POV-Ray is
 * not added to the object. */
typedef bool shape_reader(struct reader *reader, struct scene_object *object,
                          const struct scene_token *at);
shape_reader text_read, bicubic_patch_read, polygon_read, height_field_read;
/* Tessellates the patch of a part in world space. Afterwards the part has no
 * transform. */
bool bicubic_patch_cut(struct reader *reader, struct scene_part *part,
                       const struct scene_token *at);
/* Moves a smooth height field to world space when its placement is final, and
 * normalises its normals there. Afterwards the part has no transform. */
bool height_field_place(struct reader *reader, struct scene_part *part);
/* Adds a body to the height fields of an object that becomes part of a solid, or is
 * inverted. */
bool fields_fill(struct reader *reader, struct scene_object *object,
                 const struct scene_token *at);
/* Reads the whole block of a blob as one primitive. */
bool blob_read(struct reader *reader, struct scene_object *object,
               const struct item *item);
/* Reads the whole block of triangle, smooth_triangle, mesh or mesh2 as one
 * primitive. */
bool mesh_read(struct reader *reader, struct scene_object *object,
               const struct item *item);
/* Adds `more` to the number of primitives and lights in the scene. Reports an error at
 * `at` if the sum exceeds MAX_PRIMITIVES. */
bool shape_count(struct reader *reader, size_t more, const struct scene_token *at);
/* Adds a primitive. `at` is its keyword. Reports an error above MAX_PRIMITIVES. */
bool shape_add(struct reader *reader, struct scene_object *object,
               struct primitive *primitive, const struct scene_token *at);
/* Skips an invisible shape, and reports the reason why it is invisible. */
bool shape_leave_out(struct reader *reader, struct scene_object *object,
                     const struct scene_token *at, const char *reason);
/* Chooses one texture for a mesh or blob whose pieces have textures of their own: the
 * texture of the object if it has one, or else the texture of the first such piece.
 * Reports the choice at `at`. Does nothing if no piece has a texture. */
void shape_choose_texture(struct reader *reader, struct scene_object *object,
                          const struct scene_token *at, const char *pieces,
                          const char *own);
bool light_read(struct reader *reader, struct scene_object *object);
/* Reads the block of looks_like. The object in the block is moved by `position`, the
 * position of the light. */
bool looks_like_read(struct reader *reader, struct scene_object *object,
                     const double position[3]);
/* Gives an object a new interior with this refractive index. */
void object_fill(struct reader *reader, struct scene_object *object, double ior);
/* These functions read keywords that modify an object, which is the subject. */
item_reader part_read, clipped_by_read, bounded_by_read;
/* Copies an object. The copy has its own interiors. Reports an error above
 * MAX_PRIMITIVES. */
bool shape_copy(struct reader *reader, struct scene_object *copy,
                const struct scene_object *object);

item_reader spline_read; /* subject: a value */
/* Returns true if the current token names a spline that no parameter follows. */
bool spline_is_alone(struct reader *reader);

extern const struct grammar file_grammar;
extern const struct grammar modifier_grammar;

#endif
