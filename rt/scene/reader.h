/* reader.h - the state of reading one scene, and its tokens.
 *
 * Every function that reads returns false after it has reported an error; what
 * it was to make is then worth nothing.  The caller that can go on (a block,
 * or the file) skips to the next word that it knows.
 */
#ifndef RT_SCENE_READER_H
#define RT_SCENE_READER_H

#include "rt/scene/token.h"
#include "rt/scene/value.h"

/* Bounds, so that no file takes the program's stack, memory or patience. */
enum {
    NESTING_MOST = 200,       /* blocks and brackets within each other */
    PRIMITIVES_MOST = 200000, /* made in all, copies counted */
    REPORTS_MOST = 200,
    CONDITIONS_MOST = 100     /* within each other */
};

/* An #ifdef or #ifndef whose #end has not come. */
struct condition {
    struct token at;
    bool in_else;
};

struct reader {
    struct lexer lexer;
    struct source *sources;
    size_t includes;
    struct token token; /* the next to be read */
    size_t braces;      /* open before it */
    bool closed;        /* the one before is a closing brace */
    size_t nesting;
    size_t condition_count;
    struct condition conditions[CONDITIONS_MOST];

    struct symbols symbols;
    struct texture default_texture;
    struct object world;
    size_t primitives_made;
    struct scene *scene;
    bool camera_given;
    struct token shadow_light; /* the first that would cast shadows; */
    bool shadows;              /* there is one */

    const struct scene_options *options;
    struct reports *reports;
    struct token fault; /* where the last error is */
    bool stopped;       /* too many reports, or no memory */
};

void reader_next(struct reader *reader);

#if defined __GNUC__
#define FORMAT(n) __attribute__((format(printf, n, n + 1)))
#else
#define FORMAT(n)
#endif
/* An error at the token, unless the last one is there too.  Returns false. */
bool reader_fault(struct reader *reader, const struct token *at,
                  const char *format, ...) FORMAT(3);
/* Something that is replaced or left out. */
void reader_report(struct reader *reader, const struct token *at,
                   const char *format, ...) FORMAT(3);
/* The error that `what` stands not here.  Returns false. */
bool reader_expected(struct reader *reader, const char *what);
bool reader_no_memory(struct reader *reader);

bool reader_at_sign(const struct reader *reader, int sign);
bool reader_accept_sign(struct reader *reader, int sign);
bool reader_expect_sign(struct reader *reader, int sign);
bool reader_accept(struct reader *reader, const char *word);
/* Commas between arguments may be left out. */
void reader_comma(struct reader *reader);

/* The value that the next token names, or NULL. */
const struct value *reader_value(const struct reader *reader);
/* The same if it is of the kind. */
const struct value *reader_value_of(const struct reader *reader,
                                    enum value_kind kind);

/* Enter and leave what may stand within itself; false: too deep. */
bool reader_enter(struct reader *reader);
void reader_leave(struct reader *reader);

#endif
