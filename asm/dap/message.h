/* message.h - the framing of messages: the lines of a header, an empty line, and as
 * many bytes as Content-Length gives.
 */
#ifndef ASM_DAP_MESSAGE_H
#define ASM_DAP_MESSAGE_H

#include "base/sink.h"
#include "vm/c205.h"

enum { MAX_MESSAGE = 1 << 22, MAX_MESSAGE_HEADER = 4096 }; /* bytes */

enum message_state {
    MESSAGE_WHOLE,
    MESSAGE_PART, /* more bytes must be read */
    MESSAGE_BROKEN
};

/* Examines the start of the received bytes. For a whole message, sets the place of its
 * content; for a broken one, sets the error. */
struct message_content {
    size_t begin, length;
};
enum message_state message_find(const struct text_buffer *bytes,
                                struct message_content *content, c205_error *error);
/* Removes the first `count` bytes. */
void message_drop(struct text_buffer *bytes, size_t count);

/* Writes a content with its header in one call. */
void message_put(const struct text_buffer *content, const struct sink *out);

#endif
