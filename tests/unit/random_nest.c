/* random_nest.c - random nests of directives, in written or expanded form. */
#include "tests/unit/random_nest.h"

#include "tests/random.h"
#include "tests/unit/scene_reading.h"

enum { MAX_VARIABLES = 100, DEPTH = 4 };

/* The kind of a list. NUMBER is a single number. */
enum place { OBJECTS, MODIFIERS, LAYER, FINISH, TERMS, NUMBER };

struct making {
    bool written;   /* true: written form; false: expanded form */
    uint64_t state; /* random state of all choices */
    struct text_buffer text;
    size_t silent;                /* above 0: text is suppressed */
    double values[MAX_VARIABLES]; /* values of the visible variables V0, V1 .. */
    size_t variables;
    size_t macros;  /* number of macros that were written */
    bool breakable; /* a #break here would leave no incomplete block */
    bool broken;    /* a #break was executed */
    double value;   /* value of the last NUMBER */
};

static void list(struct making *making, enum place place, size_t depth);
static double number(struct making *making, size_t depth);

/* ---- Choices and texts -------------------------------------------------- */

static size_t below(struct making *making, size_t count)
{
    return (size_t)xorshift_between(&making->state, 0, (int64_t)count - 1);
}

static uint64_t new_seed(struct making *making)
{
    return xorshift(&making->state) | 1;
}

