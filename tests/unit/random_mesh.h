/* random_mesh.h - nets of triangles, which tests of meshes are made of: closed bodies
 * about the origin, sheets and fans; as texts of the scene language, and as
 * primitives.  Points are shared: what meets in one has its bits. */
#ifndef TESTS_RANDOM_MESH_H
#define TESTS_RANDOM_MESH_H

#include "rt/shapes/primitive.h"

#include <stddef.h>
#include <stdint.h>

enum { NET_POINTS = 2200, NET_FACES = 1600 };

struct net {
    size_t point_count, face_count;
    double points[NET_POINTS][3];
    double normals[NET_POINTS][3]; /* of a smooth one */
    size_t faces[NET_FACES][3];
    bool smooth;
};

/* The number of a point: of one that is there, or a new one. */
size_t net_point(struct net *net, const double point[3]);
void net_face(struct net *net, size_t a, size_t b, size_t c);

/* Bodies, which they set up again; their points lie on whole numbers but those
 * of the icosahedron. */
enum net_body { OCTAHEDRON, BOX, ICOSAHEDRON, NET_BODIES };
void net_take(struct net *net, enum net_body body);
/* From -half to half, so many squares across each face, cut by either
 * diagonal. */
void net_cube(struct net *net, double half, size_t squares, uint64_t *random);
/* z is a height, between -height and height, over x and z from -1 to 1. */
void net_sheet(struct net *net, size_t squares, double height, uint64_t *random);
/* Round the first point; around is how much of the whole circle. */
void net_fan(struct net *net, size_t blades, double around, double height);
/* Apart from each other; slender ones have two corners as good as one. */
void net_soup(struct net *net, size_t count, bool slender, uint64_t *random);

/* Each face becomes four. */
void net_divide(struct net *net);
/* Each point goes along the line from the origin, by a factor of so many
 * grains, if grain is not 0. */
void net_stretch(struct net *net, double low, double high, double grain,
                 uint64_t *random);
/* To multiples of a grain. */
void net_round(struct net *net, double grain);
void net_move(struct net *net, double scale, const double by[3]);
/* One of them, its faces made four so many times, its points moved: from its
 * middle it is seen as a whole, and nothing is nearer than 1/4. */
void net_random_body(struct net *net, size_t times, uint64_t *random);
/* The faces in another order, their corners too. */
void net_shuffle(struct net *net, uint64_t *random);
/* Normals at its points: the mean of those of the faces there, and they lean
 * at random. */
void net_smooth(struct net *net, double lean, uint64_t *random);

/* Up to the modifiers: "mesh { .." or "mesh2 { ..". */
void net_mesh_text(const struct net *net, char *text, size_t size);
void net_mesh2_text(const struct net *net, char *text, size_t size);
/* Either. */
void net_text(const struct net *net, char *text, size_t size, uint64_t *random);
/* The caller frees the triangles' list. */
void net_primitive(const struct net *net, struct primitive *primitive);

#endif
