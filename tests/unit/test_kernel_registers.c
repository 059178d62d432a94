/* test_kernel_registers.c - registers that kernels share are compared with their
 * declarations. All programs are assembled, and traced with a check of each register. A
 * kernel that reads a register that another kernel has changed, or that saves a
 * register that it does not change, fails here.
 *
 *     test_kernel_registers [SCENES [SEED]]
 */
#define SMALL_FRAMES
#include "tests/unit/asm_helper.h"
#include "tests/unit/random_solids.h"

#include "rt/shapes/shape.h"
#include "rt/layout/program.h"
#include "rt/heat/emission.h"
#include "rt/trace/form.h"
#include "rt/roots/roots.h"
#include "rt/study/speedup.h"
#include "tests/oracle/ray_query_rules.h"
#include "tests/oracle/points.h"
#include "tests/oracle/register_owners.h"
#include "vm/text.h"

enum { COLUMNS = 8, ROWS = 6 };
static size_t scene_count = 8;

/* ---- Records of the assembler ------------------------------------------- */

static void check_assembled(const char *kernel, const struct asm_define *defines)
{
    const struct text *const texts[] = { kernel_texts, shape_texts, NULL };
    const char *const search[] = { "rt/kernels", NULL };
    const struct asm_options how = { .defines = defines,
                                     .texts = texts,
                                     .search = search };
    SCOPED_VALUE(diagnostics) found = { 0 };
    char text[100];
    snprintf(text, sizeof text, "        .include \"%s\"\n", kernel);
    SCOPED(object) *program = assemble_text("test", text, &how, &found);
    diagnostics_print(&found, stderr);
    assert_int_equal(found.count, 0);
    assert_non_null(program);
}

/* Assembles all programs of the kernels in both forms and in each variant. */
TEST(assembled)
{
    static const struct asm_define switches[] = {
        { NULL, 0 },
        { "HISTORICAL", 1 },
        { "BLOB_PIECES", 4 },
        { "FALSI", FALSI_PAPER },
        { "FALSI", FALSI_ILLINOIS },
        { "FALSI", FALSI_PEGASUS },
        { "FALSI", FALSI_ANDERSON_BJORCK },
        { "VISIBLE", VISIBLE_STEPPING },
        { "VISIBLE", VISIBLE_EVERY },
        { "LATHES", 1 },
        { "QUADRATIC_PRISMS", 1 },
        { "LATTICE", 1 },
        { "ADAPTIVE", 32 },
    };
    size_t programs = 0;
    for (const struct text *kernel = kernel_texts; kernel->name; kernel++) {
        /* The entry of some programs is in a file of points/. */
        bool is_program = false;
        for (const char *const *line = kernel->lines; *line; line++)
            is_program |= strstr(*line, "        .entry ")
                          || strstr(*line, "        .include \"points/points.s");
        if (!is_program)
            continue;
        programs++;
        for (size_t i = 0; i < 2 * COUNT(switches); i++) {
            const struct asm_define defines[] = { { "QUEUE", 10 },
                                                  { i % 2 ? "SCALAR" : "VECTOR", 1 },
                                                  switches[i / 2],
                                                  { NULL, 0 } };
            check_assembled(kernel->name, defines);
        }
    }
    /* a smaller number would mean that programs are missing */
    assert_true(programs >= 20);
}

/* The formulations of the cylinder that the study compares. */
TEST(formulations)
{
    for (size_t i = 0; i < speedup_formulation_count; i++) {
        const struct speedup_subject *subject = &speedup_formulations[i];
        const struct asm_define defines[] = {
            { "QUEUE", 10 },
            { subject->historical ? "HISTORICAL" : "PRESENT", 1 },
            { subject->variant, 1 },
            { NULL, 0 },
        };
        check_assembled("frame/frame_scalar.s", defines);
        check_assembled("frame/frame_vector.s", defines);
    }
}

static void check_fit_program(const char *path)
{
    check_assembled(path, NULL);
}

/* The programs that the fit measures. They call routines as the kernels do. */
TEST_CALL(fit_programs,
          assert_true(each_file("rt/study/fit/programs/*.s", check_fit_program) > 4))

/* ---- Reports of runs ---------------------------------------------------- */

