/* condition.h - directives that are closed by #end: #if, #ifdef, #ifndef, #while, #for,
 * #switch, and the directives inside them.
 *
 * They select which tokens are read, so they may be at any position, even between the
 * words of an expression. Each is closed in the file or macro in which it began. The
 * open ones are on the reader's stack of conditions.
 */
#ifndef RT_SCENE_CONDITION_H
#define RT_SCENE_CONDITION_H

#include "rt/scene/language/scene_block.h"

enum { CONDITION_WHEN_DEFINED, CONDITION_UNLESS_DEFINED };

item_reader condition_if;
item_reader condition_ifdef; /* detail: one of the above */
item_reader condition_else;  /* also #elseif */
item_reader condition_end;
item_reader loop_while, loop_for;
item_reader switch_begin, switch_case; /* switch_case: also #range */
enum { SWITCH_CASE, SWITCH_RANGE };
item_reader condition_break;

/* Reports the conditions that are open at the end of the innermost frame. */
void conditions_close(struct reader *reader);

/* Skips text, to the first of the words that belongs to the outermost of the `depth`
 * innermost directives. That token becomes the current one, and is not interpreted.
 * Reports an error and fails at the end of the frame. */
bool condition_skip(struct reader *reader, const struct scene_token *at,
                    const char *words, size_t depth);
/* Skips to the token after the #end of a directive whose head has an error. Returns
 * false. */
bool condition_leave_out(struct reader *reader, const struct scene_token *at);
/* The directives that an #end closes. */
#define CONDITION_OPENERS "for if ifdef ifndef macro switch while"

/* Reads "(" condition; the current token is then ")". */
bool condition_read(struct reader *reader, double *value);
bool condition_holds(double value);
/* While a condition is read, the open ones are sealed: they cannot be closed. Returns
 * the former state, which the caller restores in reader->sealed. */
size_t condition_seal(struct reader *reader);
/* Pushes a condition on the stack. Returns NULL after an error. */
struct scene_condition *condition_push(struct reader *reader, enum condition_kind kind,
                                       const struct scene_token *at);
/* Returns the innermost condition if it is of this frame, else NULL. */
struct scene_condition *condition_top(struct reader *reader);
/* Skips to the token after the condition's #end, and pops it. */
bool condition_leave(struct reader *reader, struct scene_condition *condition);
/* Handles the #end of a loop: starts the next iteration, or ends the loop. */
bool loop_end(struct reader *reader, struct scene_condition *loop);
bool switch_else(struct reader *reader, struct scene_condition *condition);

#endif
