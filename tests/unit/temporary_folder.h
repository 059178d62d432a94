/* temporary_folder.h - a folder for a test's files, named with blanks and quotes. */
#ifndef TESTS_TEMPORARY_FOLDER_H
#define TESTS_TEMPORARY_FOLDER_H

#include "tests/unit/unit.h"

extern char temporary_folder[64];

/* Fixtures. remove_folder fails if the folder still has files. */
int make_folder(void **state);
int remove_folder(void **state);
#undef FILE_FIXTURES
#define FILE_FIXTURES make_folder, remove_folder

/* Returns the path of a file in the folder. The path is valid until the next call. */
const char *in_folder(const char *name);
/* Removes the files of the folder. Returns their number. */
size_t empty_folder(void);
/* Write and read a file in the folder. The caller frees the text. */
void write_file(const char *name, const char *text);
char *text_of_file(const char *name);

#endif
