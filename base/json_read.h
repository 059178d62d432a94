/* json_read.h - reads JSON (RFC 8259) strictly into a tree.
 *
 * Texts in the tree are UTF-8 and end with a NUL, which no text may contain. If a key
 * occurs more than once in an object, the first member counts. Any input gives a tree
 * or an error.
 */
#ifndef BASE_JSON_READ_H
#define BASE_JSON_READ_H

#include "base/arena.h"
#include "vm/c205.h"

enum json_kind {
    JSON_NULL,
    JSON_TRUTH,
    JSON_NUMBER,
    JSON_TEXT,
    JSON_ARRAY,
    JSON_OBJECT
};

struct json_value {
    enum json_kind kind;
    bool truth;
    double number;
    const char *text;
    const char *key;                /* of a member of an object, or NULL */
    const struct json_value *first; /* of an array or object; NULL: it is empty */
    const struct json_value *next;  /* in the same array or object; NULL: the last */
};

/* The maximum depth of nested arrays and objects. */
#define JSON_DEEPEST 64

/* Returns a tree in the arena. NULL: the error has the reason and the byte offset. */
const struct json_value *json_read(struct arena *arena, const char *text, size_t length,
                                   c205_error *error);

/* NULL: no such member, it is null, or object is NULL or not an object. */
const struct json_value *json_member(const struct json_value *object, const char *key);
/* NULL: no such member, or it is not a text. */
const char *json_member_text(const struct json_value *object, const char *key);
/* Returns the first element or member of a member. */
const struct json_value *json_member_first(const struct json_value *object,
                                           const char *key);
/* Returns the number of elements of an array, or members of an object. */
size_t json_length(const struct json_value *value);
bool json_member_truth(const struct json_value *object, const char *key,
                       bool otherwise);
/* Sets *value to a member if it exists. Returns false and leaves *value unchanged if
 * the member exists and is not an integer of magnitude below 2^53. */
bool json_member_whole(const struct json_value *object, const char *key,
                       int64_t *value);

#endif
