#!/bin/sh
# check_pages.sh BUILD - checks the manual pages and completions that the programs
# print. Every option must be included, groff must report no problem, and bash and (if
# it is installed) fish must complete.
set -u
build=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
PATH=$build:$PATH # the scripts of the shells call the programs
mkdir folder
touch folder.s
passed=0 failed=0

verdict() { # STATUS TEXT: counts a check; the text is the message if it fails
    if [ "$1" -eq 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL $2"
    fi
}

found_for() { # PROGRAM WORD ..: completions of the last word, sorted
    found=$(bash -c '
        . "$0"
        COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
        _$1
        printf "%s\n" "${COMPREPLY[@]}"' "$work/$1.bash" "$@" 2>&1 |
        sort | tr '\n' ' ')
}

completes() { # EXPECTED PROGRAM WORD ..: candidates are separated by blanks
    expected=$1
    shift
    found_for "$@"
    [ "${found% }" = "$expected" ]
    verdict $? "bash completes '$*' to '$found', not '$expected'"
}

offers() { # WORD PROGRAM WORD ..: the word must be one of the completions
    offered=$1
    shift
    found_for "$@"
    case " $found" in
    *" $offered "*) verdict 0 "" ;;
    *) verdict 1 "bash does not complete '$*' to $offered" ;;
    esac
}

# The manual page must have the words of the help of each command.
paragraphs() { # PATTERN: prints words after the second paragraph, without examples
    awk -v skipped="$1" 'BEGIN { RS = "" } NR > 2 && !(skipped && $0 ~ skipped)' |
        tr -s '[:space:]' '\n' | sed '/^$/d'
}
repeats_help() { # PROGRAM: compares its page with the help of its commands
    awk '$1 == "command" && $2 != "-" { print $2 }' "$1.list" >commands
    while read -r command; do
        "$build/$1" help "$command" | paragraphs "^ *$1 $command " >expected
        sed -n "/^ *$1 $command\$/,/^ \{0,3\}[A-Za-z]/{/^ *$1 $command\$/p
            /^ \{0,3\}[A-Za-z]/!p
        }" "$1.text" | paragraphs '' | diff expected - >differences
        verdict $? "$1.1 differs from the help of $command: $(cat differences)"
    done <commands
}

all_complete() { # EXPECTED PROGRAM WORD ..: in each shell that is installed
    completes "$@"
    command -v fish >/dev/null || return
    shift
    found=$(fish -c ". $1.fish; complete -C '$*'" | cut -f 1 | tr -d / | sort |
        tr '\n' ' ')
    [ "${found% }" = "$expected" ]
    verdict $? "fish completes '$*' to '$found', not '$expected'"
}

for program in c205 rt205 fit205; do
    for shell in bash zsh fish; do
        "$build/$program" help --completion $shell >"$program.$shell"
        verdict $? "$program help --completion $shell"
    done
    "$build/$program" help --man >"$program.1"
    verdict $? "$program help --man"
    "$build/$program" help --list >"$program.list"
    if command -v groff >/dev/null; then
        complaints=$(groff -man -ww -Tutf8 -z "$program.1" 2>&1)
        [ -z "$complaints" ]
        verdict $? "$program.1: $complaints"
        groff -man -rHY=0 -Tascii -P -cbou "$program.1" >"$program.text"
        for title in NAME SYNOPSIS "EXIT STATUS"; do
            grep -qx "$title" "$program.text"
            verdict $? "$program.1 has no section $title"
        done
        sections=$(grep -x '[A-Z][A-Z ]*' "$program.text" | sort | uniq -d)
        [ -z "$sections" ]
        verdict $? "$program.1 repeats the sections $sections"
        while read -r what command name letter kind choices; do
            [ "$what" = command ] && name=$command letter=-
            [ "$name" = - ] || grep -q -e "$name" "$program.text"
            verdict $? "$program.1 does not name $name of $command"
            [ "$what" != command ] || [ "$command" = - ] ||
                grep -qx " *$program $command" "$program.text"
            verdict $? "$program.1 has no section of $command"
            for word in $choices; do
                grep -q -e "$word" "$program.text"
                verdict $? "$program.1 does not name $word ($kind)"
            done
        done <"$program.list"
        repeats_help $program
    fi
    while read -r what command name letter kind choices; do
        [ "$what" = option ] || continue
        word=$command
        [ "$command" = - ] && word=
        # An empty word means no command.
        # shellcheck disable=SC2086
        offers "$name" $program $word "${name%?}"
        # shellcheck disable=SC2086
        [ "$letter" = - ] || offers "-$letter" $program $word -
        if [ "$kind" = choice ]; then
            # shellcheck disable=SC2086
            sorted=$(printf '%s\n' $choices | sort | tr '\n' ' ')
            # shellcheck disable=SC2086
            completes "${sorted% }" $program $word "$name" ''
            # shellcheck disable=SC2086
            completes "${sorted% }" $program $word "$name" =
            # shellcheck disable=SC2086
            completes "${sorted% }" $program $word "$name="
        fi
    done <"$program.list"
    for shell in zsh fish; do
        if command -v $shell >/dev/null; then
            $shell -n "$program.$shell"
            verdict $? "$shell does not read $program.$shell"
        fi
    done
done
all_complete 'render' rt205 re
all_complete 'sweep' rt205 help sw
all_complete 'ADDNV' c205 isa ADDNV
all_complete 'cyber720 cyber720-prior' c205 run --model cyber7
all_complete 'folder folder.s' c205 asm fol
all_complete 'folder' c205 asm -I fol
all_complete 'hits' rt205 sweep hi
all_complete '' c205 run --limit ''
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
