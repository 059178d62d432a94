/* random_mesh.h - triangle meshes for tests: closed bodies about the origin, sheets and
 * fans. They are written as texts of the scene language, or made as primitives.
 * Triangles share points, so that common corners have the same bits. */
#ifndef TESTS_RANDOM_MESH_H
#define TESTS_RANDOM_MESH_H

#include "rt/shapes/primitive.h"

#include <stddef.h>
#include <stdint.h>

enum { NET_POINTS = 2200, NET_FACES = 1600 };

struct net {
    size_t point_count, face_count;
    double points[NET_POINTS][3];
    double normals[NET_POINTS][3]; /* for smooth meshes */
    size_t faces[NET_FACES][3];
    bool smooth;
    const size_t (*directions)[3]; /* indices of each face's normals; NULL: the normals
                                    * of its points */
};

/* Returns the index of a point, and adds the point if it is new. */
size_t net_point(struct net *net, const double point[3]);
void net_face(struct net *net, size_t a, size_t b, size_t c);

/* Makes a closed body. Only the icosahedron has non-integer coordinates. */
enum net_body { OCTAHEDRON, BOX, ICOSAHEDRON, NET_BODIES };
void net_take(struct net *net, enum net_body body);
/* Makes a cube from -half to half with squares x squares squares on each face. A random
 * diagonal divides each square. */
void net_cube(struct net *net, double half, size_t squares, uint64_t *random);
/* Makes a height field over x and z from -1 to 1, within -height to height. */
void net_sheet(struct net *net, size_t squares, double height, uint64_t *random);
/* Makes triangles around the first point over the fraction `around` of a circle. */
void net_fan(struct net *net, size_t blades, double around, double height);
/* Makes separate triangles. In slender triangles two corners nearly coincide. */
void net_soup(struct net *net, size_t count, bool slender, uint64_t *random);

/* Divides each face into four triangles. */
void net_divide(struct net *net);
/* Scales each point by a random factor, a multiple of `grain` unless this is 0. */
void net_stretch(struct net *net, double low, double high, double grain,
                 uint64_t *random);
/* Rounds coordinates to multiples of `grain`. */
void net_round(struct net *net, double grain);
void net_move(struct net *net, double scale, const double by[3]);
/* Makes a body, divides its faces `times` times and moves its points. The result is
 * star-shaped about the origin. All points are at least 1/4 from it. */
void net_random_body(struct net *net, size_t times, uint64_t *random);
/* Shuffles the faces, and the corners of each face. */
void net_shuffle(struct net *net, uint64_t *random);
/* Adds normals at the points: the mean of adjacent faces, tilted at random. */
void net_smooth(struct net *net, double lean, uint64_t *random);

/* Write the mesh as text up to the modifiers. net_triangles_text writes the triangles
 * in any object, such as a union. The others write "mesh { .." and "mesh2 { ..". */
void net_triangles_text(const struct net *net, const char *object, char *text,
                        size_t size);
void net_mesh_text(const struct net *net, char *text, size_t size);
void net_mesh2_text(const struct net *net, char *text, size_t size);
/* Writes the mesh in one of the forms, at random. */
void net_text(const struct net *net, char *text, size_t size, uint64_t *random);
/* Makes a primitive. The caller frees the list of its triangles. */
void net_primitive(const struct net *net, struct primitive *primitive);

#endif
