#!/bin/sh
# embed.sh NAME FOLDER FILE ... - writes text files as C to stdout, each with its path
# within FOLDER:
#
#   struct text { const char *name; const char *const *lines; };
#   const struct text NAME[] = { ..., { NULL, NULL } };
#   const char *const NAME_names[] = { ..., NULL }; the paths without suffixes
#
# A text is an array of its lines, each with its newline, and ends with NULL, because
# C99 guarantees only 4,095 characters in one string. With TITLES=yes in the environment
# an .md file has only its first line.
set -eu
table=$1
folder=$2
shift 2
printf '/* made by vm/embed.sh */\n#include "vm/text.h"\n'
n=0
for file in "$@"; do
    printf 'static const char *const lines%d[] = {\n' "$n"
    case ${TITLES-}$file in
    yes*.md) most=1 ;;
    *) most='$' ;;
    esac
    sed "${most}q" "$file" | sed 's/\\/\\\\/g; s/"/\\"/g; s/?/\\?/g; s/.*/    "&\\n",/'
    printf '    0\n};\n'
    n=$((n + 1))
done
printf 'const struct text %s[] = {\n' "$table"
n=0
for file in "$@"; do
    printf '    { "%s", lines%d },\n' "${file#"$folder"/}" "$n"
    n=$((n + 1))
done
printf '    { 0, 0 }\n};\n'
printf 'const char *const %s_names[] = {\n' "$table"
for file in "$@"; do
    stem=${file#"$folder"/}
    printf '    "%s",\n' "${stem%.*}"
done
printf '    0\n};\n'
