#!/bin/sh
# check_mpi.sh BUILD - compares a frame, mass and heat over several processes with a
# single process, byte for byte, for several numbers of ranks and after kills.
#
# KILLS is the number of runs of each kind that are killed at a random time, by killing
# rank 0, another rank or mpirun (3). They continue from their file with another number
# of ranks. SEED is the seed of the times (1). USES=all adds heat and mass.
set -u
. "$(dirname "$0")/count.sh"
build=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'kill_all; rm -rf "$work"' EXIT
trap 'exit 130' INT TERM
RT205_LIBDIR=$build
export RT205_LIBDIR
cp "$here/scenes/bracket.pov" "$here/scenes/burner.pov" "$work"

# File names are the same in all folders, because the output contains them.
kinds="frame mass rays lines"
command_of() { # KIND: prints the command and its options
    case $1 in
    frame) echo "render bracket.pov -W 192 -H 128" ;;
    mass) echo "mass bracket.pov --density default=1 --rays 16384 --repeats 4" ;;
    rays) echo "heat burner.pov --by part --rays 64 --repeats 4" ;;
    lines) echo "heat burner.pov --by part --lines 131072 --repeats 16" ;;
    rounds) echo "heat burner.pov --by part --rays 16 --repeats 4 --tolerance .02" ;;
    drawn) echo "heat burner.pov --rays 16 --repeats 2 --show factor --from 1" ;;
    esac
}

# A command is several words.
# shellcheck disable=SC2086
asked() { # KIND OPTION ..: runs the command in this folder
    command=$(command_of "$1")
    shift
    timeout 120 "$build/rt205" $command "$@" >told 2>said
}

is_drawn() { # KIND: succeeds if the command writes a picture
    [ "$1" = frame ] || [ "$1" = drawn ]
}

