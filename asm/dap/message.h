/* message.h - the framing of messages: a header, an empty line, and the content. The
 * header gives the number of bytes of the content as Content-Length.
 */
#ifndef ASM_DAP_MESSAGE_H
#define ASM_DAP_MESSAGE_H

#include "base/sink.h"
#include "vm/c205.h"

enum { MAX_MESSAGE = 1 << 22, MAX_MESSAGE_HEADER = 4096 }; /* bytes */

enum message_state {
    MESSAGE_WHOLE,
    MESSAGE_PART, /* the message is incomplete */
    MESSAGE_BROKEN
};

/* The place of the content of a message in the received bytes. */
struct message_content {
    size_t begin, length;
};
/* Finds the first message in the received bytes. Sets *content if the message is
 * complete, and the error if it is invalid. */
enum message_state message_find(const struct text_buffer *bytes,
                                struct message_content *content, c205_error *error);
/* Removes the first `count` received bytes. */
void message_drop(struct text_buffer *bytes, size_t count);

/* Writes a message, its header and its content, in one call. */
void message_put(const struct text_buffer *content, const struct sink *out);

#endif
