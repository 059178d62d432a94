/* bicubic_patch.h - bicubic patches, which become meshes in the world. */
#ifndef RT_SCENE_BICUBIC_PATCH_H
#define RT_SCENE_BICUBIC_PATCH_H

#include "rt/scene/language/scene_object.h"
#include "rt/scene/language/reader.h"

/* Reads the arguments of bicubic_patch, after its '{'. */
bool bicubic_patch_read(struct reader *reader, struct scene_object *object,
                        const struct scene_token *at);
/* Tessellates the patch of a part. The part then has no transform left. */
bool bicubic_patch_cut(struct reader *reader, struct scene_part *part,
                       const struct scene_token *at);

#endif
