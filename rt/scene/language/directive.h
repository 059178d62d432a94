/* directive.h - the directives: words after '#'. */
#ifndef RT_SCENE_DIRECTIVE_H
#define RT_SCENE_DIRECTIVE_H

#include "rt/scene/language/reader.h"

/* The token is TOKEN_DIRECTIVE; what is behind it is left by reader_step. */
bool directive_read(struct reader *reader);

#endif
