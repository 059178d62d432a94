/* serializer.h - writes or reads a machine as words, eight bytes each, the most
 * significant first.
 *
 * The owner of a state has one function, a walk, that passes each field to the
 * serializer. The serializer writes the fields or fills them, so the two directions
 * cannot disagree. Writing changes no field.
 *
 * Input is not trusted: a walk states the valid values of each field. The first
 * violation is stored as the error. After an error, each word reads as zero and each
 * count and text as empty, so a walk may continue to its end. Nothing is written after
 * an error.
 */
#ifndef C205_SERIALIZER_H
#define C205_SERIALIZER_H

#include "vm/c205.h"

struct serializer {
    c205_writer *write; /* NULL: the serializer reads */
    void *context;
    const unsigned char *bytes; /* the unread bytes */
    size_t left;
    uint64_t hash; /* hash of all words so far */
    bool failed;
    c205_error *error;
};

enum { SERIALIZER_WORD_BYTES = 8 };

/* Return a serializer that writes to a function, and one that reads from bytes. */
struct serializer serializer_to(c205_writer *write, void *context, c205_error *error);
struct serializer serializer_from(const void *bytes, size_t count, c205_error *error);

static inline bool serializer_is_read(const struct serializer *serializer)
{
    return !serializer->write;
}

void serializer_word(struct serializer *serializer, uint64_t *word);
void serializer_words(struct serializer *serializer, uint64_t *words, size_t count);
/* Serializes an array of fixed length: its length, which reading checks, and its
 * words. */
void serializer_array(struct serializer *serializer, uint64_t *words, size_t count);
/* Serializes a number. Reading fails if the number is above `most`. Writing does not
 * check it. */
void serializer_size(struct serializer *serializer, size_t *size, size_t most);
/* Serializes the number of items that follow. Each item has at least one word, so
 * reading rejects a count above the number of words left. */
void serializer_count(struct serializer *serializer, size_t *count);
/* Returns the number of words left to read. */
size_t serializer_room(const struct serializer *serializer);
/* Serializes a text. A text that was read points into the bytes of the serializer. */
void serializer_text(struct serializer *serializer, const char **text);

/* Sets an error if the condition does not hold when reading. */
void serializer_require(struct serializer *serializer, bool holds,
                        const char *otherwise);
/* Sets the error. No further words are read or written. */
void serializer_refuse(struct serializer *serializer, const char *why);

/* The last word is the hash of all previous words. serializer_verify checks it before
 * the other words are read. It does nothing when writing. */
void serializer_verify(struct serializer *serializer);
void serializer_end(struct serializer *serializer);

#endif
