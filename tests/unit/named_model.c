/* named_model.c - finds and parses machine models. */
#include "named_model.h"

c205_model *named_model(const char *name)
{
    c205_model *model = NON_NULL(c205_model_find(name, &failure));
    return model;
}

c205_model *parsed_model(const char *text)
{
    c205_model *model = NON_NULL(c205_model_parse("test", text, &failure));
    return model;
}
