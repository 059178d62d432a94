# commands.sh - functions that run commands as a user calls them. They compare exit
# codes, output and files with expectations of a script or a table's row.
#
#   . "$here/tests/commands.sh"
#
# The script must have sourced count.sh, and works in the folder $work.
# shellcheck shell=sh
: "${work:?}" "${here:?}"

ends() { # CODE COMMAND ..: exits with the code; its output is in out and err
    wanted=$1
    shift
    "$@" >"$work/out" 2>"$work/err" </dev/null
    [ $? -eq "$wanted" ]
    verdict $? "exit code is not $wanted: $*"
}

tells() { # FILE TEXT: out or err of the last command contains the text
    expect "$1 does not say '$2'" grep -q -e "$2" "$work/$1"
}

# ---- Tables: commands.txt explains the rows ----

holds() { # CHECK [=> CHECK] ..: checks the results of the last command
    case $1 in
    *' => '*)
        holds "${1%% => *}"
        holds "${1#* => }"
        return
        ;;
    'absent '*) [ ! -e "${1#* }" ] ;;
    'filled '*) [ -s "${1#* }" ] ;;
    'empty '*) [ ! -s "${1#* }" ] ;;
    *)
        tells "${1%% *}" "${1#* }"
        return
        ;;
    esac
    verdict $? "not $1: $call"
}

calls() { # CODE WORDS: runs a command, or one command for each choice in braces
    choices='' before=$2 after=''
    case $2 in
    *' { '*' }'*)
        before=${2%% { *} after=${2##* \}}
        choices=${2#* { }
        choices=${choices% \}*}
        ;;
    esac
    while :; do
        call="$before ${choices%% | *} $after"
        eval "ends $1 \"\$build\"/$call"
        [ "$choices" != "${choices#* | }" ] || break
        choices=${choices#* | }
    done
}

row() { # ROW: runs the check of a row
    case $1 in
    '' | '#'*) ;;
    'file '*)
        made=${1#* }
        : >"$made"
        ;;
    '|'*) printf '%s\n' "${1#|}" >>"$made" ;;
    '$ '*) eval "${1#* }" ;;
    '? '*)
        eval "${1#* : }"
        verdict $? "$(printf '%s' "${1#* }" | sed 's/ : .*//')"
        ;;
    '    '*) holds "${1#    }" ;;
    *)
        calls "${1%% *}" "$(printf '%s' "${1#* }" | sed 's/ => .*//')"
        case $1 in *' => '*) holds "${1#* => }" ;; esac
        ;;
    esac
}

rows() { # NAME: runs the rows of this name in tests/commands.txt
    awk -v name="$1" '/^@ / { on = $2 == name; next } on' \
        "$here/tests/commands.txt" >"$work/$1.rows"
    while IFS= read -r line <&3; do
        row "$line"
    done 3<"$work/$1.rows"
    [ -s "$work/$1.rows" ] || fail "tests/commands.txt has no rows of the name $1"
}