static void run_watched(const struct object *program, c205 *machine, const char *what)
{
    SCOPED(register_owners) *owners = NON_NULL(register_owners_new(program));
    struct sink sink = stream_sink(stderr);
    assert_int_equal(c205_loaded_program(machine),
                     c205_program_hash(&program->program));
    assert_true(c205_listen(machine, register_owners_listen, owners));
    bool good = program_run(machine, NULL, NULL, NULL, &failure);
    register_owners_print(owners, &sink);
    FAIL_IF(!good || register_owners_found(owners) > 0, "%s: %s", what,
            failure.message);
    assert_true(register_owners_read(owners) > 1000);
}

static void trace_watched(const struct scene *scene,
                          const struct trace_options *options, const char *what)
{
    SCOPED(trace) *trace = trace_new(scene, options, &failure);
    SCOPED(c205) *machine = trace ? trace_machine(trace, 0, &failure) : NULL;
    FAIL_IF(!machine, "%s: %s", what, failure.message);
    run_watched(trace_program(trace), machine, what);
}

/* Traces a frame, and all crossings along lines, in all modes, with the current
 * no_bounds, historical, variant and visible. */
static void trace_modes(const struct scene *scene, size_t queue, const char *what)
{
    enum { LINES = 20 };
    struct trace_options options = ON_PRIOR(.width = COLUMNS, .height = ROWS,
                                            .queue = queue,
                                            .historical = traced.historical,
                                            .variant = traced.variant,
                                            .visible = traced.visible,
                                            .no_bounds = traced.no_bounds);
    struct ray_query_options along = ON_PRIOR(.queue = queue, .normals = true,
                                              .bodies = true, .behind = 1,
                                              .no_bounds = traced.no_bounds);
    struct scene_ray list[LINES];
    draw_camera_lines(&traced.random, scene, list, LINES);
    for (int mode = 0; mode < TRACE_MODES; mode++) {
        options.mode = along.mode = (enum trace_mode)mode;
        trace_watched(scene, &options, what);
        SCOPED(ray_query) *lines = ray_query_new(scene, &along, &failure);
        SCOPED(c205) *machine = lines ? ray_query_machine(lines, list, LINES, &failure)
                                      : NULL;
        FAIL_IF(!machine, "%s: %s", what, failure.message);
        run_watched(ray_query_program(lines), machine, what);
    }
}

TEST(cylinders)
{
    static const char text[] = HEAD
        "camera { location <0, 1, -6> look_at 0 }\n"
        "cylinder { -x, <1, .5, .3>, .6 }"
        "cylinder { <-1, 1, -1>, <1, 1, 1>, .4 open rotate 30*x }";
    SCOPED(scene) *scene = read_text(text);
    for (size_t i = 0; i < speedup_formulation_count; i++) {
        traced.historical = speedup_formulations[i].historical;
        traced.variant = speedup_formulations[i].variant;
        trace_modes(scene, COLUMNS - 1, speedup_formulations[i].name);
    }
    traced.historical = false;
    traced.variant = NULL;
}

static struct scene *read_file(const char *path)
{
    const struct scene_options reading = { .width = COLUMNS,
                                           .height = ROWS,
                                           .read_raster = picture_read_raster };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    return NON_NULL(scene_read(path, &reading, &reports));
}

/* Two passes use nearly all code that is only assembled for some scenes. */
TEST(adaptive)
{
    static const char path[] = "tests/scenes/together.pov";
    struct trace_options options = ON_PRIOR(.width = 3 * COLUMNS, .height = 3 * ROWS,
                                            .samples = 3, .threshold = .05,
                                            .queue = COLUMNS - 1);
    SCOPED(scene) *scene = read_file(path);
    for (int mode = 0; mode < TRACE_MODES; mode++) {
        options.mode = (enum trace_mode)mode;
        trace_watched(scene, &options, path);
    }
}

static void trace_file(const char *path)
{
    SCOPED(scene) *scene = read_file(path);
    trace_modes(scene, COLUMNS - 1, path);
}

TEST_CALL(scenes, assert_true(each_file("scenes/*.pov", trace_file) > 10))

/* ---- Superfluous saves -------------------------------------------------- */

enum { MAX_AREAS = 16 };

