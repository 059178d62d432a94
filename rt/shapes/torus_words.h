/* torus_words.h - tori about y: what is common to both. */
#ifndef RT_TORUS_WORDS_H
#define RT_TORUS_WORDS_H

#include <stddef.h>

/* Of the major radius and the tube's half axes p, away from y, and n, along
 * it. */
size_t torus_words(double major, double p, double n, double *words);

#endif
