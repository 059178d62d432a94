# commands.sh - commands as a user calls them: how they end, and what they say.
#
#   . "$here/tests/commands.sh"
#
# The script has sourced count.sh, and stands in the folder $work.
# shellcheck shell=sh
: "${work:?}"

ends() { # CODE COMMAND ..: its exit code; what it prints goes to out and err
    wanted=$1
    shift
    "$@" >"$work/out" 2>"$work/err" </dev/null
    [ $? -eq "$wanted" ]
    verdict $? "exit code is not $wanted: $*"
}

tells() { # FILE TEXT: the last command's out or err holds the text
    grep -q -e "$2" "$work/$1"
    verdict $? "$1 does not say '$2'"
}
