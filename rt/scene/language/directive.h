/* directive.h - executes the directives, which are words after '#'. */
#ifndef RT_SCENE_DIRECTIVE_H
#define RT_SCENE_DIRECTIVE_H

#include "rt/scene/language/scene_block.h"

/* Executes the directive at the current token, which is a TOKEN_DIRECTIVE. Uses
 * reader_step to advance past the last token of the directive. */
bool directive_read(struct reader *reader);

/* These functions execute #fopen, #read, #write, #fclose and #macro. */
item_reader data_file_open, data_file_read, data_file_write, data_file_close;
item_reader macro_define;
/* Calls the macro that the current token names. The body of the macro is read next. */
bool macro_call(struct reader *reader);

#endif
