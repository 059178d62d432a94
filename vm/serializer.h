/* serializer.h - what a machine is saved on: words, eight bytes each, the most
 * significant first.
 *
 * State is walked over once, field by field, by whoever owns it; the walk
 * writes the fields to the tape or fills them from it, so that the two
 * directions cannot disagree.  A tape that is written changes no field.
 *
 * Reading trusts nothing: a walk states what each field may be.  The first
 * thing that is wrong is kept as the error; from then on every word reads as
 * zero and every count and text as empty, so that a walk may continue to its
 * end, and nothing more is written.
 */
#ifndef C205_SERIALIZER_H
#define C205_SERIALIZER_H

#include "vm/c205.h"

struct serializer {
    c205_writer *write; /* NULL: the tape is read */
    void *context;
    const unsigned char *bytes; /* what is left of a tape that is read */
    size_t left;
    uint64_t hash; /* of all words so far */
    bool failed;
    c205_error *error;
};

enum { SERIALIZER_WORD_BYTES = 8 };

struct serializer serializer_to(c205_writer *write, void *context, c205_error *error);
struct serializer serializer_from(const void *bytes, size_t count, c205_error *error);

static inline bool serializer_is_read(const struct serializer *serializer)
{
    return !serializer->write;
}

void serializer_word(struct serializer *serializer, uint64_t *word);
void serializer_words(struct serializer *serializer, uint64_t *words, size_t count);
/* As many words as there must be. */
void serializer_array(struct serializer *serializer, uint64_t *words, size_t count);
/* A number of things, at most so many; most is not looked at in writing. */
void serializer_size(struct serializer *serializer, size_t *size, size_t most);
/* A number of things that follow, each a word or more. */
void serializer_count(struct serializer *serializer, size_t *count);
/* Words that the rest of a tape may hold. */
size_t serializer_room(const struct serializer *serializer);
/* A text that was read lies in the bytes of the serializer. */
void serializer_text(struct serializer *serializer, const char **text);

/* When reading: this must hold, or the tape is refused. */
void serializer_require(struct serializer *serializer, bool holds,
                        const char *otherwise);
/* Nothing more is read or written; the error tells why. */
void serializer_refuse(struct serializer *serializer, const char *why);

/* The last word of a tape is the hash of those before.  Verifying looks
 * ahead for it, and does nothing when writing. */
void serializer_verify(struct serializer *serializer);
void serializer_end(struct serializer *serializer);

#endif