in_folder() { # FOLDER KIND OPTION ..: writes all output of the command there
    folder=$work/$1 kind=$2
    shift 2
    mkdir -p "$folder"
    rm -f "$folder"/*.png "$folder"/*.json
    cp "$work"/*.pov "$folder"
    is_drawn "$kind" && set -- "$@" -o picture.png
    (cd "$folder" && asked "$kind" "$@" --json figures.json)
}

# Compares a folder with the files of a single process. The picture is one word or none.
# shellcheck disable=SC2046
alike() { # FOLDER KIND
    for file in told figures.json $(is_drawn "$2" && echo picture.png); do
        cmp -s "$work/alone.$2/$file" "$work/$1/$file" || return 1
    done
}

# ---- Any number of ranks -------------------------------------------------------

for kind in $kinds rounds drawn; do
    said=$work/alone.$kind/said
    in_folder "alone.$kind" "$kind" --jobs 2
    verdict $? "$kind: one process alone fails"
    for ranks in 2 3 5; do
        said=$work/many/said
        in_folder many "$kind" --ranks "$ranks" && alike many "$kind"
        verdict $? "$kind: $ranks ranks tell something else than one"
    done
done

# ---- Every scene ---------------------------------------------------------------

# A command is several words.
# shellcheck disable=SC2086
uses() { # SCENE OPTION ..: prints the output and the exit code
    scene=$1
    shift
    for asked in "mass --density default=1 --rays 16 --repeats 4" \
        "heat --rays 4 --repeats 2" "heat --lines 256 --repeats 4"; do
        timeout 120 "$build/rt205" $asked "$scene" "$@" 2>/dev/null
        echo "$asked: $?"
    done
}

[ "${USES:-some}" = all ] && for scene in "$here"/scenes/*.pov; do
    said=
    uses "$scene" --jobs 1 >"$work/one"
    uses "$scene" --ranks 3 >"$work/three"
    expect "$scene: three ranks tell other figures than one" cmp -s "$work/one" "$work/three"
done

# ---- Kills ---------------------------------------------------------------------

# Prints the processes of a program in this folder, or only the processes of a rank.
pids() { # PROGRAM [RANK]
    for pid in $(pgrep -x "$1"); do
        [ "$(readlink "/proc/$pid/cwd" 2>/dev/null)" = "$work/killed" ] || continue
        [ $# -eq 1 ] || tr '\0' '\n' 2>/dev/null <"/proc/$pid/environ" |
            grep -q "^OMPI_COMM_WORLD_RANK=$2\$" || continue
        echo "$pid"
    done
}

end_them() { # PID ..: kills the processes
    [ $# -eq 0 ] || kill -9 "$@" 2>/dev/null
}

# The processes are words.
# shellcheck disable=SC2046
kill_all() {
    end_them $(pids mpirun) $(pids rt205)
}

state=${SEED:-1}
chance() { # BELOW: sets $drawn
    state=$(((state * 1103515245 + 12345) % 2147483648))
    drawn=$((state / 65536 % $1))
}

# Kills one of three ranks, mpirun, or a process with threads. All other processes must
# then end. The options are two words, and the processes are words.
# shellcheck disable=SC2046,SC2086
kill_at() { # KIND MILLISECONDS WHO
    way="--ranks 3"
    [ "$3" = alone ] && way="--jobs 2"
    (in_folder killed "$1" $way --resume units.kept) &
    runner=$!
    sleep "$(printf '%d.%03d' $(($2 / 1000)) $(($2 % 1000)))"
    case $3 in
    mpirun) end_them $(pids mpirun) ;;
    alone) end_them $(pids rt205) ;;
    *) end_them $(pids rt205 "$3") ;;
    esac
    wait "$runner" && echo "$1: $2 ms: it was done before" >>"$work/killed/said"
}

# Waits until ranks without mpirun have ended, which takes a short time.
are_gone() {
    for _ in 1 2 3 4 5 6 7 8 9 10; do
        pids rt205 | grep -q . || return 0
        sleep .2
    done
    kill_all
    return 1
}

said=$work/killed/said
midway=0
for kind in $kinds; do
    before=$(date +%s%N)
    in_folder killed "$kind" --ranks 3
    took=$((($(date +%s%N) - before) / 1000000))
    i=0
    while [ $i -lt "${KILLS:-3}" ]; do
        i=$((i + 1))
        rm -f "$work/killed/units.kept"
        chance "$took"
        when=$((drawn + 1))
        chance 5
        who=$(echo 0 1 2 mpirun alone | cut -d " " -f $((drawn + 1)))
        kill_at "$kind" "$when" "$who"
        [ -s "$work/killed/units.kept" ] && midway=$((midway + 1))
        are_gone
        verdict $? "$kind: ranks live on when $who is killed after $when ms"
        in_folder killed "$kind" --ranks 2 --resume units.kept &&
            alike killed "$kind" && [ ! -e "$work/killed/units.kept" ]
        verdict $? "$kind: goes on to something else when $who is killed after $when ms"
    done
done
echo "killed with a file of units: $midway"
[ "$midway" -gt 0 ] || [ "${KILLS:-3}" -eq 0 ]
verdict $? "nothing was killed while it kept units"

# ---- Shares, one of them over ranks -----------------------------------------------

mkdir -p "$work/shared"
cp "$work"/*.pov "$work/shared"
said=$work/shared/said
for kind in $kinds; do
    rm -f "$work/shared/units.1" "$work/shared/units.2"
    (cd "$work/shared" &&
        asked "$kind" --part 1/2 --resume units.1 &&
        asked "$kind" --part 2/2 --resume units.2 --ranks 2)
    verdict $? "$kind: shares are not done"
    in_folder shared "$kind" --resume units.1 --resume units.2 --ranks 2 &&
        alike shared "$kind"
    verdict $? "$kind: shares come to something else than one run"
done

# ---- Errors --------------------------------------------------------------------

mkdir -p "$work/wrong"
cp "$work"/*.pov "$work/wrong"
cd "$work/wrong" || exit 1
said=$work/wrong/said
small() { # OPTION ..: a frame of four pixels by eight
    timeout 60 "$build/rt205" render bracket.pov -W 8 -H 4 "$@"
}
small -o one.png >/dev/null 2>said
small -o many.png --ranks 5 >/dev/null 2>said && cmp -s one.png many.png
verdict $? "more ranks than units come to another picture"
small -o no/such/folder.png --ranks 3 >/dev/null 2>said
[ $? -eq 1 ] && grep -q "no/such/folder.png" said
verdict $? "a picture that cannot be written is no error"
echo nothing >kept
small -o one.png --ranks 3 --resume kept >/dev/null 2>said
[ $? -eq 1 ] && grep -q "kept" said && [ "$(cat kept)" = nothing ]
verdict $? "a file of something else is taken for units"
timeout 60 "$build/rt205" render nosuch.pov -o one.png --ranks 3 >/dev/null 2>said
[ $? -eq 1 ] && [ "$(grep -c nosuch.pov said)" -eq 1 ]
verdict $? "a scene that is not there is not told once"
timeout 60 env PATH=/nowhere "$build/rt205" render bracket.pov -W 8 -H 4 -o one.png --ranks 2 >/dev/null 2>said
[ $? -eq 1 ] && grep -q openmpi-bin said
verdict $? "without mpirun its package is not named"
mkdir bare && cp "$build/rt205" "$build/rt205_oiio.so" bare
RT205_LIBDIR=$PWD/bare timeout 60 bare/rt205 render bracket.pov -W 8 -H 4 -o one.png --ranks 2 >/dev/null 2>said
[ $? -eq 1 ] && grep -q "rt205_mpi.so" said
verdict $? "without the adapter it is not named"
small -o one.png --ranks 2 --jobs 2 >/dev/null 2>said
[ $? -eq 2 ]
verdict $? "threads and ranks go together"
timeout 60 "$build/rt205" heat burner.pov --hits --from Tube --ranks 2 >/dev/null 2>said
[ $? -eq 2 ]
verdict $? "--hits takes --ranks"
counted
