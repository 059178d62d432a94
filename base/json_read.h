/* json_read.h - reading JSON (RFC 8259), strictly: a text to a tree.
 *
 * Texts in it are UTF-8 and end with a NUL, which no text may hold; of members with one
 * key the first counts.  Whatever the bytes, the result is a tree or an error.
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
    const struct json_value *next;  /* in the same one; NULL: this is the last */
};

/* Arrays and objects lie in each other so deep at most. */
#define JSON_DEEPEST 64

/* It lives in the arena.  NULL: the error says what is wrong, and at which byte. */
const struct json_value *json_read(struct arena *arena, const char *text, size_t length,
                                   c205_error *error);

/* NULL: there is none, it is null, or that is no object, as NULL is none. */
const struct json_value *json_member(const struct json_value *object, const char *key);
/* NULL: there is none, or it is another kind of value. */
const char *json_member_text(const struct json_value *object, const char *key);
/* The first element or member of a member. */
const struct json_value *json_member_first(const struct json_value *object,
                                           const char *key);
bool json_member_truth(const struct json_value *object, const char *key,
                       bool otherwise);
/* False, and the value stays: it is there, and no integer below 2^53. */
bool json_member_whole(const struct json_value *object, const char *key,
                       int64_t *value);

#endif