/* The area in which a kernel saves registers while it loads its constants. */
struct area {
    uint64_t address;
    unsigned first, count;
    bool changed[C205_REGISTERS]; /* the register was changed before a restore at least
                                   * once */
};

static struct saves {
    struct area areas[MAX_AREAS];
    size_t count;
    c205_word before[C205_REGISTERS]; /* contents before the instruction */
} saves;

/* Returns the area at the address of a descriptor. */
static struct area *area_at(c205_word descriptor)
{
    uint64_t address = descriptor & 0xFFFFFFFFFFFF;
    for (size_t i = 0; i < saves.count; i++)
        if (saves.areas[i].address == address)
            return &saves.areas[i];
    return NULL;
}

static void listen_to_saves(void *context UNUSED, const c205 *machine,
                            const c205_event *event)
{
    const c205_fields *fields = &event->fields;
    if (event->kind != C205_EVENT_INSTRUCTION)
        return;
    if (event->insn->format == C205_FORMAT_SWAP && fields->r != 0) {
        c205_word to = saves.before[fields->t != 0 ? fields->t : fields->r];
        struct area *area = area_at(to);
        if (fields->t != 0 && !area) {
            assert_true(saves.count < MAX_AREAS);
            saves.areas[saves.count++] = (struct area){
                .address = to & 0xFFFFFFFFFFFF,
                .first = fields->s,
                .count = (unsigned)(to >> 48),
            };
        }
        bool restores = fields->t == 0 && area && area->first == fields->s;
        for (unsigned k = fields->s; restores && k < area->first + area->count; k++)
            area->changed[k] |= saves.before[k] != c205_register(machine, k);
    }
    for (unsigned k = 0; k < C205_REGISTERS; k++)
        saves.before[k] = c205_register(machine, k);
}

/* A kernel must not save registers that it does not change. The main cost of a short
 * kernel is its call, which such saves would increase. */
TEST(nothing_is_saved_in_vain)
{
    static const char text[] = HEAD
        "camera { location <0, 1, -6> look_at 0 }\n"
        "sphere { <-2, 1, 0>, .7 } box { <-1, .2, 0>, <0, 1, 1> }"
        "cylinder { x, <1.7, 1.5, .3>, .4 } plane { <.1, 1, .2>, -1.5 }"
        "cylinder { -x, <1, -.5, 0>, .3 open scale <.9, 1.2, 1.1>"
        " rotate <30, 20, 40> translate <.1, -.2, .3> }"
        "cone { <2, 0, 0>, .5, <2.2, 1, .1>, .2 }"
        "quadric { 1, <.3, 0, .2>, <.1, 0, .3>, -.2 }";
    struct trace_options options = ON_PRIOR(.mode = TRACE_SCALAR, .width = 4 * COLUMNS,
                                            .height = 4 * ROWS, .queue = 1);
    SCOPED(scene) *scene = read_text(text);
    for (int historical = 0; historical < 2; historical++) {
        memset(&saves, 0, sizeof saves);
        options.historical = historical;
        SCOPED(trace) *trace = trace_new(scene, &options, &failure);
        SCOPED(c205) *machine = trace ? trace_machine(trace, 0, &failure) : NULL;
        REQUIRE(machine && c205_listen(machine, listen_to_saves, NULL)
                && program_run(machine, NULL, NULL, NULL, &failure));
        assert_in_range(saves.count, 6, MAX_AREAS);
        for (size_t i = 0; i < saves.count; i++) {
            const struct area *area = &saves.areas[i];
            for (unsigned k = 0; k < area->count; k++)
                FAIL_IF(!area->changed[area->first + k],
                        "the kernel that saves r%u to r%u at %llX does not use r%u",
                        area->first, area->first + area->count - 1,
                        (unsigned long long)area->address, area->first + k);
        }
    }
}

/* ---- Random scenes ---------------------------------------------------- */

