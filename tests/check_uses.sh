#!/bin/sh
# check_uses.sh BUILD SCENE - compares heat and mass of a scene, with few rays, between
# all stages, queues and numbers of jobs.
#
# The figures must be the same in all significant digits. A scene without figures must
# give the same error. USES selects some of the methods, or all.
set -u
. "$(dirname "$0")/count.sh"
build=$1 scene=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Prints the figures, without the method and its cost.
figures() { # COMMAND ..
    "$build/rt205" "$@" --format csv 2>"$work/said" |
        sed '/^# .*[Cc]locks/,$d; /^#/d'
}

# A command without figures must report an error.
outcome() { # COMMAND ..
    figures "$@" >"$work/outcome"
    [ -s "$work/outcome" ] ||
        grep '^rt205' "$work/said" >"$work/outcome" || return 1
    cat "$work/outcome"
}

# Compares all methods. Each line of stdin contains the options of a method.
# shellcheck disable=SC2086
same() { # COMMAND OPTION ..
    command=$1
    shift
    outcome "$command" "$scene" "$@" --mode scalar >"$work/scalar"
    verdict $? "$scene: $command tells neither figures nor why not"
    while read -r way; do
        outcome "$command" "$scene" "$@" $way >"$work/other"
        cmp -s "$work/scalar" "$work/other"
        verdict $? "$scene: $command $way tells other figures than scalar"
    done
}

if [ "${USES:-some}" = all ]; then
    printf '%s\n' "--queue 1" "--queue 77" "--queue 2000" "--queue 65535" \
        "--mode kernels --queue 33" "--mode kernels" >"$work/ways"
    mass="--rays 64 --repeats 4" heat="--rays 16 --repeats 2"
else
    echo "--queue 77" >"$work/ways"
    mass="--rays 16 --repeats 4" heat="--rays 4 --repeats 2"
fi
sed 's/$/ --jobs 3/' "$work/ways" >"$work/jobs"
# The words are options and their values.
# shellcheck disable=SC2086
same mass $mass --density default=1 <"$work/jobs"
same heat --lines 32 --repeats 2 <"$work/jobs"
[ "${USES:-some}" = all ] || sed -i 's/^/--mode kernels /' "$work/jobs"
# shellcheck disable=SC2086
same heat $heat <"$work/jobs"
echo "$scene"
counted
