/* order.h - in which order the pixels of a band go into queues. */
#ifndef RT_ORDER_H
#define RT_ORDER_H

enum trace_order {
    ORDER_DEFAULT, /* of the stage: the vector form by tiles, others by rows */
    ORDER_ROWS,
    ORDER_TILES, /* nearly square, as many pixels as a queue; the scalar form
                    has no queue, and goes by rows */
    ORDERS
};
const char *order_name(enum trace_order order);

#endif
