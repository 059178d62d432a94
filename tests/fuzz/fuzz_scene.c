/* fuzz_scene.c - reads any bytes as a scene, prints the reports and frees the scene. */
#include "rt/scene/language/scene_read.h"

#include "tests/fuzz/fuzz.h"

#include <string.h>

bool fuzz_accepted;

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const struct scene_options options = { .width = 640,
                                                  .reading_most = 1000000,
                                                  .height = 480 };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    FILE *out = fopen("/dev/null", "w");
    FREED char *text = malloc(size + 1);
    if (out && text) {
        memcpy(text, data, size);
        text[size] = '\0';
        SCOPED(scene) *scene = scene_read_text("fuzz.pov", text, &options, &reports);
        fuzz_accepted = fuzz_accepted || scene;
        diagnostics_print(&reports, out);
    }
    if (out)
        fclose(out);
    return 0;
}
