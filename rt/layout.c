#include "rt/layout.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rt/picture.h"
#include "rt/program.h"
#include "rt/shape_words.h"

/* The state of one layout: errors stay in it, and make the rest idle. */
struct layout {
    c205 *machine;
    const struct object *program;
    c205_error *error;
    bool failed;
    uint64_t free; /* the next address that nothing uses */
};

static void fail(struct layout *layout, const char *format, ...)
{
    va_list arguments;

    if (layout->failed)
        return;
    layout->failed = true;
    va_start(arguments, format);
    vsnprintf(layout->error->message, sizeof layout->error->message, format,
              arguments);
    va_end(arguments);
}

static uint64_t symbol(struct layout *layout, const char *name)
{
    const struct asm_symbol *found = object_symbol(layout->program, name);

    if (found != NULL)
        return (uint64_t)found->value;
    fail(layout, "the program has no symbol %s", name);
    return 0;
}

static void write_words(struct layout *layout, uint64_t address,
                        const c205_word *words, size_t count)
{
    if (!layout->failed
        && !c205_write(layout->machine, address, words, count))
        fail(layout, "nothing is mapped at %012llX",
             (unsigned long long)address);
}

static void write_word(struct layout *layout, const char *name,
                       c205_word word)
{
    write_words(layout, symbol(layout, name), &word, 1);
}

/* Room for words from a page of its own on. */
static uint64_t reserve(struct layout *layout, size_t words)
{
    uint64_t address = layout->free;

    if (layout->failed || words == 0)
        return address;
    if (!c205_map(layout->machine, address, words, C205_READ_WRITE,
                  layout->error))
        layout->failed = true;
    layout->free = program_round_up(address + UINT64_C(64) * words);
    return address;
}

/* A record under construction: its words, and fields by name. */
struct record {
    struct layout *layout;
    c205_word *words;
    size_t size;
    uint64_t table; /* the next address of its tables */
    size_t line;    /* of the scene, where the primitive stands */
};

static c205_word *field(struct record *record, const char *name,
                        size_t count)
{
    static c205_word nowhere[32];
    uint64_t offset = symbol(record->layout, name);

    if (offset + count <= record->size)
        return record->words + offset;
    fail(record->layout, "field %s does not fit its record", name);
    return nowhere;
}

static void put_numbers(c205_word *words, const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        words[i] = c205_from_double(values[i]);
}

/* A double's exponents are far fewer than the machine's: what squares and
 * reciprocals make of a scene's numbers may be beyond them. */
static void check_finite(struct record *record, const double *values,
                         size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(values[i]))
            fail(record->layout, "the object of line %zu is too large or "
                 "too small to be traced", record->line);
}

static void put_field(struct record *record, const char *name,
                      const double *values, size_t count)
{
    check_finite(record, values, count);
    put_numbers(field(record, name, count), values, count);
}

static void put_matrix(struct record *record, const char *name,
                       const struct transform *transform)
{
    put_field(record, name, &transform->rows[0][0], 12);
}

static void put_address(struct record *record, const char *name,
                        const char *routine)
{
    *field(record, name, 1) = symbol(record->layout, routine);
}

static void put_integer(struct record *record, const char *name,
                        int64_t value)
{
    *field(record, name, 1) = c205_from_integer(value);
}

/* The words that the record has no room for, at the next place of them. */
static void put_table(struct record *record, const double *table,
                      size_t count)
{
    c205_word words[SHAPE_TABLE_MOST];

    check_finite(record, table, count);
    put_numbers(words, table, count);
    write_words(record->layout, record->table, words, count);
    *field(record, "P_TABLE", 1) = record->table;
    record->table += UINT64_C(64) * count;
}

static void put_shape(struct record *record,
                      const struct primitive *primitive)
{
    struct shape_words shape;

    shape_words(primitive, &shape);
    if (shape.historical != NULL
        && object_symbol(record->layout->program, shape.historical) != NULL)
        shape.kernel = shape.historical;
    put_address(record, "P_KERNEL",
                shape.transformed ? "transformed" : shape.kernel);
    put_address(record, "P_INNER", shape.kernel);
    put_address(record, "P_NORMAL", shape.normal);
    put_integer(record, "P_TRANSFORMED", shape.transformed);
    put_integer(record, "P_ON_PATCH", shape.on_patch);
    put_field(record, "P_SHAPE", shape.words, shape.count);
    if (shape.table_count > 0)
        put_table(record, shape.table, shape.table_count);
    put_matrix(record, "P_LOCAL", &primitive->to_local);
}

