/* replay.c - replay_TARGET FILE ...: runs a fuzz target on each file without its
 * fuzzer. A fault ends it. Exit status 3: no file passes its first check. */
#include <stdio.h>

#include "tests/fuzz/fuzz.h"

enum { MAX_SIZE = 1 << 20, ALL_REFUSED = 3 };

int main(int argc, char **argv)
{
    uint8_t *data = malloc(MAX_SIZE);
    for (int i = 1; data && i < argc; i++) {
        FILE *file = fopen(argv[i], "rb");
        if (!file) {
            perror(argv[i]);
            return 1;
        }
        size_t size = fread(data, 1, MAX_SIZE, file);
        fclose(file);
        LLVMFuzzerTestOneInput(data, size);
    }
    free(data);
    return !data ? 1 : fuzz_accepted ? 0 : ALL_REFUSED;
}
