#!/bin/sh
# check_adaptive.sh BUILD - compares adaptive sampling with POV-Ray's +AM1. Pixels that
# differ from their neighbours get more rays. At most one pixel in a thousand may differ
# from POV-Ray by more than .02.
#
# In these scenes POV-Ray and the tracer agree ray by ray. They include colours beyond
# white, gammas, glass, mirrors, fogs and normals.
set -u
. "$(dirname "$0")/count.sh"
build=$1
command -v povray >/dev/null || { echo "(POV-Ray is not installed)"; exit 0; }

# Each line is SCENE WIDTH HEIGHT SAMPLES THRESHOLD.
while read -r scene how; do
    # The line consists of words.
    # shellcheck disable=SC2086
    found=$("$build/tests/oracle/check_sample" "$scene" $how)
    echo "$found" | awk -F '\t' '
        { differ = $4; pixels = $5 }
        END { exit !(pixels > 0 && differ <= .001*pixels) }'
    verdict $? "$scene $how: $found"
done <<'END'
scenes/pipe_flange.pov 160 120 3 .3
scenes/glass.pov 100 75 3 .3
scenes/glass.pov 64 64 2 .05
scenes/mist.pov 80 60 4 .2
tests/scenes/gamma.pov 100 75 3 .3
tests/scenes/gamma.pov 97 33 2 .1
tests/scenes/lights.pov 65 50 3 .6
tests/scenes/patterns.pov 70 97 2 .3
tests/scenes/bumps.pov 80 60 3 .3
tests/scenes/orthographic.pov 33 65 5 .1
END
counted
