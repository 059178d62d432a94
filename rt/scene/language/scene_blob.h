/* scene_blob.h - reads a blob: one primitive of many components. */
#ifndef RT_SCENE_BLOB_H
#define RT_SCENE_BLOB_H

#include "rt/scene/language/scene_statement.h"

/* Reads the whole block. */
bool blob_read(struct reader *reader, struct scene_object *object,
               const struct item *item);

#endif
