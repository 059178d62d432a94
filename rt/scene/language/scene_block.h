/* scene_block.h - parses blocks by grammars: `{`, keywords with their arguments, `}`.
 *
 * A grammar consists of a few tables of keywords. A row has one or more keywords, and
 * the function that reads their arguments into the subject of the block. If the
 * argument is a plain value, `detail` of the row is the offset of the member that
 * receives it. After an error the parser continues at the next keyword of the block, so
 * it finds all errors in one pass.
 */
#ifndef RT_SCENE_BLOCK_H
#define RT_SCENE_BLOCK_H

#include "rt/scene/language/reader.h"

struct item;
typedef bool item_reader(struct reader *reader, const struct item *item);

struct keyword {
    const char *words; /* keywords separated by blanks; "": the name of an object, which
                        * is not consumed */
    item_reader *read;
    size_t detail; /* parameter of the function, such as an offset or a kind */
};

/* A keyword in the file. Its token has been consumed. */
struct item {
    const struct keyword *keyword;
    struct scene_token at;
    void *subject; /* subject of its block */
    const struct grammar *grammar;
};

/* The text of an item's keyword, as two arguments of "%.*s". */
#define ITEM_WORD(item) TOKEN_TEXT(&(item)->at)

enum { GRAMMAR_TABLES = 3 };
struct grammar {
    const char *expected;                         /* for messages: "a keyword of fog" */
    const struct keyword *tables[GRAMMAR_TABLES]; /* each ends with NULL */
    item_reader *object;        /* reads an object after its keyword; NULL: objects are
                                 * not allowed */
    step_mover *move;           /* applies translate, rotate, ..; NULL: transforms are
                                 * not allowed */
    const struct grammar *then; /* grammar of the keywords that may follow */
};
/* The grammar of a block that has no keywords after its arguments. */
extern const struct grammar no_words;
/* The keywords of objects, whose `detail` member is an enum shape_word, and the
 * keywords of transforms. */
extern const struct keyword object_words[], step_words[];

struct block {
    struct scene_token open;
    size_t level; /* number of open braces inside the block */
    int closing;  /* closing sign; 0: the end of the file */
};

/* Returns the row of the table whose keywords include the token, or NULL. */
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
/* Opens a block. The block may begin with a name of this kind, whose value then
 * replaces the subject. */
bool block_open_from(struct reader *reader, struct block *block,
                     enum scene_value_kind kind, void *subject, size_t size);
/* Reads the keywords up to the closing brace, and the brace. If `good` is false, the
 * arguments before have an error, and the parser first skips to a keyword. Returns
 * false after any error. */
bool block_items(struct reader *reader, const struct block *block,
                 const struct grammar *grammar, void *subject, bool good);
/* Opens a block and reads its keywords. */
bool block_read(struct reader *reader, const struct grammar *grammar, void *subject);
/* Like block_read, for a block that block_open_from opens. */
bool block_read_from(struct reader *reader, const struct grammar *grammar,
                     enum scene_value_kind kind, void *subject, size_t size);
/* Skips the rest of an open block, including its closing sign. */
bool block_finish(struct reader *reader, const struct block *block);
/* Skips the rest of an open block. The closing sign is not consumed. */
void block_pass(struct reader *reader, const struct block *block);
/* Skips from '{' to the matching '}'. */
void block_skip(struct reader *reader);

/* Returns the member of the subject that the keyword sets: item->keyword->detail is its
 * offset. */
void *item_member(const struct item *item);
/* These functions read a float into a member of the subject. item_above_0 reports an
 * error if it is not positive. item_number_or_1 sets 1 if no number follows the
 * keyword. */
item_reader item_number, item_above_0, item_number_or_1;
/* These functions read a value into a member of the subject: item_vector a vector of
 * three components, item_rgb the red, green and blue of a colour. */
item_reader item_vector, item_rgb;
/* Sets a bool member of the subject to true. */
item_reader item_flag;

/* Reports and ignores a keyword that has no effect here. */
item_reader item_left_out;
/* Ignores a keyword without a report. It has no effect on a picture, or only together
 * with a keyword that is reported. */
item_reader item_ignored;
/* Reports an error for a keyword that is not supported and would change the
 * geometry. */
item_reader item_unsupported;
/* Treats a keyword as a directive, because old scenes may omit the '#'. The keyword is
 * not consumed. */
item_reader item_unmarked;
/* Skips the arguments of an unknown keyword. */
void skip_arguments(struct reader *reader);

#endif
