/* json.h - writes JSON.
 *
 * A document is one object. Members of an object need a key; elements of an array have
 * none (NULL). Errors are reported only at the end: json_close returns true if
 * everything was written. Bytes that are not UTF-8 become U+FFFD.
 *
 *   struct json *json = json_open("out.json", &error);
 *   json_text(json, "model", "cyber205-2pipe");
 *   json_array(json, "points");
 *   json_count(json, NULL, 51);
 *   json_end(json);
 *   good = json_close(json, &error);
 */
#ifndef BASE_JSON_H
#define BASE_JSON_H

#include <stdio.h>

#include "vm/c205.h"

enum { JSON_NUMBER_SIZE = 32 };

struct json;
struct sink;
struct text_buffer;

/* Opens a document in a file. json_close writes the file. NULL: the file cannot be
 * written. */
struct json *json_open(const char *path, c205_error *error);
/* Opens a document on a stream, and also in a file unless path is NULL. json_close
 * writes both. The owner of the stream must check it for write errors. */
struct json *json_open_stream(FILE *stream, const char *path, c205_error *error);
/* Opens a document that json_close appends to a buffer as one line. */
struct json *json_open_line(struct text_buffer *line, c205_error *error);
bool json_close(struct json *json, c205_error *error);
void json_discard(struct json *json);

void json_object(struct json *json, const char *key);
void json_array(struct json *json, const char *key);
void json_end(struct json *json);

void json_text(struct json *json, const char *key, const char *text);
/* Writes a double with enough digits to read back the same value. NaN and infinities
 * become null. */
void json_number(struct json *json, const char *key, double value);
void json_count(struct json *json, const char *key, uint64_t value);
void json_bool(struct json *json, const char *key, bool value);
void json_null(struct json *json, const char *key);
/* Writes a value that is already JSON. */
void json_raw(struct json *json, const char *key, const char *text);

/* Writes a text as a JSON string with its quotes. */
void json_string(const struct sink *sink, const char *text);

/* Writes a finite double with 15 digits if they read back as the same value, and
 * otherwise with 17 digits. 0.1 is "0.1". */
void json_digits(char text[JSON_NUMBER_SIZE], double value);

#endif
