/* rt205.c - the command: scenes traced by programs of the machine. */
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rt/command/cmd.h"

const char cmd_program[] = "rt205";

#define OPTION_SIZE \
    "  -W, --width N        pixels across (640; profile: 320, speedup: 400,\n" \
    "                       sweep: 256)\n" \
    "  -H, --height N       pixels down (480; profile: 240, speedup: 250,\n" \
    "                       sweep: 256)\n"
#define OPTION_QUEUE \
    "  --queue N            rays in the vector queue (2000)\n"
#define OPTION_VIEW \
    "  --distance D         from the eye to the middle of the shape (5)\n" \
    "  --angle DEGREES      that the rays span across (10; sweep hits: 37)\n"
#define OPTION_MODEL "  --model NAME|FILE    machine model (cyber205-2pipe)\n"
#define OPTION_BOUNDS \
    "  --historical         Steiner patches the way of 1984\n" \
    "  --no-bounds          every ray goes against every primitive\n" \
    "  --visible WAY        crossings of solids, vector form: stepping, every\n"
#define OPTION_JOBS \
    "  --jobs N             bands of the frame traced at a time (1)\n"
#define OPTION_READ \
    "  --strict             what would be replaced or left out is an error\n" \
    "  -I, --include DIR    look for included files there as well\n"
#define OPTION_JSON \
    "  --json FILE          write the results to a file as well\n"
#define OPTION_FORMAT \
    "  --format FORMAT      on stdout: text; csv; md, for GitHub; json, what\n" \
    "                       --json writes, and nothing else (text)\n"

