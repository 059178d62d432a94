/* string_value.h - strings and what makes them.
 *
 * Strings are bytes, at most STRING_LONGEST.  In the text they are quoted and
 * have escapes as in C; \uXXXX becomes UTF-8.  A string that is read is the
 * caller's to free; its last token is left by reader_pass.
 */
#ifndef RT_SCENE_STRING_VALUE_H
#define RT_SCENE_STRING_VALUE_H

#include "rt/scene/language/reader.h"

enum { STRING_LONGEST = 4096 };

bool is_string_word(const struct scene_token *token);
bool starts_string(const struct reader *reader);
bool string_read(struct reader *reader, char **string);
/* The same of a file's name, which has no escapes where it is in quotes,
 * as in POV-Ray. */
bool file_name_read(struct reader *reader, char **name);
/* What is between the quotes of a token. */
bool quoted_read(struct reader *reader, const struct scene_token *token, char **string);
/* The same as a part of something else. */
bool string_read_within(struct reader *reader, char **string);

#endif
