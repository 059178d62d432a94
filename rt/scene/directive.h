/* directive.h - #declare, #local, #undef, #include, #version, #default. */
#ifndef RT_SCENE_DIRECTIVE_H
#define RT_SCENE_DIRECTIVE_H

#include "rt/scene/reader.h"

/* The next token is TOKEN_DIRECTIVE. */
bool directive_read(struct reader *reader);

#endif
