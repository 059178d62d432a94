/* object_file.h - writes assembled programs to object files, and reads them.
 *
 * An object file is text with one fact in each line. The first line has the version:
 *
 *   c205-object 1
 *   entry 400000                      addresses and words in hex
 *   warm                              if all pages are in memory at the start
 *   segment 400000 2                  length in words, then the words
 *   3E01000509000000
 *   0000000000000000
 *   zeros 800000 1000
 *   region 400000 400040 name
 *   label 400000 name                 also: integer, word
 *   expect register 10 0 1 36 file    register, address, count, line
 *   0000000000000005                  then the words
 *   within FFB5440000000000           then the tolerance, if there is one
 *   text bad-descriptor               or a text
 *   end
 *
 * The reader returns an object, or an error that names the line, for any input.
 */
#ifndef ASM_OBJECT_FILE_H
#define ASM_OBJECT_FILE_H

#include "asm/object/object.h"

/* Writes the whole file, or leaves the old file unchanged. */
bool object_save(const struct object *object, const char *path, c205_error *error);

void object_write(const struct object *object, const struct sink *sink);
struct object *object_read(const char *text, size_t length, c205_error *error);
/* Checks that a program contains at least one instruction. If not, sets the error. */
bool object_check(const struct object *object, c205_error *error);
/* Returns true if a text begins like an object file. */
bool object_recognise(const char *text, size_t length);

#endif
