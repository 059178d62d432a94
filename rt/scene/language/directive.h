/* directive.h - the directives: words after '#'. */
#ifndef RT_SCENE_DIRECTIVE_H
#define RT_SCENE_DIRECTIVE_H

#include "rt/scene/language/reader.h"

/* Executes the directive at the current token, which is a TOKEN_DIRECTIVE. Its last
 * token is left with reader_step. */
bool directive_read(struct reader *reader);

#endif
