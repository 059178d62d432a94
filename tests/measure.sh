# measure.sh - what the parts of the bench share.
#
#   build=$1
#   . "$(dirname "$0")/measure.sh"
#
# Of several trials the least counts, for whatever else the host does only adds.
# Figures also go to the file BENCH_CSV: part, what was measured, the quantity,
# its value.

trials=${TRIALS:-5}
results=${BENCH_CSV:-$build/bench.csv}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

have_povray() {
    command -v povray >/dev/null
}

ours() { # SCENE WIDTH HEIGHT [JOBS]: processor seconds, seconds, clocks, KB
    "$build/tests/bench_trace" "$@"
}

theirs() { # SCENE WIDTH HEIGHT: processor seconds of POV-Ray's trace
    povray "+I$1" "+W$2" "+H$3" +WT1 -F -D -A +Lscenes 2>&1 |
        awk '/Trace Time:/ { trace = 1; next }
            trace && /CPU-seconds/ { print $(NF - 2); exit }'
}

least() { # of each column
    awk '{ for (i = 1; i <= NF; i++)
               if (NR == 1 || $i < least[i]) least[i] = $i }
        NR == 1 { fields = NF }
        END { for (i = 1; i <= fields; i++)
                  printf "%s%s", least[i], i < fields ? " " : "\n" }'
}

keep() { # PART WHAT QUANTITY VALUE ..: pairs of the last two
    part=$1 what=$2
    shift 2
    while [ $# -ge 2 ]; do
        echo "$part,\"$what\",$1,$2" >>"$results"
        shift 2
    done
}

quotient() { # A B: to two places
    awk -v a="$1" -v b="$2" 'BEGIN { if (b > 0) printf "%.2f", a / b }'
}

# A table's figures, cell by cell: PROGRAM, "row", column, value.  Cells end where
# the headings of their columns do.
cells() { # PROGRAM: of what it printed
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
            for (i = first; i <= count; i++) {
                cell = substr($0, 1, end[i])
                sub(/.* /, "", cell)
                if (length($0) >= end[i] && cell ~ /^[0-9.]+$/)
                    printf "%s,\"%s\",%s,%s\n", program, name, heading[i],
                        cell
            }
        }'
}
