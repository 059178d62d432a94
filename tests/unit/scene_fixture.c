/* scene_fixture.c - lays out a scene and a program that defines its records. */
#include "scene_fixture.h"

#include "rt/layout/layout.h"
#include "rt/shapes/shape.h"
#include "vm/text.h"

/* Defines a label, unless it is already defined. */
static void put_label(const struct sink *sink, const char *name)
{
    if (name)
        sink_print(sink, "        .ifndef %s\n%s: .word 0\n        .endif\n", name,
                   name);
}

static void put_kernels(const struct sink *sink, const struct shape_kernels *kernels)
{
    put_label(sink, kernels->kernel);
    put_label(sink, kernels->normal);
    put_label(sink, kernels->solid);
    put_label(sink, kernels->state);
}

/* Returns a program that defines the records. Its kernels are only labels. */
static struct object *stage_program(void)
{
    const struct text *const texts[] = { kernel_texts, NULL };
    struct asm_options how = { .texts = texts };
    SCOPED_VALUE(diagnostics) errors = { 0 };
    SCOPED_VALUE(text_buffer) text = { 0 };
    struct sink sink = text_buffer_sink(&text);
    sink_put(&sink, "        .equ CROSSING_SIZE, 2\n"
                    "        .equ VALUE_SIZE, 3\n"
                    "        .equ LEVEL_SIZE, 10\n"
                    "        .equ GLOSS, 1\n"
                    "        .equ HIDDEN, 1\n"
                    "        .equ INTERIORS, 1\n"
                    "        .include \"frame/records.s\"\n"
                    "        .include \"light/interior.s\"\n"
                    "        .entry first\nfirst:  EXIT\n"
                    "        .data\n"
                    "transformed: .word 0\ninvisible: .word 0\n");
    for (size_t i = 0; i < PRIMITIVE_KINDS; i++) {
        put_kernels(&sink, &shapes[i]->kernels);
        put_kernels(&sink, &shapes[i]->other);
    }
    struct object *program = assemble_text("stage", text.text, &how, &errors);
    FAIL_IF(!program, "%s", errors.items[0].message);
    return program;
}

struct stage stage_of(const char *text, enum bounding bounding)
{
    struct frame_layout frame = { .width = 4, .height = 2, .rows = 2 };
    struct stage stage = { .scene = read_scene(text),
                           .program = stage_program(),
                           .machine = c205_new(prior_model, &failure) };
    stage.layout = layout_new(stage.program, stage.scene, bounding, NULL, NULL,
                              &failure);
    FAIL_IF(!stage.machine || !stage.layout
                || !c205_load(stage.machine, &stage.program->program, &failure)
                || !layout_put(stage.layout, stage.machine, &frame, &failure),
            "%s: %s", text, failure.message);
    return stage;
}

void stage_free(struct stage *stage)
{
    layout_free(stage->layout);
    c205_free(stage->machine);
    object_free(stage->program);
    scene_free(stage->scene);
}

uint64_t symbol(const struct stage *stage, const char *name)
{
    const struct asm_symbol *found = object_symbol(stage->program, name);
    FAIL_IF(!found, "no symbol %s", name);
    return (uint64_t)found->value;
}

c205_word stage_word(const struct stage *stage, uint64_t address)
{
    c205_word word;
    assert_true(c205_read(stage->machine, address, &word, 1));
    return word;
}

c205_word scene_word(const struct stage *stage, const char *name)
{
    return stage_word(stage, symbol(stage, name));
}

c205_word field_of(const struct stage *stage, uint64_t first, const char *size,
                   size_t i, const char *name)
{
    uint64_t words = symbol(stage, size) * i + symbol(stage, name);
    return stage_word(stage, first + 64 * words);
}

c205_word primitive(const struct stage *stage, size_t i, const char *name)
{
    return field_of(stage, scene_word(stage, "scene_primitives"), "P_SIZE", i, name);
}

c205_word region(const struct stage *stage, size_t i, const char *name)
{
    return field_of(stage, scene_word(stage, "scene_regions"), "R_SIZE", i, name);
}

uint64_t primitive_at(const struct stage *stage, size_t i)
{
    return scene_word(stage, "scene_primitives") + 64 * symbol(stage, "P_SIZE") * i;
}

void assert_integer(c205_word word, int64_t expected)
{
    assert_int_equal(c205_to_integer(word), expected);
}

void assert_number(c205_word word, double expected)
{
    assert_close(c205_to_double(word), expected, 1e-13 * fabs(expected));
}

void check_numbers(const struct stage *stage, size_t i, const char *name,
                   const double *expected, size_t count)
{
    uint64_t first = primitive_at(stage, i) + 64 * symbol(stage, name);
    for (size_t k = 0; k < count; k++)
        assert_number(stage_word(stage, first + 64 * k), expected[k]);
}
