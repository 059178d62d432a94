/* json_read.h - reads JSON (RFC 8259) strictly into a tree.
 *
 * Texts in the tree are UTF-8 and end with a NUL. A NUL within a text is an error. If
 * an object contains a key more than once, the first member counts. Every input gives a
 * tree or an error.
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
    const char *key;                /* key of a member of an object, or NULL */
    const struct json_value *first; /* first item of an array or object; NULL: it is
                                       empty */
    const struct json_value *next;  /* next item of the same array or object; NULL: the
                                       last */
};

/* The maximum depth of nested arrays and objects. */
#define JSON_DEEPEST 64

/* Returns a tree in the arena. Returns NULL on an error, with the reason and the byte
 * offset. */
const struct json_value *json_read(struct arena *arena, const char *text, size_t length,
                                   c205_error *error);

/* Returns a member. Returns NULL if there is no such member, if its value is null, or
 * if object is NULL or not an object. */
const struct json_value *json_member(const struct json_value *object, const char *key);
/* Returns the text of a member. Returns NULL if there is no such member or it is not a
 * text. */
const char *json_member_text(const struct json_value *object, const char *key);
/* Returns the first item of the array or object in a member, or NULL if there is
 * none. */
const struct json_value *json_member_first(const struct json_value *object,
                                           const char *key);
/* Returns the number of items of an array or object. */
size_t json_length(const struct json_value *value);
bool json_member_truth(const struct json_value *object, const char *key,
                       bool otherwise);
/* Sets *value to a member if it exists. Returns false and leaves *value unchanged if
 * the member exists and is not an integer of magnitude below 2^53. */
bool json_member_whole(const struct json_value *object, const char *key,
                       int64_t *value);

#endif