TEST(random_solids)
{
    static char text[100000];
    static const size_t queues[] = { 1, COLUMNS - 1, 2000 };
    solids.clear = solids.surfaces = traced.reported = true;
    for (size_t i = 0; i < scene_count; i++) {
        solids.gridded = below(2);
        traced.historical = below(3) == 0;
        traced.no_bounds = below(4) == 0;
        traced.visible = (enum visible)below(CSG_METHODS);
        text[0] = '\0';
        add_text(text, sizeof text,
                 "#version 3.7; global_settings { assumed_gamma 1 "
                 "max_trace_level 3 }\nbackground { rgb <.2, .3, .5> }\n"
                 "light_source { <%.1f, 8, -7>, .7 }\n"
                 "light_source { <7, 3, -%.2f>, rgb <.3, .2, .4> }\n"
                 "camera { location <%.3f, %.3f, -5> look_at 0 angle 45 }\n",
                 between(-7, 7), between(2, 6), between(-2, 2), between(-2, 2));
        for (size_t k = 1 + below(2); k > 0; k--)
            add_solid(text, sizeof text, below(3));
        SCOPED(scene) *scene = read_text(text);
        trace_modes(scene, queues[below(3)], text);
    }
}

/* ---- The root solver ---------------------------------------------------- */

TEST(roots)
{
    enum { POLYNOMIALS = 60 };
    struct polynomial polynomials[POLYNOMIALS];
    for (int i = 0; i < POLYNOMIALS; i++) {
        for (int j = 0; j < 5; j++)
            polynomials[i].c[j] = c205_from_double(below(6) ? between(-2, 2) : 0);
        polynomials[i].bound = C205_MACHINE_ZERO;
    }
    for (int i = 0; i < 2 * TRACE_FORMS * FALSI_RULES; i++) {
        struct roots_options options = ON_PRIOR(
                .mode = (enum trace_mode)(i % TRACE_FORMS), .queue = 7,
                .first = i / TRACE_FORMS % 2,
                .falsi = (enum falsi)(i / TRACE_FORMS / 2));
        const struct asm_define defines[] = { { "QUEUE", 7 },
                                              { "FALSI", options.falsi },
                                              { NULL, 0 } };
        struct root_search *search = roots_new(polynomials, POLYNOMIALS, &options,
                                               &failure);
        SCOPED(object) *program = form_assemble_beside("roots/roots", options.mode,
                                                       defines, &failure);
        REQUIRE(search && program);
        run_watched(program, (c205 *)(uintptr_t)roots_machine(search), "roots");
        roots_free(search);
    }
}

/* ---- Points -------------------------------------------------------------- */

TEST(points)
{
    static const struct point_choice choice = { .seed = 3, .m = 10 };
    for (int i = 0; i < 2 * POINT_FORMS; i++) {
        const struct point_kind kind = {
            .form = (enum point_form)(i % POINT_FORMS),
            .lattice = i / POINT_FORMS,
            .numbers = true,
            .queue = 7,
            .points = 500,
            .coordinates = STREAM_DRAWS,
        };
        SCOPED(point_maker) *maker = point_maker_new(&kind, &failure);
        c205 *machine = NON_NULL(maker ? point_maker_load(maker, &choice, &failure)
                                       : NULL);
        run_watched(point_maker_program(maker), machine, "points");
    }
}

/* ---- Emission ------------------------------------------------------------ */

/* A shape for each kernel. */
TEST(emission)
{
    static const struct emission_choice choice = { .seed = 3, .m = 10 };
    SCOPED(scene) *scene = read_text(
        HEAD "sphere { 0, 1 } torus { 1, .3 } cone { 0, 1, y, .5 } box { 0, 1 }"
             "object { steiner_patch { x, y, z, x + y, y + z, z + x } }");
    for (size_t i = 0; i < 2 * TRACE_FORMS * scene->primitive_count; i++) {
        const struct primitive *primitive = &scene->primitives[i / TRACE_FORMS / 2];
        struct emission_options options = ON_PRIOR(.mode = (enum trace_mode)(
                                                       i % TRACE_FORMS),
                                                   .queue = 7, .points = 200,
                                                   .lattice = i / TRACE_FORMS % 2);
        SCOPED(emission) *emission = emission_new(primitive, &options, &failure);
        SCOPED(c205) *machine = NON_NULL(
            emission ? emission_load(emission, &choice, &failure) : NULL);
        run_watched(emission_program(emission), machine, "emission");
    }
}

COUNT_AND_SEED(scene_count, traced.random);
