# measure.sh - functions that the benchmark scripts share.
#
#   build=$1
#   . "$(dirname "$0")/measure.sh"
#
# The minimum of several trials counts, since other work on the host only adds time.
# Figures are also appended to the file BENCH_CSV: part, subject, quantity, value.
#
# A part fails if one of its commands fails or a row has no figure. set -e does not
# detect a command that fails in a pipeline or among the words of another command.
# Therefore `run` records the failure of a command in a file, and the trap at the end of
# the script checks that file and every row that the part added to BENCH_CSV.
# shellcheck shell=sh

sized() { # FULL SMALL: prints the value that SIZE selects
    case ${SIZE:-full} in
    full) echo "$1" ;;
    small) echo "$2" ;;
    *) echo "SIZE is full or small, not $SIZE" >&2 && exit 2 ;;
    esac
}

# Scripts that source this file use the variable.
# shellcheck disable=SC2034
trials=${TRIALS:-$(sized 5 1)}
results=${BENCH_CSV:-${build:?}/bench.csv}
work=$(mktemp -d)
messages=$work/messages # stderr of the commands
failures=$work/failures # commands that failed
RT205_LIBDIR=$(cd "${build:?}" && pwd)
export RT205_LIBDIR
: >>"$results"
rows_before=$(wc -l <"$results")

run() { # COMMAND ..: the part fails if the command fails
    "$@" && return
    echo "exit status $?: $*" >>"$failures"
    return 1
}

check_rows() { # prints each row without a figure
    awk -v before="$rows_before" '
        NR > before { count++ }
        NR > before && !/,-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?$/ {
            print "no figure: " $0
            faulty = 1
        }
        END {
            if (!count)
                print "no row was measured"
            exit faulty || !count
        }' "$results"
}

finish() {
    code=$?
    [ "$code" -ne 0 ] || check_rows >&2 || code=1
    if [ -s "$failures" ]; then
        cat "$failures" "$messages" >&2
        code=1
    fi
    rm -rf "$work"
    exit "$code"
}
: >"$messages"
trap finish EXIT
trap 'exit 130' INT TERM

ours() { # SCENE WIDTH HEIGHT [JOBS]: prints processor seconds, seconds, clocks, KB
    run "$build/tests/bench_trace" "$@"
}

theirs() { # SCENE WIDTH HEIGHT: prints the processor seconds of POV-Ray's trace
    run povray "+I$1" "+W$2" "+H$3" +WT1 -F -D -A +Lscenes 2>&1 |
        awk '/Trace Time:/ { trace = 1; next }
            trace && /CPU-seconds/ { print $(NF - 2); trace = 0 }'
}

least() { # prints the minimum of each column
    awk '{ for (i = 1; i <= NF; i++)
               if (NR == 1 || $i < least[i]) least[i] = $i }
        NR == 1 { fields = NF }
        END { for (i = 1; i <= fields; i++)
                  printf "%s%s", least[i], i < fields ? " " : "\n" }'
}

keep() { # PART WHAT QUANTITY VALUE ..: records the pairs; a failure ends the part
    [ ! -s "$failures" ] || exit 1
    part=$1 what=$2
    shift 2
    while [ $# -ge 2 ]; do
        echo "$part,\"$what\",$1,$2" >>"$results"
        shift 2
    done
    check_rows >&2 || exit 1
}

quotient() { # A B: prints the quotient with two decimals
    awk -v a="$1" -v b="$2" 'BEGIN { if (b > 0) printf "%.2f", a / b }'
}

# Prints the figures of a table, cell by cell: PROGRAM, "row", column, value. A cell
# ends at the column at which its heading ends. A row without a figure has none.
cells() { # PROGRAM: reads the table that PROGRAM printed from standard input
    awk -v program="$1" '
        function ends_of(line,    at) {
            for (count = at = 0; match(line, /[^ ]+( [^ ]+)*/);
                 line = substr(line, RSTART + RLENGTH)) {
                heading[++count] = substr(line, RSTART, RLENGTH)
                end[count] = at += RSTART + RLENGTH - 1
            }
        }
        NR == 1 { ends_of($0); first = /^ / ? 1 : 2; next }
        {
            name = $0
            sub(/  .*/, "", name)
            figures = 0
            for (i = first; i <= count; i++) {
                cell = substr($0, 1, end[i])
                sub(/.* /, "", cell)
                if (length($0) >= end[i] && cell != "") {
                    printf "%s,\"%s\",%s,%s\n", program, name, heading[i],
                        cell
                    figures++
                }
            }
            if (!figures)
                printf "%s,\"%s\",,\n", program, name
        }
        END {
            if (NR < 2)
                printf "%s,\"no row\",,\n", program
        }'
}
