/* parts.h - the parts of a scene, what they are made of, and how dense that is.
 *
 * What a statement of the scene's file puts into the world is an object.  Objects of
 * one name, that of the #declare that they come from, and of one material, the name of
 * their texture, are one part; without a name they are called by their line.
 *
 * A part's density is that of its own name, else that of its material, else the one
 * that is for all others; where several of these say one it is the first of: an
 * option, a file of densities, a float of the scene whose name ends in _Density.
 */
#ifndef RT_MASS_PARTS_H
#define RT_MASS_PARTS_H

#include "base/diagnostic.h"
#include "rt/scene/scene.h"
#include "vm/c205.h"

struct mass_part {
    const char *name;
    const char *material; /* NULL: its texture has no name */
    bool mixed;           /* .. it has several textures */
    bool endless;         /* bodies.h finds that */
    bool left_out;        /* nobody asks for it */
    double density;       /* 0: not known */
};

/* A density as somebody gives it. */
struct given_density {
    const char *name;
    double value;
};

struct densities {
    size_t count;
    struct given_density *list; /* the first of a name counts */
    double others;              /* of what has no other; 0: none */
    struct arena kept;
};

struct mass_parts {
    size_t count;
    struct mass_part *list; /* in the order of their first objects */
    size_t *part_of;        /* of each of the scene's objects */
    struct arena kept;
};

/* NAME=VALUE, where the name `default` is all others.  False: it is no such text,
 * or a value that is not above 0; or no memory; the error says which. */
bool densities_add(struct densities *densities, const char *text,
                   c205_error *error);
/* A file of lines: a number, which means nothing, a density, a name; what is behind #
 * is passed over.  False: the reports say what is wrong with it. */
bool densities_read(struct densities *densities, const char *path,
                    struct diagnostics *reports);
/* Those of the scene's floats. */
bool densities_add_scene(struct densities *densities,
                         const struct scene *scene, c205_error *error);
void densities_free(struct densities *densities);

/* The scene must outlive the parts.  False: no memory. */
bool mass_parts_find(const struct scene *scene, struct mass_parts *parts);
void mass_parts_free(struct mass_parts *parts);

/* False: a name that the user gave is not that of a part or a material; the error lists
 * those that there are. */
bool mass_parts_check(const struct mass_parts *parts,
                      const struct densities *densities, size_t given,
                      c205_error *error);
/* These names alone, of parts or materials; without names all but those that are
 * endless.  False: one is not there; the error lists those that are. */
bool mass_parts_choose(struct mass_parts *parts, const char *const *names,
                       size_t count, c205_error *error);
/* False: some that are not left out have none, or are of several materials; the error names them. */
bool mass_parts_weigh(struct mass_parts *parts,
                      const struct densities *densities, c205_error *error);

#endif
