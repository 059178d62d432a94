/* test_shapes.c - every row of rt/shapes/shapes.def is compared with the kernels, the
 * scenes of the tests and the plain tracer. A descriptor that is incomplete, or a
 * shape without a kernel in one form, fails here. */
#include "tests/unit/scene_reading.h"

#include "rt/layout/program.h"
#include "rt/scene/transform.h"
#include "rt/shapes/opaque_faces.h"
#include "rt/shapes/shape_words.h"
#include "tests/oracle/plain_shapes.h"
#include "tests/unit/asm_helper.h"
#include "tests/unit/draw.h"

/* ---- Descriptors --------------------------------------------------------- */

TEST(descriptors)
{
    for (size_t i = 0; i < PRIMITIVE_KINDS; i++) {
        const struct shape *shape = shapes[i];
        const char *name = primitive_kind_name((enum primitive_kind)i);
        /* meshes and blobs have their own parsers */
        bool read = i != PRIMITIVE_MESH && i != PRIMITIVE_BLOB;
        if (!shape->fields || (shape->fields[0].takes == TAKES_END) == read
            || !shape->finish || !shape->bound || !shape->words || !shape->region)
            fail_msg("the descriptor of %s has a gap", name);
        for (size_t k = 0; k < i; k++)
            assert_ptr_not_equal(shape, shapes[k]);
    }
}

/* ---- Kernels ------------------------------------------------------------- */

static void check_routines(const struct object *program,
                           const struct shape_kernels *kernels, bool historical)
{
    const char *const names[] = { kernels->kernel,     kernels->normal,
                                  kernels->solid,      kernels->state,
                                  kernels->historical, kernels->historical_normal };
    assert_true(kernels->kernel && kernels->normal);
    for (size_t i = 0; i < (historical ? COUNT(names) : 4); i++)
        FAIL_IF(names[i] && !object_symbol(program, names[i]),
                "%s is no routine of the kernels", names[i]);
}

static void check_program(const char *kernel, bool historical)
{
    struct asm_define defines[4 + PRIMITIVE_KINDS + 1] = {
        { "QUEUE", 100 },
        { "BLOB_PIECES", 4 },
        { "MESH_CROSSINGS", 1 }, /* all other fields are NULL */
    };
    struct asm_define *next = &defines[3];
    for (size_t i = 0; i < PRIMITIVE_KINDS; i++)
        if (shapes[i]->symbol)
            *next++ = (struct asm_define){ shapes[i]->symbol, 1 };
    if (historical)
        *next = (struct asm_define){ "HISTORICAL", 1 };
    SCOPED(object) *program = NON_NULL(program_assemble(kernel, defines, &failure));
    for (size_t i = 0; i < PRIMITIVE_KINDS; i++) {
        const struct shape *shape = shapes[i];
        check_routines(program, &shape->kernels, historical);
        if (shape->is_other)
            check_routines(program, &shape->other, historical);
    }
}

TEST(kernels)
{
    for (int historical = 0; historical < 2; historical++) {
        check_program("frame/frame_scalar.s", historical);
        check_program("frame/frame_vector.s", historical);
    }
    check_program("frame/frame_1984.s", false);
}

/* ---- Scenes and the plain tracer ----------------------------------------- */

/* For each kind: its number, the crossings with lines, and the interior points. */
static struct {
    size_t count, crossings, inside;
} found[PRIMITIVE_KINDS];

static bool is_on_quadric(const struct primitive *primitive, const double point[3])
{
    const double at[4] = { point[0], point[1], point[2], 1 };
    double matrix[4][4] = { { 0 } }, sum = 0, size = 0;
    shape_of(primitive)->quadric(primitive, matrix);
    for (int i = 0; i < 16; i++) {
        double term = at[i / 4] * matrix[i / 4][i % 4] * at[i % 4];
        sum += term;
        size += fabs(term);
    }
    return fabs(sum) <= 1e-9 * size;
}

static bool is_in_face(const struct face *face, const double point[3])
{
    double margin = 1e-7 * (1 + greatest(point));
    for (int i = 0; i < 3; i++)
        if (point[i] < face->low[i] - margin || point[i] > face->high[i] + margin)
            return false;
    return face->sort == FACE_FLAT
               ? fabs(dot(face->plane, point) - face->plane[3]) <= margin
           : face->sort == FACE_QUADRIC ? is_on_quadric(face->primitive, point)
                                        : true;
}

/* Fails unless a crossing is in the bound and in one of the faces. */
static void check_crossing(const struct primitive *primitive, const struct bound *bound,
                           const struct face_list *faces, const struct ray *ray,
                           double distance)
{
    const char *name = primitive_kind_name(primitive->kind);
    double point[3];
    bool there = faces->count == 0;
    point_on(ray, distance, point);
    transform_point(&primitive->to_world, point);
    for (int i = 0; i < 3; i++)
        FAIL_IF(point[i] < bound->low[i] || point[i] > bound->high[i],
                "a %s has a crossing outside of its bound", name);
    for (size_t i = 0; i < faces->count && !there; i++)
        there = is_in_face(&faces->faces[i], point);
    FAIL_IF(!there, "a %s has a crossing that is in none of its faces", name);
}

/* Tests lines through a primitive's bound, and points inside it. */
static void look_through(const struct primitive *primitive,
                         const struct face_list *faces)
{
    struct bound limit;
    bound_primitive(primitive, &limit);
    struct bound bound = limit;
    if (bound_is_none(&bound))
        bound = (struct bound){ .radius = 3 };
    for (int try = 0; try < 200; try++) {
        struct crossing crossings[MAX_CROSSINGS];
        struct ray ray;
        double point[3];
        for (int i = 0; i < 3; i++) {
            ray.direction[i] = between(-1, 1);
            point[i] = bound.center[i] + bound.radius * between(-1, 1);
        }
        transform_point(&primitive->to_local, point);
        copy(ray.origin, point);
        size_t count = plain_crossings(primitive, &ray, crossings);
        for (size_t i = 0; i < count; i++)
            check_crossing(primitive, &limit, faces, &ray, crossings[i].distance);
        found[primitive->kind].crossings += count;
        found[primitive->kind].inside += plain_encloses(primitive, point);
    }
}

static void look_at_scene(const char *path)
{
    SCOPED_VALUE(diagnostics) reports = { 0 };
    SCOPED(scene) *scene = scene_read(path, &with_images, &reports);
    FAIL_IF(!scene, "%s is not read", path);
    for (size_t i = 0; i < scene->region_count; i++) {
        const struct region *region = &scene->regions[i];
        struct face_list faces = { 0 };
        if (region->primitive_count == 1)
            opaque_faces_add(&faces, scene, i);
        for (size_t k = 0; k < region->primitive_count; k++) {
            const struct primitive
                *primitive = &scene->primitives[region->first_primitive + k];
            if (found[primitive->kind].count++ < 20)
                look_through(primitive, &faces);
        }
        free(faces.faces);
    }
}

TEST(scenes)
{
    each_file("tests/scenes/*.pov", look_at_scene);
    for (size_t i = 0; i < PRIMITIVE_KINDS; i++) {
        const char *name = primitive_kind_name((enum primitive_kind)i);
        FAIL_IF(found[i].count == 0, "no scene of the tests has a %s", name);
        FAIL_IF(found[i].crossings == 0, "the plain tracer finds no %s", name);
        FAIL_IF(shapes[i]->kernels.segments > 0 && found[i].inside == 0,
                "the plain tracer finds nothing inside of a %s", name);
    }
}