static const struct command {
    const char *name;
    cmd_function *function;
    const char *options; /* letters, see options[] */
    const char *wants;   /* the file to name; NULL: none */
    size_t width, height;
    const char *summary, *help;
} commands[] = {
    { "render", cmd_render, "oWHMqmjsfIpJrBV", "a scene file", 640, 480,
      "trace a scene, write a picture",
      "rt205 render SCENE -o PICTURE\n"
      "  -o, --output FILE    the picture: .png .jpg (8-bit sRGB), .exr .tif\n"
      "                       (linear, with depth, normal and id)\n" OPTION_SIZE
      "  --mode MODE          scalar, kernels (as in 1984) or vector (vector)\n" OPTION_QUEUE
          OPTION_MODEL OPTION_BOUNDS OPTION_JOBS
      "  --resume FILE        keep finished bands there; go on from those it has\n"
      "  --half               16-bit colours in an .exr\n" OPTION_READ
          OPTION_JSON },
    { "profile", cmd_profile, "WHqmjsIpJBV", "a scene file", 320, 240,
      "what each part of a frame costs, in three stages",
      "rt205 profile SCENE     traces the frame three times: scalar; kernels, as\n"
      "                        in 1984 (vector intersection, all else serial);\n"
      "                        vector. The frames must be equal. Prints clocks\n"
      "                        part by part, speedups, Amdahl's prediction\n" OPTION_SIZE
          OPTION_QUEUE OPTION_MODEL OPTION_BOUNDS OPTION_JOBS OPTION_READ
              OPTION_JSON },
    { "speedup", cmd_speedup, "WHDAqmjPT", NULL, 400, 250,
      "scalar against vector, kernel by kernel",
      "rt205 speedup           the paper's Table 1 beside ours: 100,000 rays "
      "against\n"
      "                        a sphere, a cylinder, a Steiner patch, and "
      "more;\n"
      "                        below it where the clocks went, and what the "
      "root\n"
      "                        solver takes\n" OPTION_SIZE OPTION_VIEW
          OPTION_QUEUE
      "  --passes             the root solver's vectors pass by pass as well\n" OPTION_MODEL
      "                       (the CYBER 720 is projected with cyber720, "
      "but with\n"
      "                       cyber720-prior where this one has no fitted "
      "constant)\n" OPTION_JSON OPTION_FORMAT },
    { "sweep", cmd_sweep, "oWHDAqMmjspIJBVTN",
      "what to sweep, then a scene file or a primitive", 256, 256,
      "clocks per ray as one thing changes, as table and plot",
      "rt205 sweep queue  SCENE|PRIMITIVE  lengths of the queue\n"
      "rt205 sweep pipes  SCENE|PRIMITIVE  1, 2, 4 pipes; 64, 32 bits\n"
      "rt205 sweep hits   PRIMITIVE        how many of the rays hit it\n"
      "rt205 sweep length SCENE|PRIMITIVE  as many rays as the queue is long\n"
      "                        where a queue costs less than scalar code\n"
      "  a primitive: sphere, cylinder, Steiner, 'Steiner, ours', torus; its "
      "kernel\n"
      "  and calls count.  A scene: a name with a / or ending in .pov; all of "
      "its\n"
      "  frame counts.  Scalar and vector frames must be equal.\n"
      "  -o, --output FILE    a plot, NAME.svg, by gnuplot; NAME.dat and "
      "NAME.gp too\n"
      "  --points N,N,..      these lengths (queue, length: 1, 2, 4 .. 65535, "
      "2000)\n" OPTION_SIZE OPTION_VIEW
      "  --mode MODE          of the queues: kernels (as in 1984), vector "
      "(vector)\n"
      "  --queue N            rays in the queue (pipes, hits: 2000)\n" OPTION_MODEL
          OPTION_BOUNDS OPTION_JOBS OPTION_READ OPTION_JSON OPTION_FORMAT },
    { "quartic", cmd_quartic, "MqmjaRF", "a file of polynomials", 1, 1,
      "the real roots of polynomials, and what they cost",
      "rt205 quartic FILE.csv  lines c4,c3,c2,c1,c0 and perhaps a bound (0);\n"
      "                        prints index: root root ..., the real roots\n"
      "                        above the bound, nearest first; then the "
      "clocks\n"
      "  --all                all roots (this is what happens anyway)\n"
      "  --first              the first root of each alone\n"
      "  --mode MODE          scalar or vector (vector)\n"
      "  --queue N            polynomials in the vector queue (2000)\n"
      "  --falsi RULE         paper, illinois, pegasus, anderson-bjorck; or "
      "all:\n"
      "                       a table of their clocks instead of the roots\n" OPTION_MODEL
          OPTION_JSON },
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static const struct option options[] = {
    { "output", required_argument, NULL, 'o' },
    { "width", required_argument, NULL, 'W' },
    { "height", required_argument, NULL, 'H' },
    { "mode", required_argument, NULL, 'M' },
    { "distance", required_argument, NULL, 'D' },
    { "angle", required_argument, NULL, 'A' },
    { "queue", required_argument, NULL, 'q' },
    { "model", required_argument, NULL, 'm' },
    { "json", required_argument, NULL, 'j' },
    { "format", required_argument, NULL, 'T' },
    { "include", required_argument, NULL, 'I' },
    { "strict", no_argument, NULL, 's' },
    { "half", no_argument, NULL, 'f' },
    { "historical", no_argument, NULL, 'p' },
    { "no-bounds", no_argument, NULL, 'B' },
    { "visible", required_argument, NULL, 'V' },
    { "jobs", required_argument, NULL, 'J' },
    { "resume", required_argument, NULL, 'r' },
    { "all", no_argument, NULL, 'a' },
    { "points", required_argument, NULL, 'N' },
    { "passes", no_argument, NULL, 'P' },
    { "first", no_argument, NULL, 'R' },
    { "falsi", required_argument, NULL, 'F' },
    { NULL, 0, NULL, 0 },
};

static bool parse_count(const char *text, size_t most, size_t *count)
{
    char *end;
    unsigned long long value = strtoull(text, &end, 10);

    *count = (size_t)value;
    return *text >= '0' && *text <= '9' && *end == '\0' && value >= 1
           && value <= most;
}

static bool parse_positive(const char *text, double below, double *value)
{
    char *end;

    *value = strtod(text, &end);
    return end != text && *end == '\0' && *value > 0 && *value < below;
}

/* Numbers that rise, with commas between. */
static bool parse_points(const char *text, struct cmd_arguments *arguments)
{
    size_t count = 0, last = 0;

    do {
        char *end;
        unsigned long value = strtoul(text, &end, 10);

        if (*text < '0' || *text > '9' || value <= last
            || value > TRACE_QUEUE_MOST || count == SWEEP_LENGTHS_MOST
            || (*end != ',' && *end != '\0'))
            return false;
        arguments->points[count++] = last = (size_t)value;
        text = end;
    } while (*text++ == ',');
    arguments->point_count = count;
    return true;
}

static bool format_named(const char *name, enum cmd_format *format)
{
    static const char *const names[] = { [FORMAT_TEXT] = "text",
                                         [FORMAT_CSV] = "csv",
                                         [FORMAT_MARKDOWN] = "md",
                                         [FORMAT_JSON] = "json" };

    for (int i = 0; i <= FORMAT_JSON; i++) {
        *format = (enum cmd_format)i;
        if (strcmp(names[i], name) == 0)
            return true;
    }
    return false;
}

static bool take(int letter, struct cmd_arguments *arguments)
{
    switch (letter) {
    case 'o': arguments->output = optarg; return true;
    case 'm': arguments->model = optarg; return true;
    case 'j': arguments->json = optarg; return true;
    case 'T': return format_named(optarg, &arguments->format);
    case 's': arguments->strict = true; return true;
    case 'f': arguments->half = true; return true;
    case 'p': arguments->trace.historical = true; return true;
    case 'B': arguments->trace.no_bounds = true; return true;
    case 'V': return visible_named(optarg, &arguments->trace.visible);
    case 'r': arguments->resume = optarg; return true;
    case 'J':
        return parse_count(optarg, TRACE_JOBS_MOST, &arguments->trace.jobs);
    case 'N': return parse_points(optarg, arguments);
    case 'a': arguments->first = false; return true;
    case 'R': arguments->first = true; return true;
    case 'P': arguments->passes = true; return true;
    case 'F':
        arguments->compare = strcmp(optarg, "all") == 0;
        return arguments->compare || falsi_named(optarg, &arguments->falsi);
    case 'W':
        return parse_count(optarg, TRACE_PIXELS_MOST,
                           &arguments->trace.width);
    case 'H':
        return parse_count(optarg, TRACE_PIXELS_MOST,
                           &arguments->trace.height);
    case 'D': return parse_positive(optarg, 1e6, &arguments->view.distance);
    case 'A': return parse_positive(optarg, 180, &arguments->view.angle);
    case 'q':
        return parse_count(optarg, TRACE_QUEUE_MOST, &arguments->trace.queue);
    case 'M': return trace_mode_named(optarg, &arguments->trace.mode);
    default: {
        const char **end = arguments->search;

        while (*end)
            end++;
        *end = optarg;
        return true;
    }
    }
}

static bool parse_options(int argc, char **argv, const char *allowed,
                          struct cmd_arguments *arguments)
{
    int letter;

    opterr = 0;
    while ((letter = getopt_long(argc, argv, ":o:W:H:I:", options, NULL))
           != -1) {
        const char *word = argv[optind - 1];

        if (word == optarg)
            word = argv[optind - 2];
        if (letter == ':')
            cmd_usage(argv[0], "%s needs an argument", word);
        else if (letter == '?' || !strchr(allowed, letter))
            cmd_usage(argv[0], "no such option: %s", word);
        else if (!take(letter, arguments))
            cmd_usage(argv[0], "%s: wrong argument: %s%s", word, optarg,
                      letter == 'T' ? " (text, csv, md or json)" : "");
        else
            continue;
        return false;
    }
    return true;
}

static bool take_scene(const struct command *command, int argc, char **argv,
                       struct cmd_arguments *arguments)
{
    int given = argc - optind;
    int wanted = !command->wants ? 0 : command->function == cmd_sweep ? 2 : 1;

    if (given > wanted)
        cmd_usage(command->name, "too many arguments: %s", argv[argc - 1]);
    else if (given < wanted)
        cmd_usage(command->name, "name %s", command->wants);
    else if (arguments->trace.width
             > TRACE_PIXELS_MOST / arguments->trace.height)
        cmd_usage(command->name, "at most %zu pixels", TRACE_PIXELS_MOST);
    else {
        arguments->sweep = wanted == 2 ? argv[optind] : NULL;
        arguments->scene = wanted > 0 ? argv[argc - 1] : NULL;
        return true;
    }
    return false;
}

static bool asks_for_help(int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++)
        if (strcmp(argv[i], "--help") == 0)
            return true;
    return false;
}

