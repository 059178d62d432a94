/* pixel_rays.h - finds the rays of a pixel in the queues of its band's machine,
 * and their elements in the queues' vectors, at any time.
 *
 * All data is read from the machine's memory and registers. The program has a
 * current queue from the generation of its rays to their shading. A descriptor
 * identifies it (queue_importance in rt/kernels/solids/levels_vector.s). A camera
 * ray belongs to the pixel if its index in the band's planes is the pixel's. The
 * indices of a queue's rays are consecutive, or are in a vector (queue_order). Any
 * other ray has the index of its parent ray (LIST_PARENT), and so on up to the
 * camera ray.
 *
 * While a kernel tests rays, the vector `place` has their indices in the queue.
 * Other vectors that queue.s makes as long have the same rays in the same order.
 * While hits are shaded, the vector `at` has the indices of the hits. Other
 * vectors are not shown.
 */
#ifndef RT_PIXEL_RAYS_H
#define RT_PIXEL_RAYS_H

#include "rt/view/frame_pixel.h"

/* Groups of vectors whose elements belong to rays in the same order. */
enum pixel_group {
    PIXEL_QUEUE, /* the queue; in scalar form only the pixel */
    PIXEL_NEAR,  /* the rays that a kernel currently tests */
    PIXEL_HITS,  /* the hits, during shading; vector form only */
    PIXEL_GROUPS
};

/* The element of a vector that belongs to a ray of the pixel. It is of this queue
 * only once the kernels have written it. */
struct pixel_element {
    enum pixel_group group;
    size_t list; /* of the queue; 0: camera rays; n: rays spawned by list n - 1 */
    size_t lane, length;
    const char *vector; /* its name in the program */
    c205_word word;
};

/* Calls the listener for each element, ray by ray and group by group. Returns the
 * number of the pixel's rays in the current queue. */
typedef void pixel_listener(void *context, const struct pixel_element *element);
size_t pixel_elements(const struct frame_pixel *pixel, const c205 *machine,
                      pixel_listener *listener, void *context);

bool pixel_is_in_queue(const struct frame_pixel *pixel, const c205 *machine);
/* Returns true if the machine is where a queue with rays of the pixel has just
 * been generated. */
bool pixel_is_made(const struct frame_pixel *pixel, const c205 *machine);
/* Returns the label of that place. */
const char *pixel_made_label(const struct frame_pixel *pixel);

#endif
