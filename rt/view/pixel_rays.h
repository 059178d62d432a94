/* pixel_rays.h - finds the rays of a pixel in the queues of its band's machine at any
 * time, and their elements in the vectors of the queues.
 *
 * All data is read from the machine's memory and registers. A queue is current from the
 * generation of its rays to their shading. A descriptor identifies the current queue
 * (queue_importance in rt/kernels/solids/levels_vector.s). A camera ray belongs to the
 * pixel if both have the same index in the band's planes. The indices of a queue's
 * camera rays are consecutive, or are in a vector (queue_order). Any other ray has the
 * index of its parent ray (LIST_PARENT). These indices lead to the camera ray.
 *
 * While a kernel tests rays, the vector `place` has their indices in the queue. Other
 * vectors of queue.s with the same length have the same rays in the same order. While
 * hits are shaded, the vector `at` has the indices of the hits. Other vectors are not
 * shown.
 */
#ifndef RT_PIXEL_RAYS_H
#define RT_PIXEL_RAYS_H

#include "rt/view/frame_pixel.h"

/* Groups of vectors. In a group, element i of all vectors belongs to the same ray. */
enum pixel_group {
    PIXEL_QUEUE, /* all rays of the queue; in the scalar form only the pixel */
    PIXEL_NEAR,  /* the rays that a kernel currently tests */
    PIXEL_HITS,  /* the hits, during shading; vector form only */
    PIXEL_GROUPS
};

/* The element of a vector that belongs to a ray of the pixel. Before the kernels have
 * written the element, it belongs to an earlier queue. */
struct pixel_element {
    enum pixel_group group;
    size_t list; /* list of the queue; 0: camera rays; n: rays spawned by list n - 1 */
    size_t lane, length;
    const char *vector; /* name of the vector in the program */
    c205_word word;
};

/* Calls the listener for each element, ray by ray and group by group. Returns the
 * number of rays of the pixel in the current queue. */
typedef void pixel_listener(void *context, const struct pixel_element *element);
size_t pixel_elements(const struct frame_pixel *pixel, const c205 *machine,
                      pixel_listener *listener, void *context);

bool pixel_is_in_queue(const struct frame_pixel *pixel, const c205 *machine);
/* Returns true if the machine is at the label where a queue with rays of the pixel has
 * just been generated. */
bool pixel_is_made(const struct frame_pixel *pixel, const c205 *machine);
/* Returns the label of pixel_is_made, at which the rays of a queue have just been
 * generated. */
const char *pixel_made_label(const struct frame_pixel *pixel);

#endif
