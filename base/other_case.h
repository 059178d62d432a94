/* other_case.h - finds files whose paths differ from a given one only in the case of
 * ASCII letters, for texts from systems that ignore case.
 */
#ifndef BASE_OTHER_CASE_H
#define BASE_OTHER_CASE_H

#include "base/folder.h"

/* Finds the paths of all such files, sorted. Folders may differ in case too, but not
 * the first `fixed` bytes of the path, which end with a '/' if there are any. The
 * caller frees the names with folder_free. Returns false if memory is exhausted. */
bool other_case_find(struct folder *found, const char *path, size_t fixed);
bool other_case_is(const char *a, const char *b, size_t length);

#endif
