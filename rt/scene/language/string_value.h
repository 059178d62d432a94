/* string_value.h - parses and evaluates string expressions.
 *
 * A string has up to STRING_LONGEST bytes. In the text it is quoted and has escapes as
 * in C; \uXXXX becomes UTF-8. The caller frees a string. After the last token of a
 * string, string_read advances with reader_pass, because a directive may end there.
 */
#ifndef RT_SCENE_STRING_VALUE_H
#define RT_SCENE_STRING_VALUE_H

#include "rt/scene/language/reader.h"

enum { STRING_LONGEST = 4096 };

bool is_string_word(const struct scene_token *token);
bool starts_string(const struct reader *reader);
bool string_read(struct reader *reader, char **string);
/* Reads the name of a file. As in POV-Ray, it has no escapes if it is quoted. */
bool file_name_read(struct reader *reader, char **name);
/* Decodes the quoted text of a token. */
bool quoted_read(struct reader *reader, const struct scene_token *token, char **string);
/* Reads a string that is followed by more of the same expression, so that it cannot end
 * a directive. */
bool string_read_within(struct reader *reader, char **string);

#endif
