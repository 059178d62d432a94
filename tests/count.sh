# count.sh - counts the passed and failed checks of a script of tests/.
#
#   . "$(dirname "$0")/count.sh"
#
# Such a script ends with "counted", which prints the line that run_all.sh sums. Its
# status is the status of the script.
# shellcheck shell=sh

passed=0 failed=0
said= # the output of the last command, which a failure prints

pass() {
    passed=$((passed + 1))
}

fail() { # TEXT ..: counts a failed check, and prints the text
    failed=$((failed + 1))
    echo "FAIL $*"
    [ -z "$said" ] || sed 's/^/    /' "$said"
}

verdict() { # STATUS TEXT ..: counts a check; the text is the message if it fails
    [ "$1" -eq 0 ] && pass && return
    shift
    fail "$@"
}

expect() { # TEXT COMMAND ..: the command must succeed; after "!" it must fail
    expected=$1
    shift
    if [ "$1" = ! ]; then
        shift
        ! "$@"
    else
        "$@"
    fi
    verdict $? "$expected"
}

counted() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}
