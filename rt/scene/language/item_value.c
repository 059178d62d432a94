/* item_value.c - reads the value after a keyword, and stores it in the member of the
 * subject that the keyword sets. */
#include "rt/scene/language/scene_block.h"

#include "rt/scene/language/scene_expression.h"

void *item_member(const struct item *item)
{
    return (char *)item->subject + item->keyword->detail;
}

bool item_number(struct reader *reader, const struct item *item)
{
    return read_number(reader, item_member(item));
}

bool item_above_0(struct reader *reader, const struct item *item)
{
    const double *number = item_member(item);
    return item_number(reader, item)
           && (*number > 0
               || reader_fault(reader, &item->at, "%.*s must be above 0",
                               ITEM_WORD(item)));
}

bool item_number_or_1(struct reader *reader, const struct item *item)
{
    double *number = item_member(item);
    *number = 1;
    return !starts_expression(reader) || read_number(reader, number);
}

bool item_vector(struct reader *reader, const struct item *item)
{
    return read_vector(reader, item_member(item));
}

bool item_rgb(struct reader *reader, const struct item *item)
{
    return read_rgb(reader, item_member(item));
}

bool item_flag(struct reader *reader, const struct item *item)
{
    bool *flag = item_member(item);
    (void)reader;
    return *flag = true;
}
