/* scene.c - a client of the installed libraries: traces a small scene and prints the
 * number of hits and the frame's checksum. */
#include <rt/scene/language/scene_read.h>
#include <rt/trace/trace.h>

#include <stdio.h>

static const char text[] = "camera { location <0, 0, -5> look_at 0 }\n"
                           "light_source { <-5, 9, -9>, 1 }\n"
                           "sphere { 0, 1 pigment { rgb <1, .5, 0> } }\n";

static int trace(const struct scene *scene, const c205_model *model,
                 enum trace_mode mode)
{
    const struct trace_options options = {
        .mode = mode, .width = 40, .height = 30, .queue = TRACE_QUEUE, .model = model
    };
    c205_error error = { "" };
    struct trace *trace = trace_new(scene, &options, &error);
    int code = !trace || !trace_run(trace, &error);
    if (code)
        fprintf(stderr, "%s\n", error.message);
    else
        printf("%s: %zu hits, %016llX\n", trace_mode_name(mode), trace_hits(trace),
               (unsigned long long)trace_checksum(trace));
    trace_free(trace);
    return code;
}

int main(void)
{
    const struct scene_options how = { .width = 40, .height = 30 };
    struct diagnostics found = { 0 };
    c205_error error = { "" };
    c205_model *model = c205_model_find("cyber205-2pipe", &error);
    struct scene *scene = scene_read_text("client", text, &how, &found);
    int code = !model || !scene || trace(scene, model, TRACE_SCALAR)
               || trace(scene, model, TRACE_VECTOR);
    diagnostics_print(&found, stderr);
    diagnostics_free(&found);
    scene_free(scene);
    c205_model_free(model);
    return code;
}
