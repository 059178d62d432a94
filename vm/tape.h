/* tape.h - what a machine is saved on: words, eight bytes each, the most
 * significant first.
 *
 * State is walked over once, field by field, by whoever owns it; the walk
 * writes the fields to the tape or fills them from it, so that the two
 * directions cannot disagree.  A tape that is written changes no field.
 *
 * Reading trusts nothing: a walk states what each field may be.  The first
 * thing that is wrong is kept as the error; from then on every word reads as
 * zero and every count and text as empty, so that a walk may go on to its
 * end, and nothing more is written.
 */
#ifndef C205_TAPE_H
#define C205_TAPE_H

#include "vm/c205.h"

struct tape {
    c205_writer *write; /* NULL: the tape is read */
    void *context;
    const unsigned char *bytes; /* what is left of a tape that is read */
    size_t left;
    uint64_t hash; /* of all words so far */
    bool failed;
    c205_error *error;
};

enum { TAPE_WORD_BYTES = 8 };

struct tape tape_to(c205_writer *write, void *context, c205_error *error);
struct tape tape_from(const void *bytes, size_t count, c205_error *error);

static inline bool tape_is_read(const struct tape *tape)
{
    return !tape->write;
}

void tape_word(struct tape *tape, uint64_t *word);
void tape_words(struct tape *tape, uint64_t *words, size_t count);
/* As many words as there must be. */
void tape_array(struct tape *tape, uint64_t *words, size_t count);
/* A number of things, at most so many; most is not looked at in writing. */
void tape_size(struct tape *tape, size_t *size, size_t most);
/* A number of things that follow, each a word or more. */
void tape_count(struct tape *tape, size_t *count);
/* Words that the rest of a tape may hold. */
size_t tape_room(const struct tape *tape);
/* A text that was read lies in the bytes of the tape. */
void tape_text(struct tape *tape, const char **text);

/* When reading: this must hold, or the tape is refused. */
void tape_require(struct tape *tape, bool holds, const char *otherwise);
/* Nothing more is read or written; the error tells why. */
void tape_refuse(struct tape *tape, const char *why);

/* The last word of a tape is the hash of those before.  Verifying looks
 * ahead for it, and does nothing when writing. */
void tape_verify(struct tape *tape);
void tape_end(struct tape *tape);

#endif
