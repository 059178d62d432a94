/* parts.c - collects the named parts of a scene. */
#include "rt/scene/named_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"

/* ---- Parts --------------------------------------------------------------- */

static bool same_text(const char *one, const char *other)
{
    return one && other ? strcmp(one, other) == 0 : one == other;
}

static const char *object_name(struct named_parts *parts,
                               const struct world_object *object)
{
    char line[40];
    if (object->name)
        return object->name;
    snprintf(line, sizeof line, "line %zu", object->line);
    return arena_text(&parts->kept, line, strlen(line));
}

/* Returns the index of the object's part, and adds the part if it is new. */
static size_t find_part(struct named_parts *parts, const struct world_object *object,
                        const char *name)
{
    size_t i = 0;
    while (i < parts->count
           && !(same_text(parts->list[i].name, name)
                && same_text(parts->list[i].material, object->material)))
        i++;
    if (i == parts->count)
        parts->list[parts->count++] = (struct named_part){
            .name = name, .material = object->material
        };
    parts->list[i].mixed |= object->mixed;
    return i;
}

bool named_parts_find(const struct scene *scene, struct named_parts *parts)
{
    *parts = (struct named_parts){ 0 };
    parts->list = calloc(scene->object_count + 1, sizeof *parts->list);
    parts->part_of = calloc(scene->object_count + 1, sizeof *parts->part_of);
    for (size_t i = 0; parts->list && parts->part_of && i < scene->object_count; i++) {
        const char *name = object_name(parts, &scene->objects[i]);
        if (!name)
            return false;
        parts->part_of[i] = find_part(parts, &scene->objects[i], name);
    }
    return parts->list && parts->part_of;
}

void named_parts_free(struct named_parts *parts)
{
    free(parts->list);
    free(parts->part_of);
    arena_free(&parts->kept);
}

/* ---- Names --------------------------------------------------------------- */

void named_parts_add_name(c205_error *error, const char *separator, const char *name)
{
    size_t used = strlen(error->message), room = sizeof error->message;
    if (used + strlen(separator) + strlen(name) + 5 < room)
        snprintf(error->message + used, room - used, "%s%s", separator, name);
    else if (used + 4 < room && (used < 3 || strcmp(error->message + used - 3, "...")))
        snprintf(error->message + used, room - used, "...");
}

static bool is_there(const struct named_parts *parts, const char *name)
{
    for (size_t i = 0; i < parts->count; i++)
        if (same_text(parts->list[i].name, name)
            || same_text(parts->list[i].material, name))
            return true;
    return false;
}

static bool name_is_new(const struct named_parts *parts, size_t i, const char *name,
                        bool material)
{
    for (size_t k = 0; k < i; k++)
        if (same_text(material ? parts->list[k].material : parts->list[k].name, name))
            return false;
    return name;
}

/* Adds the distinct names of the parts, or of their materials. */
static void add_names(const struct named_parts *parts, bool material,
                      const char *separator, c205_error *error)
{
    for (size_t i = 0; i < parts->count; i++) {
        const struct named_part *part = &parts->list[i];
        const char *name = material ? part->material : part->name;
        if (!name_is_new(parts, i, name, material))
            continue;
        named_parts_add_name(error, separator, name);
        separator = ", ";
    }
}

bool named_parts_check(const struct named_parts *parts, const char *name,
                       c205_error *error)
{
    if (is_there(parts, name))
        return true;
    error_set(error, "unknown part or material '%.60s'", name);
    add_names(parts, false, "; parts: ", error);
    add_names(parts, true, "; materials: ", error);
    return false;
}

bool named_parts_choose(struct named_parts *parts, const char *const *names,
                        size_t count, c205_error *error)
{
    for (size_t i = 0; i < parts->count; i++)
        parts->list[i].left_out = count > 0 || parts->list[i].endless;
    for (size_t k = 0; k < count; k++) {
        if (!named_parts_check(parts, names[k], error))
            return false;
        for (size_t i = 0; i < parts->count; i++)
            if (same_text(parts->list[i].name, names[k])
                || same_text(parts->list[i].material, names[k]))
                parts->list[i].left_out = false;
    }
    return true;
}
