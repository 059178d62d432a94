/* many_scenes.h - what checks of scenes by chance have in common: how they are
 * called, how they end, what they leave. */
#ifndef MANY_SCENES_H
#define MANY_SCENES_H

#include "rt/scene/scene.h"
#include "vm/c205.h"

/* Say why, and end the program with 2. */
void give_up(const char *message);
/* The model that they are traced on, which the caller frees. */
c205_model *usual_model(void);
/* Gives up, with the text and what is wrong with it, where it is no scene. */
struct scene *scene_of(const char *text);
/* To a file in the folder of the run; without one nothing is lost that is not
 * printed. */
void keep_scene(const char *path, const char *text);

/* A scene that failed, its text and the reason; the text is kept in KIND_NUMBER.pov.
 * How: the options it was traced with. */
void show_failure(const char *kind, size_t number, const char *how, const char *reason,
                  const char *text);

/* CHECK [SCENES [OF SHARE]] [--first]: check the scenes 0 .. SCENES - 1 (300),
 * or every OF-th of them from SHARE on; first: until one fails, of which no
 * more is wanted.  Prints the counts; returns the program's exit code. */
int check_many(int count, char **words, bool (*check)(size_t number, bool first));
/* .. on the usual model. */
int check_many_on(c205_model **model, int count, char **words,
                  bool (*check)(size_t number, bool first));
/* begin is called for each scene, up to so many before it is checked. */
int check_many_ahead(int count, char **words, bool (*check)(size_t number, bool first),
                     void (*begin)(size_t number), size_t ahead);

#endif
