/* mesh.h - a mesh while it is read: its triangles, and how they look. */
#ifndef RT_SCENE_MESH_H
#define RT_SCENE_MESH_H

#include "rt/scene/language/statement.h"

struct mesh_reading {
    struct scene_object object; /* first: what the modifiers are given */
    struct scene_token at;      /* its word */
    bool lone;                  /* triangle or smooth_triangle */
    struct triangles triangles; /* of array_grow, up to the end */

    /* The textures of triangles; the first is that of the object's part. */
    struct scene_token look_at; /* the first one's place */
    size_t looks;               /* triangles that have one */
    bool looked;                /* .. the one that is read has */
    bool differ;                /* not all of them are the same */
};

/* An object of one part, without triangles. */
bool mesh_begin(struct reader *reader, struct mesh_reading *mesh,
                const struct item *item);
/* What was read, if it is good, becomes the object; all else is freed. */
bool mesh_end(struct reader *reader, struct mesh_reading *mesh, bool good,
              struct scene_object *object);

/* Those of all its meshes. */
size_t mesh_triangles(const struct scene_object *object);
/* So many more triangles, within the bound of MAX_TRIANGLES. */
bool mesh_count(struct reader *reader, size_t more, const struct scene_token *at);
bool mesh_add(struct reader *reader, struct mesh_reading *mesh,
              const struct triangle *triangle, const struct scene_token *at);
/* The texture of a triangle. */
void mesh_look(struct mesh_reading *mesh, const struct texture *texture,
               const struct scene_token *at);
/* A normal of a mesh gets the length one. */
void mesh_direct(struct reader *reader, const struct scene_token *at, double normal[3]);
/* Whether a triangle with such normals is smooth. */
bool mesh_is_smooth(const struct triangle *triangle);
/* '}' and before it nothing more. */
bool mesh_close(struct reader *reader, const struct block *block, bool good);

/* Vectors that change nothing here. */
bool mesh_pass_vectors(struct reader *reader, int count);
item_reader read_inside_vector;

/* The block of mesh2. */
bool mesh2_read(struct reader *reader, struct scene_object *object,
                const struct item *item);
#endif
