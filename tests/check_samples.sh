#!/bin/sh
# check_samples.sh BUILD - traces the sample scenes of POV-Ray. It prints which scenes
# can be read, why others cannot, the reports of each scene, the number of pixels that
# differ from POV-Ray's picture (for scenes without reports), and the trace times.
#
# SAMPLES lists folders or scenes; all by default. WIDTH and HEIGHT are the size of the
# pictures. MAX_SECONDS is the limit for a scene. JOBS is the number of concurrent
# scenes. The list is written to BUILD/samples.txt.
set -u
. "$(dirname "$0")/count.sh"
build=$(cd "$1" && pwd)
samples=${SAMPLES:-/usr/share/doc/povray/examples}
width=${WIDTH:-160} height=${HEIGHT:-120} seconds=${MAX_SECONDS:-300}
list=$build/samples.txt
# Minimum counts: scenes that can be read, scenes without a report, and scenes without a
# report in which at most .1 % of the pixels differ by more than .02.
least_read=280 least_plain=60 least_equal=55

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# The files of a scene are in its folder.
cat >"$work/one" <<'END'
cd "$(dirname "$1")" || exit
scene=$(basename "$1")
found=$(timeout "$5" "$2/tests/oracle/check_sample" "$scene" "$3" "$4" \
    2>/dev/null)
status=$?
[ "$status" -ne 124 ] || found="untraced	more than $5 s"
case $found in
read*)
    theirs=$(timeout "$5" povray "+I$scene" "+W$3" "+H$4" +WT1 -F -D -A 2>&1 |
        awk '/Trace Time:/ { trace = 1; next }
            trace && /CPU-seconds/ { print $(NF - 2); exit }')
    found="$found	${theirs:--}" ;;
esac
printf '%s\t%s\n' "$1" "${found:-untraced	it ended with $status}"
END

# The list consists of folders.
# shellcheck disable=SC2086
find $samples -name '*.pov' | sort | xargs -P "${JOBS:-2}" -I SCENE \
    sh "$work/one" SCENE "$build" "$width" "$height" "$seconds" |
    sort >"$work/list"

awk -F '\t' '
    BEGIN {
        printf "%-52s %7s %8s %8s %8s\n", "scene", "reports", "beyond, %",
            "rt205, s", "povray, s"
    }
    {
        name = $1
        sub(".*/examples/", "", name)
        if ($2 != "read")
            printf "%-52s %s: %s\n", name, $2, $3
        else
            printf "%-52s %7d %9s %8s %8s\n", name, $3,
                ($6 > 0 ? sprintf("%.3f", 100*$5/$6) : ""), $4, $7
    }' "$work/list" >"$list"
cat "$list"

echo
awk -F '\t' '
    $2 != "read" {
        reason = $3
        sub(/, in .*/, "", reason)
        reasons[reason]++
    }
    END {
        for (reason in reasons)
            printf "%4d %s\n", reasons[reason], reason
    }' "$work/list" | sort -rn
echo
awk -F '\t' '
    { all++ }
    $2 == "read" { read++ }
    $2 == "read" && $3 == 0 { plain++ }
    $2 == "read" && $6 > 0 { compared++ }
    $2 == "read" && $6 > 0 && $5 <= .001*$6 { equal++ }
    END { print all + 0, read + 0, plain + 0, compared + 0, equal + 0 }' \
    "$work/list" >"$work/sums"
read -r all count plain compared equal <"$work/sums"
echo "$all scenes, $count read, $plain of them without a report;" \
    "of $compared compared $equal with no more than .1 % of the pixels beyond .02"
[ -n "${SAMPLES:-}" ] && exit
expect "fewer than $least_read scenes are read" [ "$count" -ge "$least_read" ]
[ "$plain" -ge "$least_plain" ]
verdict $? "fewer than $least_plain scenes are read without a report"
[ "$equal" -ge "$least_equal" ]
verdict $? "fewer than $least_equal scenes are as POV-Ray shows them"
counted
