/* images.c - writes the images of pigments into the machine's memory. */
#include "rt/layout/images.h"

#include <stdlib.h>

enum { PIXEL_SIZE = 3 }; /* words for red, green and blue */

/* The coordinates that can be outside of the image: none, v, or both u and v. */
enum { OUTSIDE_NEVER, OUTSIDE_V, OUTSIDE_U_V };

bool scene_has_images(const struct scene *scene)
{
    bool found = scene->sky.kind == PIGMENT_IMAGE;
    for (size_t i = 0; i < scene->primitive_count && !found; i++)
        found = scene->primitives[i].pigment.kind == PIGMENT_IMAGE;
    return found;
}

const char *image_routine(const struct image_map *map)
{
    static const char *const routines[IMAGE_MAPPINGS] = {
        [IMAGE_PLANAR] = "image_planar",
        [IMAGE_SPHERICAL] = "image_spherical",
        [IMAGE_CYLINDRICAL] = "image_cylindrical",
        [IMAGE_TORUS] = "image_torus",
    };
    return routines[map->mapping];
}

const char *image_sampler(const struct image_map *map)
{
    static const char *const routines[IMAGE_SAMPLINGS] = {
        [IMAGE_NEAREST] = "image_nearest",
        [IMAGE_BILINEAR] = "image_bilinear",
        [IMAGE_BY_DISTANCE] = "image_by_distance",
    };
    return routines[map->sampling];
}

static double bound_of(const struct image_map *map)
{
    if (!image_is_bounded(map))
        return OUTSIDE_NEVER;
    return map->mapping == IMAGE_PLANAR ? OUTSIDE_U_V : OUTSIDE_V;
}

void image_numbers(const struct image_map *map, double numbers[])
{
    numbers[0] = (double)map->table->width;
    numbers[1] = (double)map->table->height;
    numbers[2] = bound_of(map);
    numbers[3] = map->once;
}

/* Writes the pixels of an image. Converts one row at a time, so the host needs extra
 * memory for only one row. */
static void put_rows(struct record_layout *layout, const struct image_table *table,
                     const c205_word *light, uint64_t address)
{
    size_t count = PIXEL_SIZE * table->width;
    c205_word *words = calloc(count, sizeof *words);
    if (!words)
        layout_fail(layout, "out of memory");
    for (size_t row = 0; words && row < table->height; row++) {
        const uint16_t *samples = table->samples + row * count;
        for (size_t i = 0; i < count; i++)
            words[i] = light[samples[i]];
        layout_words(layout, address + UINT64_C(64) * row * count, words, count);
    }
    free(words);
}

static uint64_t put_image(struct record_layout *layout, const struct image_table *table)
{
    uint64_t address = layout_reserve(layout,
                                      PIXEL_SIZE * table->width * table->height);
    c205_word *light = calloc((size_t)table->most + 1, sizeof *light);
    if (light) {
        put_numbers(light, table->light, (size_t)table->most + 1);
        put_rows(layout, table, light, address);
    } else {
        layout_fail(layout, "out of memory");
    }
    free(light);
    return address;
}

static void lay_out_image(struct record_layout *layout, const struct pigment *pigment,
                          uint64_t *addresses)
{
    const struct image_table *table = pigment->image.table;
    if (pigment->kind == PIGMENT_IMAGE && addresses[table->number] == 0)
        addresses[table->number] = put_image(layout, table);
}

uint64_t *images_layout(struct record_layout *layout, const struct scene *scene)
{
    uint64_t *addresses = calloc(scene->image_count + 1, sizeof *addresses);
    if (!addresses) {
        layout_fail(layout, "out of memory");
        return NULL;
    }
    lay_out_image(layout, &scene->sky, addresses);
    for (size_t i = 0; i < scene->primitive_count; i++)
        lay_out_image(layout, &scene->primitives[i].pigment, addresses);
    return addresses;
}
