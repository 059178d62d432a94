/* command_options.h - options with the same meaning in every program: rows for the
 * lists of command.h. Each takes the offset of its value.
 */
#ifndef BASE_COMMAND_OPTIONS_H
#define BASE_COMMAND_OPTIONS_H

#include "base/command.h"
#include "vm/c205.h"

/* The built-in models. */
command_choice command_model_choice;

/* clang-format off */
#define COMMAND_OPTION_MODEL(place) \
    { .name = "model", .value = "NAME|FILE", .kind = COMMAND_INPUT, \
      .offset = place, .preset_text = C205_DEFAULT_MODEL, \
      .choice = command_model_choice, .help = "machine model" }
#define COMMAND_OPTION_INCLUDE(place) \
    { .name = "include", .letter = 'I', .value = "DIR", \
      .kind = COMMAND_FOLDER, .many = true, .offset = place, \
      .help = "also search this folder for included files" }
/* clang-format on */

#endif
