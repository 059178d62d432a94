/* object_words.c - the table of the keywords that begin an object. */
#include "rt/scene/language/scene_statement.h"

bool item_object(struct reader *reader, const struct item *item)
{
    return item->grammar->object(reader, item);
}

const struct keyword object_words[] = {
#define SHAPE(KIND, name, ...) { #name, item_object, PRIMITIVE_##KIND },
#include "rt/shapes/shapes.def"
    { "union", item_object, SHAPE_UNION },
    { "merge", item_object, SHAPE_MERGE },
    { "intersection", item_object, SHAPE_INTERSECTION },
    { "difference", item_object, SHAPE_DIFFERENCE },
    { "object", item_object, SHAPE_OBJECT },
    { "light_source", item_object, SHAPE_LIGHT },
    { "light_group", item_object, SHAPE_LIGHT_GROUP },
    { "cubic", item_object, SHAPE_CUBIC },
    { "poly", item_object, SHAPE_POLY },
    { "text", item_object, SHAPE_TEXT },
    { "triangle", item_object, SHAPE_TRIANGLE },
    { "smooth_triangle", item_object, SHAPE_SMOOTH_TRIANGLE },
    { "mesh2", item_object, SHAPE_MESH2 },
    { "bicubic_patch", item_object, SHAPE_BICUBIC_PATCH },
    { "polygon", item_object, SHAPE_POLYGON },
    { "height_field", item_object, SHAPE_HEIGHT_FIELD },
    { "isosurface julia_fractal lemon ovus parametric polynomial sor sphere_sweep "
      "superellipsoid",
      item_unsupported, 0 },
    { NULL, NULL, 0 },
};
