#!/bin/sh
# bench_stages.sh BUILD - measures the clocks of the machine for a frame of each scene
# by each tracing method. The script fails if two methods give different frames.
set -eu
build=$1
. "$(dirname "$0")/measure.sh"
width=$(sized 120 16) height=$(sized 90 12)

# Options of rt205 render, one method per line.
ways() {
    cat <<'END'
--mode scalar --flat
--mode scalar
--mode kernels --flat
--mode kernels
--mode vector --flat
--mode vector --order rows
--mode vector
END
}

clocks() { # SCENE OPTIONS ..: prints the clocks and the frame's checksum
    scene_file=$1
    shift
    run "$build/rt205" render "$scene_file" --no-picture -W "$width" \
        -H "$height" "$@" --format csv 2>>"$messages" | awk -F, '
        /^scene,/ { for (i = 1; i <= NF; i++) at[$i] = i; next }
        at["clocks"] && !n++ { print $at["checksum"], $at["clocks"] }'
}

echo "thousands of clocks of a frame of $width x $height pixels"
printf '%-24s' scene
ways | while read -r way; do printf ' %18s' "${way#--mode }"; done
echo
for scene in $(sized "$(echo scenes/*.pov)" scenes/first.pov); do
    printf '%-24s' "$scene"
    ways | while read -r way; do
        # A method is several words.
        # shellcheck disable=SC2086
        clocks "$scene" $way >"$work/clocks"
        read -r sum count <"$work/clocks"
        printf " %18.0f" "$(quotient "$count" 1000)"
        keep stages "$scene" "${way#--mode }" "$count"
        echo "$sum" >>"$work/sums"
    done
    echo
    [ "$(sort -u "$work/sums" | wc -l)" -eq 1 ] ||
        { echo "frames differ" >&2 && exit 1; }
    rm "$work/sums"
done
