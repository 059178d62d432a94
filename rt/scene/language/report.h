/* report.h - collecting what the reader has to say of a scene file. */
#ifndef RT_SCENE_REPORT_H
#define RT_SCENE_REPORT_H

#include "rt/scene/language/scene_read.h"

/* Where a report points to; line 0: to the file as a whole. */
struct position {
    const char *file;
    size_t line, column;
    const char *source;   /* the line's text, */
    size_t source_length; /* up to its newline */
};

/* Copies what it is given.  Without memory the report is counted, not kept. */
void reports_add(struct reports *reports, bool error,
                 const struct position *position, const char *message);

/* Whether there is one of the place and the message. */
bool reports_have(const struct reports *reports,
                  const struct position *position, const char *message);
/* Text that a scene says, after what it has said so far.  False: it is more
 * than SAID_MOST bytes in all, or there is no memory. */
enum { SAID_MOST = 1 << 16 };
bool reports_say(struct reports *reports, const char *text);

#endif
