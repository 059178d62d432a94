#include "rt/layout.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rt/picture.h"

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

static uint64_t round_up(uint64_t address)
{
    const uint64_t page = UINT64_C(64) * C205_PAGE_WORDS;

    return (address + page - 1) / page * page;
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
    layout->free = round_up(address + UINT64_C(64) * words);
    return address;
}

/* A record under construction: its words, and fields by name. */
struct record {
    struct layout *layout;
    c205_word *words;
    size_t size;
    size_t line; /* of the scene, where the primitive stands */
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
static void put_field(struct record *record, const char *name,
                      const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(values[i]))
            fail(record->layout, "the object of line %zu is too large or "
                 "too small to be traced", record->line);
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

/* The words of P_SHAPE, as records.s says; returns their number. */
static size_t sphere_shape(const struct primitive *primitive, double *shape)
{
    double r = primitive->shape.sphere.radius;

    memcpy(shape, primitive->shape.sphere.center, 3 * sizeof *shape);
    shape[3] = r * r;
    shape[4] = 1 / r;
    return 5;
}

static size_t box_shape(const struct primitive *primitive, double *shape)
{
    const double *low = primitive->shape.box.corner[0];
    const double *high = primitive->shape.box.corner[1];

    for (size_t i = 0; i < 3; i++) {
        shape[i] = low[i];
        shape[3 + i] = high[i];
        shape[6 + i] = (low[i] + high[i]) / 2;
        shape[9 + i] = (high[i] - low[i]) / 2;
    }
    return 12;
}

static double length3(const double *v)
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Two unit vectors square to the unit vector w and to each other. */
static void frame_about(const double *w, double *u, double *v)
{
    double axis[3] = { 0, 0, 0 };
    double length;

    axis[fabs(w[0]) < 0.5 ? 0 : fabs(w[1]) < 0.5 ? 1 : 2] = 1;
    u[0] = axis[1] * w[2] - axis[2] * w[1];
    u[1] = axis[2] * w[0] - axis[0] * w[2];
    u[2] = axis[0] * w[1] - axis[1] * w[0];
    length = length3(u);
    for (size_t i = 0; i < 3; i++)
        u[i] /= length;
    v[0] = w[1] * u[2] - w[2] * u[1];
    v[1] = w[2] * u[0] - w[0] * u[2];
    v[2] = w[0] * u[1] - w[1] * u[0];
}

static size_t cylinder_shape(const struct primitive *primitive,
                             double *shape)
{
    const double *base = primitive->shape.cylinder.base;
    const double *cap = primitive->shape.cylinder.cap;
    double r = primitive->shape.cylinder.radius;
    double axis[3];
    double length;

    for (size_t i = 0; i < 3; i++) {
        shape[i] = (base[i] + cap[i]) / 2;
        axis[i] = cap[i] - base[i];
    }
    length = length3(axis);
    for (size_t i = 0; i < 3; i++)
        shape[9 + i] = axis[i] / length;
    frame_about(shape + 9, shape + 3, shape + 6);
    shape[12] = r * r;
    shape[13] = length / 2;
    shape[14] = 1 / (2 * r);
    shape[15] = 1 / r;
    return 16;
}

/* A plane is carried into the world here: P^T n' with P the way back. */
static size_t plane_shape(const struct primitive *primitive, double *shape)
{
    const struct transform *back = &primitive->to_local;
    const double *normal = primitive->shape.plane.normal;
    double length;

    for (size_t i = 0; i < 3; i++)
        shape[i] = normal[0] * back->rows[0][i]
                   + normal[1] * back->rows[1][i]
                   + normal[2] * back->rows[2][i];
    shape[3] = primitive->shape.plane.distance;
    for (size_t i = 0; i < 3; i++)
        shape[3] -= normal[i] * back->rows[i][3];
    length = length3(shape);
    for (size_t i = 0; i < 4; i++)
        shape[i] /= length;
    return 4;
}

/* Does the transform keep every sphere a sphere?  Then the sphere is carried
 * into the world here. */
static bool carry_sphere(const struct primitive *primitive, double *shape)
{
    const double (*rows)[4] = primitive->to_world.rows;
    double scale = length3((const double[]){ rows[0][0], rows[1][0],
                                             rows[2][0] });
    const double *center = primitive->shape.sphere.center;
    double r = primitive->shape.sphere.radius * scale;

    for (size_t i = 0; i < 3; i++)
        for (size_t j = 0; j < 3; j++) {
            double dot = rows[0][i] * rows[0][j] + rows[1][i] * rows[1][j]
                         + rows[2][i] * rows[2][j];
            double want = i == j ? scale * scale : 0;

            if (fabs(dot - want) > 1e-12 * scale * scale)
                return false;
        }
    for (size_t i = 0; i < 3; i++)
        shape[i] = rows[i][0] * center[0] + rows[i][1] * center[1]
                   + rows[i][2] * center[2] + rows[i][3];
    shape[3] = r * r;
    shape[4] = 1 / r;
    return true;
}

static bool is_open_cylinder(const struct primitive *primitive)
{
    return primitive->kind == PRIMITIVE_CYLINDER
           && primitive->shape.cylinder.open;
}

struct kind {
    size_t (*shape)(const struct primitive *primitive, double *shape);
    const char *kernel, *normal; /* routines, in both forms of the program */
};

static const struct kind kinds[PRIMITIVE_KINDS] = {
    [PRIMITIVE_SPHERE] = { sphere_shape, "sphere", "normal_sphere" },
    [PRIMITIVE_BOX] = { box_shape, "box", "normal_box" },
    [PRIMITIVE_CYLINDER] = { cylinder_shape, "cylinder", "normal_cylinder" },
    [PRIMITIVE_PLANE] = { plane_shape, "plane", "normal_plane" },
};
static const struct kind open_cylinder = { cylinder_shape, "open_cylinder",
                                           "normal_open_cylinder" };

static void put_shape(struct record *record,
                      const struct primitive *primitive)
{
    const struct kind *kind = is_open_cylinder(primitive)
                                  ? &open_cylinder
                                  : &kinds[primitive->kind];
    double shape[16];
    bool transformed = primitive->transformed
                       && primitive->kind != PRIMITIVE_PLANE;
    size_t count = kind->shape(primitive, shape);

    if (transformed && primitive->kind == PRIMITIVE_SPHERE
        && carry_sphere(primitive, shape))
        transformed = false;
    put_address(record, "P_KERNEL",
                transformed ? "transformed" : kind->kernel);
    put_address(record, "P_INNER", kind->kernel);
    put_address(record, "P_NORMAL", kind->normal);
    put_integer(record, "P_TRANSFORMED", transformed);
    put_field(record, "P_SHAPE", shape, count);
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

static void layout_primitives(struct layout *layout,
                              const struct scene *scene)
{
    size_t size = (size_t)symbol(layout, "P_SIZE");
    uint64_t address = reserve(layout, size * scene->primitive_count);
    c205_word *words = calloc(size + 1, sizeof *words);
    struct record record = { layout, words, size, 0 };

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

static uint64_t end_of_program(const struct object *program)
{
    uint64_t end = 0;

    for (size_t i = 0; i < program->program.segment_count; i++) {
        const c205_segment *segment = &program->program.segments[i];
        uint64_t last = segment->address + UINT64_C(64) * segment->length;

        end = last > end ? last : end;
    }
    return round_up(end);
}

bool layout_scene(c205 *machine, const struct object *program,
                  const struct scene *scene, struct frame_layout *frame,
                  c205_error *error)
{
    struct layout layout = { machine, program, error, false,
                             end_of_program(program) };

    layout_camera(&layout, scene);
    layout_primitives(&layout, scene);
    layout_lights(&layout, scene);
    layout_frame(&layout, frame);
    return !layout.failed;
}