static void put_surface(struct record *record, const struct scene *scene,
                        const struct primitive *primitive)
{
    const struct pigment *pigment = &primitive->pigment;
    const struct finish *finish = &primitive->finish;
    double words[8];

    put_integer(record, "P_CHECKER", pigment->kind == PIGMENT_CHECKER);
    put_field(record, "P_COLOR", &pigment->color[0][0], 6);
    put_matrix(record, "P_PATTERN", &pigment->to_local);
    for (size_t i = 0; i < 3; i++)
        words[i] = finish->ambient[i] * scene->ambient_light[i];
    words[3] = finish->diffuse;
    words[4] = finish->phong;
    words[5] = finish->phong_size;
    words[6] = finish->specular;
    words[7] = finish->roughness > 0 ? 1 / finish->roughness : 0;
    put_field(record, "P_FINISH", words, 8);
}

static size_t table_words(const struct scene *scene)
{
    struct shape_words shape;
    size_t count = 0;

    for (size_t i = 0; i < scene->primitive_count; i++) {
        shape_words(&scene->primitives[i], &shape);
        count += shape.table_count;
    }
    return count;
}

static void layout_primitives(struct layout *layout,
                              const struct scene *scene)
{
    size_t size = (size_t)symbol(layout, "P_SIZE");
    size_t records = size * scene->primitive_count;
    uint64_t address = reserve(layout, records + table_words(scene));
    c205_word *words = calloc(size + 1, sizeof *words);
    struct record record = { layout, words, size,
                             address + UINT64_C(64) * records, 0 };

    if (words == NULL)
        fail(layout, "no memory");
    for (size_t i = 0; i < scene->primitive_count && !layout->failed; i++) {
        memset(words, 0, size * sizeof *words);
        record.line = scene->primitives[i].line;
        put_integer(&record, "P_ID", (int64_t)i + 1);
        put_shape(&record, &scene->primitives[i]);
        put_surface(&record, scene, &scene->primitives[i]);
        write_words(layout, address + UINT64_C(64) * size * i, words, size);
    }
    free(words);
    write_word(layout, "scene_primitives", address);
    write_word(layout, "scene_primitive_count",
               c205_from_integer((int64_t)scene->primitive_count));
}

static void layout_lights(struct layout *layout, const struct scene *scene)
{
    size_t size = (size_t)symbol(layout, "LIGHT_SIZE");
    uint64_t address = reserve(layout, size * scene->light_count);

    for (size_t i = 0; i < scene->light_count; i++) {
        c205_word words[7];

        put_numbers(words, scene->lights[i].position, 3);
        put_numbers(words + 3, scene->lights[i].color, 3);
        words[6] = c205_from_double(scene->lights[i].shadowless ? 0 : 1);
        write_words(layout, address + UINT64_C(64) * size * i, words, 7);
    }
    write_word(layout, "scene_lights", address);
    write_word(layout, "scene_light_count",
               c205_from_integer((int64_t)scene->light_count));
}

static void layout_camera(struct layout *layout, const struct scene *scene)
{
    const struct camera *camera = &scene->camera;
    c205_word words[12];

    put_numbers(words, camera->location, 3);
    put_numbers(words + 3, camera->direction, 3);
    put_numbers(words + 6, camera->right, 3);
    put_numbers(words + 9, camera->up, 3);
    write_words(layout, symbol(layout, "scene_camera"), words, 12);
    put_numbers(words, scene->background, 3);
    write_words(layout, symbol(layout, "scene_background"), words, 3);
}

static void layout_frame(struct layout *layout, struct frame_layout *frame)
{
    size_t pixels = frame->width * frame->height;

    frame->address = reserve(layout, pixels * FRAME_CHANNELS);
    write_word(layout, "scene_width",
               c205_from_double((double)frame->width));
    write_word(layout, "scene_height",
               c205_from_double((double)frame->height));
    write_word(layout, "scene_pixels", c205_from_integer((int64_t)pixels));
    write_word(layout, "scene_frame", frame->address);
}

bool layout_scene(c205 *machine, const struct object *program,
                  const struct scene *scene, struct frame_layout *frame,
                  c205_error *error)
{
    struct layout layout = { machine, program, error, false,
                             program_end(program) };

    layout_camera(&layout, scene);
    layout_primitives(&layout, scene);
    layout_lights(&layout, scene);
    layout_frame(&layout, frame);
    return !layout.failed;
}
