/* random_mesh.c - builds random triangle meshes for the tests of meshes. */
#include "random_mesh.h"

#include "tests/unit/plain_surface.h"
#include "tests/unit/traced_frame.h"

size_t net_point(struct net *net, const double point[3])
{
    size_t i = 0;
    while (i < net->point_count
           && memcmp(net->points[i], point, sizeof *net->points) != 0)
        i++;
    assert_true(i < NET_POINTS);
    copy(net->points[i], point);
    net->point_count += i == net->point_count;
    return i;
}

void net_face(struct net *net, size_t a, size_t b, size_t c)
{
    size_t *face = net->faces[net->face_count++];
    assert_true(net->face_count <= NET_FACES);
    face[0] = a;
    face[1] = b;
    face[2] = c;
}

static void clear(struct net *net)
{
    net->point_count = net->face_count = 0;
    net->smooth = false;
    net->directions = NULL;
}

/* ---- Bodies -------------------------------------------------------------- */

static bool are_apart(const struct net *net, size_t a, size_t b, double distance)
{
    double way[3];
    add_scaled(way, net->points[a], -1, net->points[b]);
    return fabs(sqrt(dot(way, way)) - distance) < 1e-9;
}

/* Adds a face for each set of three points whose distances are all `apart`. */
static void join_neighbours(struct net *net, double apart)
{
    for (size_t a = 0; a < net->point_count; a++)
        for (size_t b = a + 1; b < net->point_count; b++)
            for (size_t c = b + 1; c < net->point_count; c++)
                if (are_apart(net, a, b, apart) && are_apart(net, b, c, apart)
                    && are_apart(net, c, a, apart))
                    net_face(net, a, b, c);
}

static void take_octahedron(struct net *net)
{
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double point[3] = { 0, 0, 0 };
            point[axis] = sign;
            net_point(net, point);
        }
    join_neighbours(net, sqrt(2));
}

static void take_icosahedron(struct net *net)
{
    double golden = (1 + sqrt(5)) / 2;
    for (int axis = 0; axis < 3; axis++)
        for (int signs = 0; signs < 4; signs++) {
            double point[3] = { 0, 0, 0 };
            point[axis] = signs & 1 ? 1 : -1;
            point[(axis + 1) % 3] = signs & 2 ? golden : -golden;
            net_point(net, point);
        }
    join_neighbours(net, 2);
}

static void add_square(struct net *net, const size_t corners[4], bool other)
{
    net_face(net, corners[0], corners[1], corners[2 + other]);
    net_face(net, corners[2], corners[3], corners[other ? 1 : 0]);
}

/* Adds a point of one side of a cube, given its offset in squares from a corner. */
static size_t point_of_side(struct net *net, int axis, double at, double across,
                            double along)
{
    double point[3];
    point[axis] = at;
    point[(axis + 1) % 3] = across - fabs(at);
    point[(axis + 2) % 3] = along - fabs(at);
    return net_point(net, point);
}

static void add_side(struct net *net, int axis, double at, size_t squares,
                     uint64_t *random)
{
    double step = 2 * fabs(at) / (double)squares;
    for (size_t i = 0; i < squares; i++)
        for (size_t j = 0; j < squares; j++) {
            size_t corners[4];
            for (size_t k = 0; k < 4; k++)
                corners[k] = point_of_side(net, axis, at,
                                           step * (double)(i + (k == 1 || k == 2)),
                                           step * (double)(j + k / 2));
            add_square(net, corners, random && xorshift(random) % 2);
        }
}

void net_cube(struct net *net, double half, size_t squares, uint64_t *random)
{
    clear(net);
    for (int axis = 0; axis < 3; axis++) {
        add_side(net, axis, -half, squares, random);
        add_side(net, axis, half, squares, random);
    }
}

void net_take(struct net *net, enum net_body body)
{
    clear(net);
    switch (body) {
    case BOX: net_cube(net, 1, 1, NULL); break;
    case ICOSAHEDRON: take_icosahedron(net); break;
    default: take_octahedron(net); break;
    }
}

/* ---- Open surfaces ------------------------------------------------------- */

