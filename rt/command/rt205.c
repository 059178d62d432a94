/* rt205.c - the command rt205: traces scenes with programs of the machine. */
#include "rt/command/commands.h"
#include "vm/c205.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

/* Prevents the C library from returning freed memory to the host. Machines of several
 * megabytes are created and freed often; returning the memory each time would take a
 * third of the time of heat and mass. */
static void keep_memory(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 512 << 20);
#endif
}

int main(int argc, char **argv)
{
    static const struct command *const commands[] = { COMMANDS(COMMAND_ADDRESS) NULL };
    static const struct command_example files[] = {
        { "NAME.pov", "A scene, in the supported part of POV-Ray's language." },
        { "NAME.model",
          "A machine model: time constants, each with unit and source; or changes to "
          "a built-in model." },
        { "rt205_oiio.so",
          "The library that writes pictures with OpenImageIO. It is searched in the "
          "folder of the environment variable RT205_LIBDIR, in the folder of rt205, "
          "and in its ../lib/rt205." },
        { NULL, NULL }
    };
    static const struct command_program program = {
        .name = "rt205",
        .summary = "a ray tracer on a CYBER 205 style machine",
        .version = C205_VERSION,
        .commands = commands,
        .files = files,
    };
    keep_memory();
    return command_main(&program, argc, argv);
}
