/* condition.h - directives that an #end closes: #if, #ifdef, #ifndef, #while,
 * #for, #switch, and what is in them.
 *
 * They choose which tokens come, so they may stand anywhere, between the words
 * of an expression too.  Each is closed in the file or the macro where it
 * began.  Those that are open lie on the reader's stack of conditions.
 */
#ifndef RT_SCENE_CONDITION_H
#define RT_SCENE_CONDITION_H

#include "rt/scene/language/block.h"

enum { CONDITION_WHEN_DEFINED, CONDITION_UNLESS_DEFINED };

item_reader condition_if;
item_reader condition_ifdef; /* its detail: one of the above */
item_reader condition_else;  /* and #elseif */
item_reader condition_end;
item_reader loop_while, loop_for;
item_reader switch_begin, switch_case; /* the latter #range as well */
enum { SWITCH_CASE, SWITCH_RANGE };
item_reader condition_break;

/* At the end of the innermost frame: those still open are errors. */
void conditions_close(struct reader *reader);

/* What is not to be read, to the first of the words that is at the depth of
 * the `depth` innermost directives that an #end closes; that token comes next,
 * as it is.  False: it is the frame's end, which is an error. */
bool condition_skip(struct reader *reader, const struct scene_token *at,
                    const char *const *words, size_t depth);
extern const char *const skip_to_end[];

/* "(" condition; the ")" stays the token. */
bool condition_read(struct reader *reader, double *value);
bool condition_holds(double value);
/* While a condition is read, those that are open cannot be closed. */
size_t condition_seal(struct reader *reader);
void condition_unseal(struct reader *reader, size_t before);
/* A new condition on the stack; NULL after an error. */
struct scene_condition *condition_push(struct reader *reader, enum condition_kind kind,
                                       const struct scene_token *at);
/* The innermost one, if it is of this frame; or NULL. */
struct scene_condition *condition_top(struct reader *reader);
/* To behind its #end; it is forgotten. */
bool condition_leave(struct reader *reader, struct scene_condition *condition);
/* The #end of a loop comes next: another turn, or none. */
bool loop_end(struct reader *reader, struct scene_condition *loop);
bool switch_else(struct reader *reader, struct scene_condition *condition);

#endif
