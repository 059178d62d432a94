/* object.h - assembled programs as files.
 *
 * An object file is text, one fact a line, with a version in its first line:
 *
 *   c205-object 1
 *   entry 400000                      addresses and words in hex
 *   warm                              if it begins so
 *   segment 400000 2                  length in words, then the words
 *   3E01000509000000
 *   0000000000000000
 *   zeros 800000 1000
 *   region 400000 400040 name
 *   label 400000 name                 also: integer, word
 *   expect register 10 0 1 36 file    register, address, count, line
 *   0000000000000005                  then the words, ..
 *   within FFB5440000000000           .. how far they may be off, if at all ..
 *   text bad-descriptor               .. or a text
 *   end
 *
 * Reading trusts nothing: whatever the bytes, the result is an object or an
 * error that names the line.
 */
#ifndef ASM_OBJECT_H
#define ASM_OBJECT_H

#include "asm/assemble.h"

/* Written whole or not at all. */
bool object_save(const struct object *object, const char *path, c205_error *error);
struct object *object_load(const char *path, c205_error *error);

void object_write(const struct object *object, const struct sink *sink);
struct object *object_read(const char *text, size_t length, c205_error *error);
/* Whether a program can begin.  False: it is empty. */
bool object_check(const struct object *object, c205_error *error);
/* Whether a text begins as object files do. */
bool object_recognise(const char *text, size_t length);

#endif
