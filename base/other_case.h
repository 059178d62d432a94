/* other_case.h - files whose paths differ from a given one in the case of ASCII
 * letters alone, as in texts that were made where case does not count.
 */
#ifndef BASE_OTHER_CASE_H
#define BASE_OTHER_CASE_H

#include "base/folder.h"

/* The paths of all such files, sorted; folders may differ in case as well, but
 * not the first `fixed` bytes of the path, which end with a '/' if there are
 * any.  The names are freed with folder_free; false: no memory. */
bool other_case_find(struct folder *found, const char *path, size_t fixed);
bool other_case_is(const char *a, const char *b, size_t length);

#endif
