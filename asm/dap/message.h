/* message.h - messages as they are framed: lines of a header, an empty one, and so many
 * bytes as Content-Length says.
 */
#ifndef ASM_DAP_MESSAGE_H
#define ASM_DAP_MESSAGE_H

#include "base/sink.h"
#include "vm/c205.h"

enum { MAX_MESSAGE = 1 << 22, MAX_MESSAGE_HEADER = 4096 }; /* bytes */

enum message_state {
    MESSAGE_WHOLE,
    MESSAGE_PART, /* the rest is to come */
    MESSAGE_BROKEN
};

/* What is at the beginning of what was read; of a whole message where its content
 * is.  Of a broken one the error says what is wrong. */
struct message_content {
    size_t begin, length;
};
enum message_state message_find(const struct text_buffer *bytes,
                                struct message_content *content, c205_error *error);
/* So many bytes are done with. */
void message_drop(struct text_buffer *bytes, size_t count);

/* A content with its header, in one call. */
void message_put(const struct text_buffer *content, const struct sink *out);

#endif
