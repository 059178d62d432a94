/* object.c - lists of primitives and lights under construction. */
#include "rt/scene/object.h"

#include <stdlib.h>
#include <string.h>

bool array_room(void **items, size_t *room, size_t count, size_t size)
{
    size_t wanted = *room ? 2 * *room : 1;
    void *grown;

    if (count < *room)
        return true;
    grown = realloc(*items, wanted * size);
    if (!grown)
        return false;
    *items = grown;
    *room = wanted;
    return true;
}

void pigment_move(struct pigment *pigment, const struct placement *step)
{
    pigment->to_local = transform_then(&step->to_local, &pigment->to_local);
}

static bool add_part(struct object *object, const struct part *part)
{
    void *parts = object->parts;
    bool room = array_room(&parts, &object->part_room, object->part_count,
                           sizeof *part);

    object->parts = parts;
    if (room)
        object->parts[object->part_count++] = *part;
    return room;
}

bool object_add_primitive(struct object *object,
                          const struct primitive *primitive)
{
    struct part part;

    memset(&part, 0, sizeof part);
    part.primitive = *primitive;
    return add_part(object, &part);
}

bool object_add_light(struct object *object, const struct light *light)
{
    void *lights = object->lights;
    bool room = array_room(&lights, &object->light_room, object->light_count,
                           sizeof *light);

    object->lights = lights;
    if (room)
        object->lights[object->light_count++] = *light;
    return room;
}

bool object_add(struct object *object, const struct object *child)
{
    for (size_t i = 0; i < child->part_count; i++) {
        struct part part = child->parts[i];
        if (!part.textured && child->textured) {
            part.primitive.pigment = child->texture.pigment;
            part.primitive.finish = child->texture.finish;
            part.textured = true;
        }
        if (!add_part(object, &part))
            return false;
    }
    for (size_t i = 0; i < child->light_count; i++)
        if (!object_add_light(object, &child->lights[i]))
            return false;
    return true;
}

bool object_copy(struct object *copy, const struct object *object)
{
    struct object bare = *object;

    bare.textured = false;
    copy->textured = object->textured;
    copy->texture = object->texture;
    return object_add(copy, &bare);
}

static void part_move(struct part *part, const struct placement *step)
{
    struct primitive *primitive = &part->primitive;

    primitive->to_world =
        transform_then(&primitive->to_world, &step->to_world);
    primitive->to_local =
        transform_then(&step->to_local, &primitive->to_local);
    if (part->textured)
        pigment_move(&primitive->pigment, step);
}

void object_move(struct object *object, const struct placement *step)
{
    for (size_t i = 0; i < object->part_count; i++)
        part_move(&object->parts[i], step);
    for (size_t i = 0; i < object->light_count; i++)
        transform_point(&step->to_world, object->lights[i].position);
    if (object->textured)
        pigment_move(&object->texture.pigment, step);
}

void scene_object_free(struct object *object)
{
    free(object->parts);
    free(object->lights);
    memset(object, 0, sizeof *object);
}
