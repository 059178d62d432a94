/* bicubic_patch.h - patches, which become meshes in the world. */
#ifndef RT_SCENE_BICUBIC_PATCH_H
#define RT_SCENE_BICUBIC_PATCH_H

#include "rt/scene/language/object.h"
#include "rt/scene/language/reader.h"

/* The arguments of bicubic_patch, behind its '{'. */
bool bicubic_patch_read(struct reader *reader, struct scene_object *object,
                        const struct scene_token *at);
/* The part, which has a patch, gets its triangles; no transform is left. */
bool bicubic_patch_cut(struct reader *reader, struct scene_part *part,
                       const struct scene_token *at);

#endif
