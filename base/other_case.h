/* other_case.h - finds files whose paths differ from a given path only in the case of
 * ASCII letters. Texts from systems that ignore case need this.
 */
#ifndef BASE_OTHER_CASE_H
#define BASE_OTHER_CASE_H

#include "base/folder.h"

/* Finds the files whose paths equal `path` except for the case of letters, sorted.
 * Names of folders may differ, too. The first `fixed` bytes of the path must be equal;
 * they are empty or end with a '/'. The caller frees the paths with folder_free.
 * Returns false if the host is out of memory. */
bool other_case_find(struct folder *found, const char *path, size_t fixed);
bool other_case_is(const char *a, const char *b, size_t length);

#endif