static void put(struct making *making, const char *format, ...)
{
    struct sink sink = text_buffer_sink(&making->text);
    char text[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (making->silent == 0)
        sink_put(&sink, text);
}

/* Writes a directive. The expanded form omits it. */
#define direct(making, ...) ((making)->written ? put(making, __VA_ARGS__) : (void)0)

/* Writes the number of a directive, or only computes it in the expanded form. */
static double direct_number(struct making *making, size_t depth)
{
    double before = making->value;
    making->silent += !making->written;
    double value = number(making, depth);
    making->silent -= !making->written;
    making->value = before;
    return value;
}

static size_t new_variable(struct making *making, double value)
{
    assert_true(making->variables < MAX_VARIABLES);
    making->values[making->variables] = value;
    return making->variables++;
}

/* Generates the body of a directive or macro call, with its own variables. */
static void carry_out(struct making *making, enum place place, uint64_t seed,
                      size_t depth)
{
    uint64_t state = making->state;
    size_t variables = making->variables;
    making->state = seed;
    if (place == NUMBER)
        making->value = number(making, depth);
    else
        list(making, place, depth);
    making->state = state;
    making->variables = variables;
}

/* Generates a body that a #break can end. Returns true if a #break was executed. */
static bool carry_out_broken(struct making *making, enum place place, uint64_t seed,
                             size_t depth)
{
    bool breakable = making->breakable;
    making->breakable = true;
    carry_out(making, place, seed, depth);
    making->breakable = breakable;
    bool broken = making->broken;
    making->broken = false;
    return broken;
}

/* Generates a branch. A #break in it ends the enclosing body. */
static void carry_out_branch(struct making *making, enum place place, uint64_t seed,
                             size_t depth, bool *broken)
{
    carry_out(making, place, seed, depth);
    *broken = *broken || making->broken;
    making->broken = false;
}

/* Generates a list in its own brackets. */
static void inside(struct making *making, enum place place, size_t depth)
{
    bool breakable = making->breakable;
    making->breakable = false;
    carry_out(making, place, new_seed(making), depth);
    making->breakable = breakable;
}

/* ---- Directives --------------------------------------------------------- */

static bool condition(struct making *making, size_t depth)
{
    size_t sign = below(making, 3);
    direct(making, "(");
    double a = direct_number(making, depth);
    direct(making, "%c", "=<>"[sign]);
    double b = direct_number(making, depth);
    direct(making, ")");
    return sign == 0 ? a == b : sign == 1 ? a < b : a > b;
}

static size_t turns_of(struct making *making, enum place place)
{
    return place == NUMBER ? 1 : below(making, 4);
}

static void put_for(struct making *making, enum place place, size_t depth)
{
    static const double steps[] = { 1, 1, 2, -1 };
    size_t which = below(making, COUNT(steps));
    size_t turns = turns_of(making, place);
    double step = steps[which], start = (double)below(making, 4);
    size_t variable = new_variable(making, start);
    uint64_t seed = new_seed(making);
    direct(making, "#for (V%zu, %g, %g", variable, start,
           start + step * ((double)turns - 1));
    direct(making, which > 0 ? ", %g)\n" : ")\n", step);
    for (size_t i = 0; i < (making->written ? 1 : turns); i++) {
        making->values[variable] = start + step * (double)i;
        if (carry_out_broken(making, place, seed, depth))
            break;
    }
    direct(making, " #end\n");
    making->variables--;
}

static void put_while(struct making *making, enum place place, size_t depth)
{
    size_t turns = turns_of(making, place);
    size_t first = below(making, 2); /* 1: the body follows the increment */
    uint64_t seed = new_seed(making);
    size_t variable = new_variable(making, 0);
    direct(making, "#local V%zu = 0; #while (V%zu < %zu)\n", variable, variable, turns);
    for (size_t i = 0; i < (making->written ? 1 : turns); i++) {
        making->values[variable] = (double)(i + first);
        if (first)
            direct(making, "#local V%zu = V%zu + 1;", variable, variable);
        if (carry_out_broken(making, place, seed, depth))
            break;
        if (!first)
            direct(making, "#local V%zu = V%zu + 1;", variable, variable);
    }
    direct(making, " #end\n");
    making->variables--;
}

static void put_if(struct making *making, enum place place, size_t depth)
{
    size_t more = below(making, 2); /* number of #elseif branches */
    bool otherwise = place == NUMBER || below(making, 2);
    bool chosen = false, broken = false;
    for (size_t i = 0; i <= more; i++) {
        direct(making, i == 0 ? "#if " : " #elseif ");
        bool holds = condition(making, depth / 2);
        uint64_t seed = new_seed(making);
        if (making->written || (!chosen && holds))
            carry_out_branch(making, place, seed, depth, &broken);
        chosen = chosen || holds;
    }
    direct(making, otherwise ? " #else " : " ");
    if (otherwise) {
        uint64_t seed = new_seed(making);
        if (making->written || !chosen)
            carry_out_branch(making, place, seed, depth, &broken);
    }
    direct(making, " #end\n");
    making->broken = broken;
}

/* Writes #case or #range. Returns true if it matches the value. */
static bool put_case(struct making *making, double value)
{
    double low = (double)below(making, 5);
    size_t width = below(making, 3);
    if (width == 0)
        direct(making, " #case (%g)\n", low);
    else
        direct(making, " #range (%g, %g)\n", low, low + (double)width);
    return value >= low && value <= low + (double)width;
}

static void put_switch(struct making *making, enum place place, size_t depth)
{
    size_t cases = below(making, 4);
    bool one = place == NUMBER, chosen = false, done = false;
    direct(making, "#switch (");
    double value = direct_number(making, depth / 2);
    direct(making, ")");
    for (size_t i = 0; i < cases; i++) {
        bool fits = put_case(making, value), ends = one || below(making, 2);
        uint64_t seed = new_seed(making);
        chosen = chosen || fits;
        if (making->written || (chosen && !done))
            done = carry_out_broken(making, place, seed, depth) || (chosen && ends)
                   || done;
        direct(making, ends ? " #break\n" : " ");
    }
    if (one || below(making, 2)) {
        uint64_t seed = new_seed(making);
        direct(making, " #else\n");
        if (making->written || !done)
            carry_out_broken(making, place, seed, depth);
    }
    direct(making, " #end\n");
}

static void put_macro(struct making *making, enum place place, size_t depth)
{
    size_t calls = place == NUMBER ? 1 : below(making, 3);
    size_t variable = new_variable(making, 0), name = making->macros++;
    uint64_t seed = new_seed(making);
    direct(making, "#macro M%zu(V%zu) ", name, variable);
    if (making->written)
        carry_out_broken(making, place, seed, depth);
    direct(making, " #end\n");
    for (size_t i = 0; i < calls; i++) {
        making->variables--; /* the argument of a call cannot use the parameter */
        direct(making, " M%zu(", name);
        double value = direct_number(making, depth / 2);
        direct(making, ") ");
        new_variable(making, value);
        if (!making->written)
            carry_out_broken(making, place, seed, depth);
    }
    making->variables--;
}

/* Declares a local variable, which is visible up to the end of the list. */
static void put_local(struct making *making, size_t depth)
{
    direct(making, "#local V%zu = ", making->variables);
    double value = direct_number(making, depth);
    direct(making, ";\n");
    new_variable(making, value);
}

static void put_break(struct making *making)
{
    bool holds = true, alone = below(making, 4) == 0;
    if (!alone) {
        direct(making, "#if ");
        holds = condition(making, 0);
    }
    direct(making, alone ? " #break\n" : " #break #end\n");
    making->broken = !making->written && holds;
}

static void put_directive(struct making *making, enum place place, size_t depth)
{
    size_t count = place == NUMBER ? 5 : making->breakable ? 7 : 6;
    switch (below(making, count)) {
    case 0: put_for(making, place, depth); break;
    case 1: put_while(making, place, depth); break;
    case 2: put_if(making, place, depth); break;
    case 3: put_switch(making, place, depth); break;
    case 4: put_macro(making, place, depth); break;
    case 5: put_local(making, depth); break;
    default: put_break(making); break;
    }
}

/* ---- Numbers ------------------------------------------------------------ */

/* Writes a variable or a literal number. */
static double plain_number(struct making *making)
{
    size_t which = below(making, making->variables + 2);
    double value = (double)below(making, 5);
    if (which >= making->variables)
        put(making, "%g ", value);
    else if (making->written)
        put(making, "V%zu ", which);
    else
        put(making, "(%.17g) ", value = making->values[which]);
    return value;
}

static double sum(struct making *making, size_t depth)
{
    double before = making->value;
    put(making, "(");
    double first = plain_number(making);
    making->value = first;
    inside(making, TERMS, depth);
    put(making, ") ");
    first = making->value;
    making->value = before;
    return first;
}

static void put_vector(struct making *making, size_t depth)
{
    bool looped = below(making, 2);
    uint64_t seed = new_seed(making);
    size_t variable = new_variable(making, 0);
    put(making, "<");
    if (looped)
        direct(making, "#for (V%zu, 0, 2) ", variable);
    for (size_t i = 0; i < (looped && making->written ? 1 : 3); i++) {
        making->values[variable] = (double)i;
        if (looped) {
            carry_out(making, NUMBER, seed, depth);
        } else {
            making->variables--;
            carry_out(making, NUMBER, new_seed(making), depth);
            new_variable(making, 0);
        }
        if (!(looped && making->written) && i < 2)
            put(making, ", ");
    }
    if (looped)
        direct(making, "#if (V%zu < 2) , #end #end", variable);
    put(making, "> ");
    making->variables--;
}

static double number(struct making *making, size_t depth)
{
    bool breakable = making->breakable;
    if (depth == 0)
        return plain_number(making);
    switch (below(making, 4)) {
    case 0: return plain_number(making);
    case 1: return sum(making, depth - 1);
    default:
        making->breakable = false;
        put_directive(making, NUMBER, depth - 1);
        making->breakable = breakable;
        return making->value;
    }
}

/* ---- Contents of lists -------------------------------------------------- */

static void put_radius(struct making *making, size_t depth)
{
    put(making, "abs(");
    number(making, depth);
    put(making, ") + 1 ");
}

static void put_sphere(struct making *making, size_t depth)
{
    put(making, "sphere { ");
    put_vector(making, depth);
    put(making, ", ");
    put_radius(making, depth);
    if (below(making, 3) == 0) {
        put(making, "texture { ");
        inside(making, LAYER, depth);
        put(making, "} ");
    }
    inside(making, MODIFIERS, depth);
    put(making, "}\n");
}

static void put_solid(struct making *making, size_t depth)
{
    static const char *const words[] = { "union", "merge", "intersection" };
    size_t around = below(making, 4); /* the position of the spheres */
    put(making, "%s { ", words[below(making, COUNT(words))]);
    if (around != 1)
        put_sphere(making, 0);
    inside(making, OBJECTS, depth);
    if (around != 2)
        put_sphere(making, 0);
    inside(making, MODIFIERS, depth);
    put(making, "}\n");
}

/* Writes `count` numbers. A comma follows each of them. */
static void put_elements(struct making *making, size_t count, size_t depth,
                         double *values)
{
    for (size_t i = 0; i < count; i++) {
        carry_out(making, NUMBER, new_seed(making), depth);
        values[i] = making->value;
        direct(making, ", ");
    }
}

static void put_array(struct making *making, size_t depth)
{
    enum { MAX = 3 };
    double values[2 * MAX];
    size_t count = 1 + below(making, MAX), turns = 1 + below(making, 2);
    size_t variable = new_variable(making, 0);
    uint64_t seed = new_seed(making);
    direct(making, "#local A%zu = array[%zu] { #for (V%zu, 1, %zu) ", variable,
           turns * count, variable, turns);
    making->silent += !making->written;
    for (size_t i = 0; i < (making->written ? 1 : turns); i++) {
        making->values[variable] = (double)(i + 1);
        uint64_t state = making->state;
        making->state = seed;
        put_elements(making, count, depth, values + i * count);
        making->state = state;
    }
    making->silent -= !making->written;
    direct(making, "#end }\n");
    for (size_t i = 0; i < turns * count; i++) {
        put(making, "sphere { 0, abs(");
        if (making->written)
            put(making, "A%zu[%zu]", variable, i);
        else
            put(making, "%.17g", values[i]);
        put(making, ") + 1 }\n");
    }
    making->variables--;
}

static void put_object(struct making *making, size_t depth)
{
    switch (below(making, depth > 0 ? 4 : 2)) {
    case 2: put_array(making, depth); break;
    case 3: put_solid(making, depth - 1); break;
    default: put_sphere(making, depth); break;
    }
}

static void put_word(struct making *making, const char *word, size_t depth)
{
    put(making, "%s ", word);
    put_vector(making, depth);
}

static void put_pigment(struct making *making, size_t depth)
{
    put(making, "pigment { ");
    put_word(making, "rgb", depth);
    put(making, "} ");
}

static void put_finish(struct making *making, size_t depth)
{
    put(making, "finish { ");
    inside(making, FINISH, depth);
    put(making, "} ");
}

static void put_modifier(struct making *making, size_t depth)
{
    static const char *const words[] = { "translate", "rotate" };
    size_t which = below(making, 4);
    if (which < COUNT(words))
        put_word(making, words[which], depth);
    else if (which == 2)
        put_pigment(making, depth);
    else
        put_finish(making, depth);
}

static void put_layer(struct making *making, size_t depth)
{
    if (below(making, 2))
        put_pigment(making, depth);
    else
        put_finish(making, depth);
}

static void put_share(struct making *making, size_t depth)
{
    static const char *const words[] = { "ambient", "diffuse", "phong" };
    put(making, "%s abs(", words[below(making, COUNT(words))]);
    number(making, depth);
    put(making, ") ");
}

/* Adds a term. The value becomes the partial sum. */
static void put_term(struct making *making, size_t depth)
{
    double before = making->value;
    bool added = below(making, 2);
    put(making, added ? "+ " : "- ");
    double value = number(making, depth);
    making->value = added ? before + value : before - value;
}

static void put_item(struct making *making, enum place place, size_t depth)
{
    switch (place) {
    case OBJECTS: put_object(making, depth); break;
    case MODIFIERS: put_modifier(making, depth); break;
    case LAYER: put_layer(making, depth); break;
    case FINISH: put_share(making, depth); break;
    case TERMS: put_term(making, depth); break;
    case NUMBER: fail(); break;
    }
}

static void list(struct making *making, enum place place, size_t depth)
{
    size_t count = below(making, 4);
    for (size_t i = 0; i < count && !making->broken; i++)
        if (depth > 0 && below(making, 3) > 0)
            put_directive(making, place, depth - 1);
        else
            put_item(making, place, depth > 0 ? depth - 1 : 0);
}

struct text_buffer random_nest(uint64_t seed, bool written)
{
    struct making making = { .written = written, .state = seed };
    list(&making, OBJECTS, DEPTH);
    put(&making, " ");
    assert_false(making.text.failed);
    return making.text;
}