void net_sheet(struct net *net, size_t squares, double height, uint64_t *random)
{
    clear(net);
    add_side(net, 1, 1, squares, random);
    for (size_t i = 0; i < net->point_count; i++)
        net->points[i][1] = number_between(random, -height, height);
}

void net_fan(struct net *net, size_t blades, double around, double height)
{
    double middle[3] = { 0, height, 0 };
    clear(net);
    net_point(net, middle);
    for (size_t i = 0; i <= blades; i++) {
        double turn = 2 * PI * around * (double)i / (double)blades;
        double point[3] = { cos(turn), 0, sin(turn) };
        size_t at = net_point(net, point);
        if (i > 0)
            net_face(net, 0, at - 1, at);
    }
}

static void add_apart(struct net *net, bool slender, uint64_t *random)
{
    double corners[3][3], middle[3];
    random_direction(random, middle);
    for (int k = 0; k < 3; k++) {
        random_direction(random, corners[k]);
        add_scaled(corners[k], middle, .7, corners[k]);
    }
    if (slender)
        for (int i = 0; i < 3; i++)
            corners[2][i] = corners[1][i] + number_between(random, 0, .01);
    net_face(net, net_point(net, corners[0]), net_point(net, corners[1]),
             net_point(net, corners[2]));
}

void net_soup(struct net *net, size_t count, bool slender, uint64_t *random)
{
    clear(net);
    for (size_t i = 0; i < count; i++)
        add_apart(net, slender, random);
}

/* ---- Changes ------------------------------------------------------------- */

/* Returns the midpoint of an edge. Both directions of the edge give the same bits. */
static size_t middle_of(struct net *net, size_t a, size_t b)
{
    double middle[3];
    for (int i = 0; i < 3; i++)
        middle[i] = (net->points[a][i] + net->points[b][i]) / 2;
    return net_point(net, middle);
}

void net_divide(struct net *net)
{
    size_t count = net->face_count;
    for (size_t i = 0; i < count; i++) {
        size_t *face = net->faces[i];
        size_t a = face[0], b = face[1], c = face[2];
        size_t ab = middle_of(net, a, b), bc = middle_of(net, b, c);
        size_t ca = middle_of(net, c, a);
        net_face(net, a, ab, ca);
        net_face(net, ab, b, bc);
        net_face(net, ca, bc, c);
        face[0] = ab;
        face[1] = bc;
        face[2] = ca;
    }
}

void net_stretch(struct net *net, double low, double high, double grain,
                 uint64_t *random)
{
    for (size_t i = 0; i < net->point_count; i++) {
        double factor = number_between(random, low, high);
        if (grain != 0)
            factor = grain * round(factor / grain);
        scale_by(net->points[i], factor);
    }
}

void net_random_body(struct net *net, size_t times, uint64_t *random)
{
    net_take(net, (enum net_body)(xorshift(random) % NET_BODIES));
    for (size_t i = 0; i < times; i++)
        net_divide(net);
    net_stretch(net, .7, 1.2, xorshift(random) % 2 ? .0625 : 0, random);
}

void net_round(struct net *net, double grain)
{
    for (size_t i = 0; i < net->point_count; i++)
        for (int k = 0; k < 3; k++)
            net->points[i][k] = grain * round(net->points[i][k] / grain);
}

void net_move(struct net *net, double scale, const double by[3])
{
    for (size_t i = 0; i < net->point_count; i++)
        add_scaled(net->points[i], by, scale, net->points[i]);
}

static void exchange(size_t *a, size_t *b)
{
    size_t kept = *a;
    *a = *b;
    *b = kept;
}

void net_shuffle(struct net *net, uint64_t *random)
{
    for (size_t i = net->face_count; i > 0; i--) {
        size_t *face = net->faces[i - 1];
        size_t *other = net->faces[xorshift(random) % i];
        for (size_t k = 0; k < 3; k++)
            exchange(&face[k], &other[k]);
        exchange(&face[0], &face[xorshift(random) % 3]);
    }
}

static void face_normal(const struct net *net, const size_t face[3], double normal[3])
{
    double edges[2][3];
    for (int k = 0; k < 2; k++)
        add_scaled(edges[k], net->points[face[1 + k]], -1, net->points[face[0]]);
    cross_product(edges[0], edges[1], normal);
}

