/* scene_mesh.h - a mesh while it is read: its triangles and their textures. */
#ifndef RT_SCENE_MESH_H
#define RT_SCENE_MESH_H

#include "rt/scene/language/scene_statement.h"

struct mesh_reading {
    struct scene_object object; /* first member: the subject of the modifiers */
    struct scene_token at;      /* the keyword of the mesh */
    bool lone;                  /* a single triangle or smooth_triangle */
    struct triangles triangles; /* in an array of array_add, until the mesh ends */

    /* The textures of the triangles. The first becomes the texture of the object's
     * part. */
    struct scene_token look_at; /* place of the first texture */
    size_t looks;               /* number of triangles with a texture */
    bool looked;                /* the current triangle has a texture */
    bool differ;                /* the textures are not all equal */
};

/* Starts an object of one part, without triangles. */
bool mesh_begin(struct reader *reader, struct mesh_reading *mesh,
                const struct item *item);
/* Ends a mesh. If `good` is true, the mesh becomes the object. All other storage is
 * freed. */
bool mesh_end(struct reader *reader, struct mesh_reading *mesh, bool good,
              struct scene_object *object);

/* Returns the number of triangles in all meshes of an object. */
size_t mesh_triangles(const struct scene_object *object);
/* Adds `more` to the number of triangles in the scene. Reports an error at `at` if the
 * sum exceeds MAX_TRIANGLES. */
bool mesh_count(struct reader *reader, size_t more, const struct scene_token *at);
/* Counts a triangle and adds it to a list that the scene owns. */
bool mesh_keep_triangle(struct reader *reader, struct triangles *triangles,
                        size_t *capacity, const struct triangle *triangle,
                        const struct scene_token *at);
/* Adds a mesh of these triangles to the object. If no triangle has an area, the mesh is
 * ignored, and `reason` is reported. */
bool mesh_object_add(struct reader *reader, struct scene_object *object,
                     const struct triangles *triangles, const struct scene_token *at,
                     const char *reason);
bool mesh_add(struct reader *reader, struct mesh_reading *mesh,
              const struct triangle *triangle, const struct scene_token *at);
/* Records the texture of a triangle. */
void mesh_look(struct mesh_reading *mesh, const struct texture *texture,
               const struct scene_token *at);
/* Normalises a normal of a mesh. A zero normal is replaced, with a warning. */
void mesh_direct(struct reader *reader, const struct scene_token *at, double normal[3]);
/* Returns true if the three normals of the triangle are not all equal. */
bool mesh_is_smooth(const struct triangle *triangle);
/* Reads the closing '}'. No other token may precede it. */
bool mesh_close(struct reader *reader, const struct block *block, bool good);

item_reader read_inside_vector;

/* Reads the block of mesh2 as one primitive. */
bool mesh2_read(struct reader *reader, struct scene_object *object,
                const struct item *item);
#endif
