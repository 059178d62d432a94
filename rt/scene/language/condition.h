/* condition.h - directives that are closed by #end: #if, #ifdef, #ifndef, #while, #for,
 * #switch, and the directives inside them.
 *
 * They select the tokens that are read, so they may be at any position, even within an
 * expression. A directive must be closed in the file or macro in which it begins. The
 * reader has a stack of open conditions.
 */
#ifndef RT_SCENE_CONDITION_H
#define RT_SCENE_CONDITION_H

#include "rt/scene/language/scene_block.h"

enum { CONDITION_WHEN_DEFINED, CONDITION_UNLESS_DEFINED };

item_reader condition_if;
item_reader condition_ifdef; /* detail: the kind of condition */
item_reader condition_else;  /* also reads #elseif */
item_reader condition_end;
item_reader loop_while, loop_for;
item_reader switch_begin, switch_case; /* switch_case also reads #range */
enum { SWITCH_CASE, SWITCH_RANGE };
item_reader condition_break;

/* Reports the conditions that are still open at the end of the innermost frame. */
void conditions_close(struct reader *reader);

/* Skips text up to one of the directives in `words`, such as "else end". Only words at
 * the right nesting count: depth 1 means that they belong to the innermost open
 * directive, depth 2 to the one around it. The word found becomes the current token. At
 * the end of the frame, reports an error and returns false. */
bool condition_skip(struct reader *reader, const struct scene_token *at,
                    const char *words, size_t depth);
/* Skips a directive whose head has an error, up to the token after its #end. Returns
 * false. */
bool condition_leave_out(struct reader *reader, const struct scene_token *at);
/* The directives that an #end closes. */
#define CONDITION_OPENERS "for if ifdef ifndef macro switch while"

/* Reads "(" condition. The current token is then ")". */
bool condition_read(struct reader *reader, double *value);
bool condition_holds(double value);
/* Prevents directives from closing the open conditions while the arguments of a
 * directive are read. Returns the previous value of reader->sealed, which the caller
 * then restores. */
size_t condition_seal(struct reader *reader);
/* Pushes a condition on the stack. Returns NULL after an error. */
struct scene_condition *condition_push(struct reader *reader, enum condition_kind kind,
                                       const struct scene_token *at);
/* Returns the innermost condition if it belongs to the current frame, else NULL. */
struct scene_condition *condition_top(struct reader *reader);
/* Skips to the token after the #end of the condition, and pops the condition from the
 * stack. */
bool condition_leave(struct reader *reader, struct scene_condition *condition);
/* Handles the #end of a loop: starts the next iteration, or ends the loop. */
bool loop_end(struct reader *reader, struct scene_condition *loop);
bool switch_else(struct reader *reader, struct scene_condition *condition);

#endif
