#!/bin/sh
# check_uses.sh BUILD SCENE - what else a traced scene is for: heat and mass, with few
# rays.
#
# All stages, with any queue and any number of jobs, print the same figures, to the last
# digit that tells one number from the next; a scene that has none says why.
# USES: some of the ways, or all.
set -u
. "$(dirname "$0")/count.sh"
build=$1 scene=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# What is printed, but for how it was found and what that took.
figures() { # COMMAND ..
    "$build/rt205" "$@" --format csv 2>"$work/said" |
        sed '/^# .*[Cc]locks/,$d; /^#/d'
}

# Without figures there must be an error, and it must be the same.
outcome() { # COMMAND ..
    figures "$@" >"$work/outcome"
    [ -s "$work/outcome" ] ||
        grep '^rt205' "$work/said" >"$work/outcome" || return 1
    cat "$work/outcome"
}

# However it is found, a line of options each on standard input.
# A line is several options.
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
# They are options and their values.
# shellcheck disable=SC2086
same mass $mass --density default=1 <"$work/jobs"
same heat --lines 32 --repeats 2 <"$work/jobs"
[ "${USES:-some}" = all ] || sed -i 's/^/--mode kernels /' "$work/jobs"
# shellcheck disable=SC2086
same heat $heat <"$work/jobs"
echo "$scene"
counted