static int start(const struct command *command, int argc, char **argv)
{
    struct cmd_arguments arguments = {
        .command = command->name,
        .model = "cyber205-2pipe",
        .falsi = FALSI_DEFAULT,
        .trace = { .mode = TRACE_VECTOR,
                   .width = command->width,
                   .height = command->height,
                   .queue = TRACE_QUEUE },
        .view = { .distance = SPEEDUP_DISTANCE },
    };
    int code = CMD_USAGE;

    if (asks_for_help(argc, argv)) {
        printf("rt205 %s - %s\n\n%s", command->name, command->summary,
               command->help);
        return CMD_DONE;
    }
    arguments.search = calloc((size_t)argc + 1, sizeof *arguments.search);
    if (!arguments.search)
        return cmd_failed(command->name, "no memory");
    if (parse_options(argc, argv, command->options, &arguments)
        && take_scene(command, argc, argv, &arguments))
        code = command->function(&arguments);
    free(arguments.search);
    return code;
}

static int finish(const char *name, int code)
{
    if (fflush(stdout) != 0 || ferror(stdout))
        return cmd_failed(name, "standard output: write error");
    return code;
}

static void print_summary(FILE *file)
{
    fputs("rt205 COMMAND [OPTIONS] - a ray tracer on a CYBER 205 style "
          "machine\n",
          file);
    for (size_t i = 0; i < COMMANDS; i++)
        fprintf(file, "  %-8s %s\n", commands[i].name, commands[i].summary);
    fputs("rt205 COMMAND --help tells more of each\n", file);
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        print_summary(stderr);
        return CMD_USAGE;
    }
    if (strcmp(argv[1], "--help") == 0) {
        print_summary(stdout);
        return finish("--help", CMD_DONE);
    }
    for (size_t i = 0; i < COMMANDS; i++)
        if (strcmp(argv[1], commands[i].name) == 0)
            return finish(argv[1], start(&commands[i], argc - 1, argv + 1));
    fprintf(stderr, "rt205: no such command: %s\n", argv[1]);
    print_summary(stderr);
    return CMD_USAGE;
}
