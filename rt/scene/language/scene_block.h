/* scene_block.h - blocks: `{`, words with their arguments, `}`.
 *
 * A grammar is a few tables of words. A row has one or more words and the function that
 * reads their arguments into the subject of the block. The function of a plain value
 * reads it into the member at the offset that is the row's detail. After an error the
 * parser continues at the next word of the block, so one pass finds all errors.
 */
#ifndef RT_SCENE_BLOCK_H
#define RT_SCENE_BLOCK_H

#include "rt/scene/language/reader.h"

struct item;
typedef bool item_reader(struct reader *reader, const struct item *item);

struct keyword {
    const char *words; /* separated by blanks; "": the name of an object, which is not
                        * consumed */
    item_reader *read;
    size_t detail; /* parameter of the function: an offset, a kind */
};

/* A word in the file; its token is consumed. */
struct item {
    const struct keyword *keyword;
    struct scene_token at;
    void *subject; /* of its block */
    const struct grammar *grammar;
};

/* The text of an item's word, as two arguments of "%.*s". */
#define ITEM_WORD(item) TOKEN_TEXT(&(item)->at)

enum { GRAMMAR_TABLES = 3 };
struct grammar {
    const char *expected;                         /* in messages: "a keyword of fog" */
    const struct keyword *tables[GRAMMAR_TABLES]; /* each ends with NULL */
    item_reader *object;        /* reads an object after its word; NULL: it has none */
    step_mover *move;           /* applies translate, rotate, ..; NULL: it has none */
    const struct grammar *then; /* grammar of words that may follow these */
};
/* A block with no words after its arguments. */
extern const struct grammar no_words;
/* The words of objects, whose detail is an enum shape_word, and of transforms. */
extern const struct keyword object_words[], step_words[];

struct block {
    struct scene_token open;
    size_t level; /* number of braces inside */
    int closing;  /* sign at its end; 0: the end of the file */
};

/* Returns the row of the token's text in a table, or NULL. */
const struct keyword *keyword_find(const struct keyword *table,
                                   const struct scene_token *token);
const struct keyword *grammar_find(const struct grammar *grammar,
                                   const struct scene_token *token);
/* Looks up the current token. If the grammar has no row for it, item.keyword is NULL.
 */
struct item item_find(const struct reader *reader, const struct grammar *grammar,
                      void *subject);

/* Returns the block of the whole file, which is outside all braces. */
struct block block_file(const struct reader *reader);
/* Opens a block at '{' or '['. */
bool block_open(struct reader *reader, struct block *block, int opening);
/* Opens a block that may begin with a name of the kind; its value then replaces the
 * subject. */
bool block_open_from(struct reader *reader, struct block *block,
                     enum scene_value_kind kind, void *subject, size_t size);
/* Reads the words up to the closing brace, and the brace. If `good` is false, the
 * arguments before have an error, and the parser first skips to a word. Returns false
 * if anything had an error. */
bool block_items(struct reader *reader, const struct block *block,
                 const struct grammar *grammar, void *subject, bool good);
/* Opens a block and reads its words. */
bool block_read(struct reader *reader, const struct grammar *grammar, void *subject);
/* Like block_read, for a block that block_open_from opens. */
bool block_read_from(struct reader *reader, const struct grammar *grammar,
                     enum scene_value_kind kind, void *subject, size_t size);
/* Skips the rest of an open block, with its closing sign. */
bool block_finish(struct reader *reader, const struct block *block);
/* Skips the rest of an open block; the closing sign is not consumed. */
void block_pass(struct reader *reader, const struct block *block);
/* Skips from '{' to its '}'. */
void block_skip(struct reader *reader);

/* Returns the member of the subject at the offset that is the row's detail. */
void *item_member(const struct item *item);
/* These read that member: a float, a float above 0, and a float that is 1 if no number
 * follows the word. */
item_reader item_number, item_above_0, item_number_or_1;
/* A vector of 3, and the red, green and blue of a colour. */
item_reader item_vector, item_rgb;
/* A bool, which the word makes true. */
item_reader item_flag;

/* Reports and ignores a word without effect on this renderer. */
item_reader item_left_out;
/* Ignores a word without a report: it has no effect on a picture, or only with another
 * word, which is reported. */
item_reader item_ignored;
/* Reports an error: the word would change the geometry. */
item_reader item_unsupported;
/* Treats a word as a directive, which old scenes may write without '#'. The word is not
 * consumed. */
item_reader item_unmarked;
/* Skips the arguments of a word that is not known further. */
void skip_arguments(struct reader *reader);

#endif
