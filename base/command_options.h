/* command_options.h - rows of options that have the same meaning in every program
 * (command.h). The parameter `place` of a macro is the offset of the option's value in
 * the structure of arguments.
 */
#ifndef BASE_COMMAND_OPTIONS_H
#define BASE_COMMAND_OPTIONS_H

#include "base/named_model.h"

/* clang-format off */
#define OPTION_MODEL(place) \
    { .name = "model", .value = "NAME|FILE", .kind = COMMAND_INPUT, \
      .offset = place, .preset_text = C205_DEFAULT_MODEL, \
      .choice = command_model_choice, .help = "machine model" }
#define OPTION_INCLUDE(place) \
    { .name = "include", .letter = 'I', .value = "DIR", \
      .kind = COMMAND_FOLDER, .many = true, .offset = place, \
      .help = "also search this folder for included files" }
#define OPTION_OUTPUT(place, text) \
    { .name = "output", .letter = 'o', .value = "FILE", .kind = COMMAND_OUTPUT, \
      .offset = place, .help = text }
#define OPTION_FLAG(option, place, text) \
    { .name = option, .kind = COMMAND_FLAG, .offset = place, .help = text }
/* Initialisers of a struct command_option, without the braces, so that the caller can
 * add members. */
#define OPERAND_ROW(form, type, place, text) \
    .value = form, .kind = type, .offset = place, .help = text
#define OPTION_ROW(option, form, type, place, text) \
    .name = option, OPERAND_ROW(form, type, place, text)
#define OPTION_COUNT(option, place, first, last, usual, text) \
    .name = option, .value = "N", .kind = COMMAND_COUNT, .offset = place, \
    .least = first, .most = (double)(last), .preset = usual, .help = text
/* Initialisers of a struct command that most commands share. The file must define the
 * lists options and operands. */
#define COMMAND_ROW(command, work, arguments, text) \
    .name = command, .summary = text, .function = work, \
    .arguments_size = sizeof(arguments), .options = options, .operands = operands
/* clang-format on */

#endif
