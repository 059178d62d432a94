/* order.h - the order in which the pixels of a band enter the queues. */
#ifndef RT_ORDER_H
#define RT_ORDER_H

enum trace_order {
    ORDER_DEFAULT, /* tiles in the vector form, rows in the others */
    ORDER_ROWS,
    ORDER_TILES, /* nearly square, with as many pixels as a queue; the scalar form
                  * has no queue and uses rows */
    ORDERS
};
const char *order_name(enum trace_order order);

#endif
