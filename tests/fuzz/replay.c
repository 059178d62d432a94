/* replay.c - replay_TARGET FILE ...: a fuzz target without its fuzzer, once
 * on each file; whoever finds a fault ends the program. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { SIZE_MOST = 1 << 20 };

int main(int argc, char **argv)
{
    uint8_t *data = malloc(SIZE_MOST);

    for (int i = 1; data && i < argc; i++) {
        FILE *file = fopen(argv[i], "rb");
        size_t size;

        if (!file) {
            perror(argv[i]);
            return 1;
        }
        size = fread(data, 1, SIZE_MOST, file);
        fclose(file);
        LLVMFuzzerTestOneInput(data, size);
    }
    free(data);
    return data ? 0 : 1;
}
