/* block.h - blocks: `{`, words with their arguments, `}`.
 *
 * A grammar is a table of words; each word has the function that reads its
 * arguments into the block's subject.  After an error the block continues at its
 * next word, so that one reading finds all errors.
 */
#ifndef RT_SCENE_BLOCK_H
#define RT_SCENE_BLOCK_H

#include "rt/scene/language/reader.h"

struct item;
typedef bool item_reader(struct reader *reader, void *subject, const struct item *item);

struct keyword {
    const char *word; /* "": the name of an object, which is left to read */
    item_reader *read;
    size_t detail; /* for the function: an offset, a kind */
};

/* A word that is in the file; its token is read already. */
struct item {
    const struct keyword *keyword;
    struct scene_token at;
};

enum { GRAMMAR_TABLES = 4 };
struct grammar {
    const char *expected;                         /* "a word of finish", for messages */
    const struct keyword *tables[GRAMMAR_TABLES]; /* each ends with NULL */
    const struct grammar *then;                   /* words that may follow all these */
};

struct block {
    struct scene_token open;
    size_t level; /* of braces inside */
    int closing;  /* the sign at its end; 0: the end of the file */
};

const struct keyword *grammar_find(const struct grammar *grammar,
                                   const struct scene_token *token);

/* What stands outside all braces, up to the end of the file. */
struct block block_file(const struct reader *reader);
/* '{' or '['. */
bool block_open(struct reader *reader, struct block *block, int opening);
/* A block that may begin with a name of the kind: its value replaces the
 * subject. */
bool block_open_from(struct reader *reader, struct block *block,
                     enum scene_value_kind kind, void *subject, size_t size);
/* The words up to the closing brace, and that brace.  With `good` false (the
 * arguments before are wrong) it first looks for a word.  False when anything
 * was wrong. */
bool block_items(struct reader *reader, const struct block *block,
                 const struct grammar *grammar, void *subject, bool good);
/* Both. */
bool block_read(struct reader *reader, const struct grammar *grammar, void *subject);
/* The rest of an open block, whatever it is. */
bool block_finish(struct reader *reader, const struct block *block);
/* .. up to its closing sign, which is left. */
void block_pass(struct reader *reader, const struct block *block);
/* From '{' to its '}', whatever is between. */
void block_skip(struct reader *reader);

/* For words that change nothing that is drawn here: reported, left out. */
item_reader item_left_out;
/* For words that change nothing without another one, which is reported, or
 * nothing at all in a picture. */
item_reader item_passed_over;
/* For words that change the geometry: an error. */
item_reader item_unsupported;
/* For directives that old scenes begin without '#': the word is left. */
item_reader item_unmarked;
/* The arguments of a word that is not known further. */
void skip_arguments(struct reader *reader);

#endif
