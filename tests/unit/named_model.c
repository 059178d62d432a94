/* named_model.c - finds and parses machine models. */
#include "named_model.h"

c205_model *named_model(const char *name)
{
    return NON_NULL(c205_model_find(name, &failure));
}

c205_model *parsed_model(const char *text)
{
    return NON_NULL(c205_model_parse("test", text, &failure));
}
