/* tape.c - see tape.h. */
#include "vm/tape.h"

#include "vm/hash.h"

#include <stdio.h>
#include <string.h>

static const char damaged[] = "the saved machine is damaged";

struct tape tape_to(c205_writer *write, void *context, c205_error *error)
{
    struct tape tape = { write, context, NULL, 0, HASH_BEGIN, false, error };
    return tape;
}

struct tape tape_from(const void *bytes, size_t count, c205_error *error)
{
    struct tape tape = { NULL, NULL, bytes, count, HASH_BEGIN, false, error };
    return tape;
}

void tape_refuse(struct tape *tape, const char *why)
{
    if (!tape->failed)
        snprintf(tape->error->message, sizeof tape->error->message, "%s", why);
    tape->failed = true;
}

void tape_require(struct tape *tape, bool holds, const char *otherwise)
{
    if (tape_is_read(tape) && !holds)
        tape_refuse(tape, otherwise);
}

/* ---- Words --------------------------------------------------------------- */

static uint64_t word_at(const unsigned char *bytes)
{
    uint64_t word = 0;
    for (size_t i = 0; i < TAPE_WORD_BYTES; i++)
        word = word << 8 | bytes[i];
    return word;
}

static void write_word(struct tape *tape, uint64_t word)
{
    unsigned char bytes[TAPE_WORD_BYTES];
    for (size_t i = 0; i < TAPE_WORD_BYTES; i++)
        bytes[i] = (unsigned char)(word >> (8 * (TAPE_WORD_BYTES - 1 - i)));
    if (!tape->write(tape->context, bytes, sizeof bytes))
        tape_refuse(tape, "the machine cannot be saved there");
}

static uint64_t read_word(struct tape *tape)
{
    if (tape->left < TAPE_WORD_BYTES) {
        tape_refuse(tape, damaged);
        return 0;
    }
    uint64_t word = word_at(tape->bytes);
    tape->bytes += TAPE_WORD_BYTES;
    tape->left -= TAPE_WORD_BYTES;
    return word;
}

void tape_word(struct tape *tape, uint64_t *word)
{
    if (tape_is_read(tape))
        *word = tape->failed ? 0 : read_word(tape);
    else if (!tape->failed)
        write_word(tape, *word);
    tape->hash = hash_word(tape->hash, *word);
}

void tape_words(struct tape *tape, uint64_t *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        tape_word(tape, &words[i]);
}

void tape_size(struct tape *tape, size_t *size, size_t most)
{
    uint64_t word = *size;
    tape_word(tape, &word);
    tape_require(tape, word <= most, damaged);
    *size = tape_is_read(tape) && tape->failed ? 0 : (size_t)word;
}

void tape_array(struct tape *tape, uint64_t *words, size_t count)
{
    size_t counted = count;
    tape_size(tape, &counted, count);
    tape_require(tape, counted == count, damaged);
    tape_words(tape, words, count);
}

size_t tape_room(const struct tape *tape)
{
    return tape->left / TAPE_WORD_BYTES;
}

void tape_count(struct tape *tape, size_t *count)
{
    size_t room = tape_room(tape); /* with that of the number itself */
    tape_size(tape, count, room > 0 ? room - 1 : 0);
}

/* ---- Texts: how many words, then the characters and at least one NUL ----- */

static void write_text(struct tape *tape, const char *text)
{
    size_t length = strlen(text), words = length / TAPE_WORD_BYTES + 1;
    tape_size(tape, &words, words);
    for (size_t i = 0; i < words; i++) {
        unsigned char bytes[TAPE_WORD_BYTES] = { 0 };
        size_t left = length - i * TAPE_WORD_BYTES;
        memcpy(bytes, text + i * TAPE_WORD_BYTES,
               left < sizeof bytes ? left : sizeof bytes);
        uint64_t word = word_at(bytes);
        tape_word(tape, &word);
    }
}

static const char *read_text(struct tape *tape)
{
    const char *text = "";
    size_t words = 0;
    tape_count(tape, &words);
    if (words > 0 && tape->bytes[words * TAPE_WORD_BYTES - 1] == '\0')
        text = (const char *)tape->bytes;
    else
        tape_refuse(tape, damaged);
    for (uint64_t word; words > 0; words--)
        tape_word(tape, &word);
    return text;
}

void tape_text(struct tape *tape, const char **text)
{
    if (tape_is_read(tape))
        *text = read_text(tape);
    else
        write_text(tape, *text);
}

/* ---- The end -------------------------------------------------------------- */

void tape_verify(struct tape *tape)
{
    struct tape ahead = *tape;
    uint64_t word;
    tape_require(tape, tape->left % TAPE_WORD_BYTES == 0, damaged);
    if (!tape_is_read(tape) || tape->failed)
        return;
    while (tape_room(&ahead) > 1)
        tape_word(&ahead, &word);
    tape_end(&ahead);
    tape->failed = ahead.failed;
}

void tape_end(struct tape *tape)
{
    uint64_t hash = tape->hash, word = hash;
    tape_word(tape, &word);
    tape_require(tape, word == hash && tape->left == 0, damaged);
}