/* Adds normals that point away from the origin, for either orientation of faces. */
static void add_normals(struct net *net)
{
    memset(net->normals, 0, sizeof net->normals);
    for (size_t i = 0; i < net->face_count; i++) {
        const size_t *face = net->faces[i];
        double normal[3];
        face_normal(net, face, normal);
        if (dot(normal, net->points[face[0]]) < 0)
            scale_by(normal, -1);
        for (int k = 0; k < 3; k++)
            add_scaled(net->normals[face[k]], net->normals[face[k]], 1, normal);
    }
}

void net_smooth(struct net *net, double lean, uint64_t *random)
{
    add_normals(net);
    for (size_t i = 0; i < net->point_count; i++) {
        double by[3];
        random_direction(random, by);
        normalise(net->normals[i]);
        add_scaled(net->normals[i], net->normals[i], lean, by);
    }
    net->smooth = true;
}

/* ---- Texts and primitives ------------------------------------------------ */

static void add_vector(char *text, size_t size, const double vector[3],
                       const char *behind)
{
    add_text(text, size, "<%.17g,%.17g,%.17g>%s", vector[0], vector[1], vector[2],
             behind);
}

static const size_t (*normals_of(const struct net *net))[3]
{
    return net->directions ? net->directions : net->faces;
}

void net_triangles_text(const struct net *net, const char *object, char *text,
                        size_t size)
{
    add_text(text, size, "%s { ", object);
    for (size_t i = 0; i < net->face_count; i++) {
        add_text(text, size, net->smooth ? "smooth_triangle {" : "triangle {");
        for (int k = 0; k < 3; k++) {
            size_t at = net->faces[i][k];
            const char *behind = k < 2 ? ", " : "}\n";
            add_vector(text, size, net->points[at], net->smooth ? ", " : behind);
            if (net->smooth)
                add_vector(text, size, net->normals[normals_of(net)[i][k]], behind);
        }
    }
    assert_true(strlen(text) < size - 1);
}

void net_mesh_text(const struct net *net, char *text, size_t size)
{
    net_triangles_text(net, "mesh", text, size);
}

static void add_vectors(char *text, size_t size, const char *word,
                        const double (*vectors)[3], size_t count)
{
    add_text(text, size, "%s { %zu", word, count);
    for (size_t i = 0; i < count; i++) {
        add_text(text, size, ", ");
        add_vector(text, size, vectors[i], "");
    }
    add_text(text, size, "}\n");
}

static void add_indices(char *text, size_t size, const char *word,
                        const size_t (*indices)[3], size_t count)
{
    add_text(text, size, "%s { %zu", word, count);
    for (size_t i = 0; i < count; i++)
        add_text(text, size, ", <%zu,%zu,%zu>", indices[i][0], indices[i][1],
                 indices[i][2]);
    add_text(text, size, "}\n");
}

void net_mesh2_text(const struct net *net, char *text, size_t size)
{
    add_text(text, size, "mesh2 { ");
    add_vectors(text, size, "vertex_vectors", net->points, net->point_count);
    if (net->smooth)
        add_vectors(text, size, "normal_vectors", net->normals, net->point_count);
    add_indices(text, size, "face_indices", net->faces, net->face_count);
    if (net->smooth && net->directions)
        add_indices(text, size, "normal_indices", net->directions, net->face_count);
    assert_true(strlen(text) < size - 1);
}

void net_text(const struct net *net, char *text, size_t size, uint64_t *random)
{
    if (xorshift(random) % 2)
        net_mesh_text(net, text, size);
    else
        net_mesh2_text(net, text, size);
}

void net_primitive(const struct net *net, struct primitive *primitive)
{
    struct triangles *triangles = &primitive->shape.mesh.triangles;
    memset(primitive, 0, sizeof *primitive);
    primitive->kind = PRIMITIVE_MESH;
    triangles->count = net->face_count;
    triangles->list = NON_NULL(calloc(net->face_count, sizeof *triangles->list));
    for (size_t i = 0; i < net->face_count; i++)
        for (int k = 0; k < 3; k++) {
            size_t at = net->faces[i][k];
            triangles->list[i].smooth = net->smooth;
            copy(triangles->list[i].corners[k], net->points[at]);
            copy(triangles->list[i].normals[k], net->normals[at]);
        }
}
