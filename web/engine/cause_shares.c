/* cause_shares.c - sums the clocks of a range by cause, in columns of a picture. */
#include <stdlib.h>

#include "web/engine/cause_shares.h"

struct cause_shares *cause_shares_new(uint64_t from, uint64_t to, size_t columns)
{
    struct cause_shares *shares = malloc(sizeof *shares);
    if (!shares)
        return NULL;
    *shares = (struct cause_shares){ .from = from,
                                     .to = to,
                                     .columns = columns,
                                     .clocks = calloc(columns * C205_CAUSES,
                                                      sizeof(uint64_t)) };
    if (shares->clocks)
        return shares;
    free(shares);
    return NULL;
}

void cause_shares_free(struct cause_shares *shares)
{
    if (shares)
        free(shares->clocks);
    free(shares);
}

/* Returns the clock at which a column begins. */
static uint64_t column_begin(const struct cause_shares *shares, uint64_t column)
{
    uint64_t length = shares->to - shares->from, columns = shares->columns;
    return shares->from + length / columns * column
           + length % columns * column / columns;
}

/* Returns the column that contains a clock of the range. */
static uint64_t column_of(const struct cause_shares *shares, uint64_t clock)
{
    double share = (double)(clock - shares->from) / (double)(shares->to - shares->from);
    uint64_t column = (uint64_t)(share * (double)shares->columns);
    while (column > 0 && column_begin(shares, column) > clock)
        column--;
    while (column_begin(shares, column + 1) <= clock)
        column++;
    return column;
}

static void add_span(struct cause_shares *shares, uint64_t begin, uint64_t end,
                     c205_cause cause)
{
    begin = begin < shares->from ? shares->from : begin;
    end = end > shares->to ? shares->to : end;
    if (begin >= end)
        return;
    for (uint64_t column = column_of(shares, begin); begin < end; column++) {
        uint64_t next = column_begin(shares, column + 1);
        next = next < end ? next : end;
        shares->clocks[column * C205_CAUSES + (uint64_t)cause] += next - begin;
        begin = next;
    }
}

void cause_shares_add(struct cause_shares *shares, const c205_event *event)
{
    uint64_t clock = event->record ? event->record->arrived : 0;
    for (size_t i = 0; event->record && i < event->record->piece_count; i++) {
        const c205_piece *piece = &event->record->piece[i];
        add_span(shares, clock, clock + piece->clocks, piece->cause);
        clock += piece->clocks;
    }
}

static uint64_t clocks_of(const struct cause_shares *shares, size_t cause)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < shares->columns; i++)
        sum += shares->clocks[i * C205_CAUSES + cause];
    return sum;
}

void cause_shares_put(const struct cause_shares *shares, struct json *reply)
{
    json_array(reply, "shares");
    for (size_t cause = 0; cause < C205_CAUSES; cause++) {
        if (clocks_of(shares, cause) == 0)
            continue;
        json_object(reply, NULL);
        json_text(reply, "cause", c205_cause_name((c205_cause)cause));
        json_array(reply, "clocks");
        for (size_t i = 0; i < shares->columns; i++)
            json_count(reply, NULL, shares->clocks[i * C205_CAUSES + cause]);
        json_end(reply);
        json_end(reply);
    }
    json_end(reply);
}
