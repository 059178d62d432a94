/* order.c - the names of the pixel orders. */
#include "rt/trace/order.h"

static const char *const orders[ORDERS] = {
    [ORDER_DEFAULT] = "default",
    [ORDER_ROWS] = "rows",
    [ORDER_TILES] = "tiles",
};

const char *order_name(enum trace_order order)
{
    return orders[order];
}
