#!/bin/sh
# check_fit.sh BUILD - checks the fit. Every run must give the same result, the shipped
# models must be reproduced, and commands must accept them.
set -u
. "$(dirname "$0")/count.sh"
build=$1
here=$build/check-fit
fitted="cyber205-2pipe cyber720"
rm -rf "$here"
mkdir -p "$here/a" "$here/b"

fit() { # JOBS FOLDER: runs the fit, and writes its results to a folder
    "$build/fit205" --brief --jobs "$1" --json "$2/fit.json" \
        --write "$2/cyber205-2pipe.model" --write "$2/cyber720.model" \
        > "$2/report"
    verdict $? "fit205 --jobs $1"
}

fit 2 "$here/a"
fit 1 "$here/b"
diff -r "$here/a" "$here/b"
verdict $? "two fits differ"

# Relative to the prior width, the standard error of a constant must be sqrt(1 - known),
# where `known` is the share of the prior uncertainty that the observations remove. It
# is scaled up if the cost shows that the uncertainties are too small.
awk -F "[:,]" '
    /"cost":/ && !cost { cost = $2 }
    /"observations":/ && !used { used = $2 }
    /"known":/ && !total { total = $2; next }
    /"width":/ { width = $2 }
    /"standard_error":/ { error = $2 / width }
    /"known":/ {
        scale = 2 * cost / used > 1 ? 2 * cost / used : 1
        expected = sqrt((1 - $2 / 100) * scale)
        known += $2 / 100
        wrong += (error - expected) ^ 2 > 1e-12
        constants++
    }
    END { exit wrong > 0 || !constants || (known - total) ^ 2 > 1e-12 }' "$here/a/fit.json"
verdict $? "an error is not what the cost and the prior make it"

for model in $fitted; do
    diff "vm/models/$model.model" "$here/a/$model.model"
    verdict $? "the shipped model does not come out again; make fit writes it"
    "$build/c205" model "$model" | grep -q '^fitted to [1-9]'
    verdict $? "c205 model does not say that $model is fitted"
done
"$build/rt205" speedup --model "$here/a/cyber205-2pipe.model" --provenance -W 16 -H 10 \
    > "$here/speedup"
grep -q '^fitted to [1-9]' "$here/speedup"
verdict $? "rt205 speedup does not say that the model is fitted"

# The figures in a model must equal the figures of the machine with this model, and with
# a model that extends it.
shown() { # NAME MODEL PROGRAM FIGURE: computes the figure from clocks of regions
    "$build/c205" run -I rt/kernels --model "$2" \
        "rt/study/fit/programs/$3" --format csv 2> "$here/warnings" |
        awk -F, -v name="$1" '
            $2 == "all" && $1 !~ /^(all|.outside.)$/ { clocks += $3 }
            END { printf "%s %+.1f\n", name, 100 * ('"$4"' - 1) }' \
            > "$here/shown"
    sed -n "s/^#   $1 .* \([-+][0-9.]*\) %.*/$1 \1/p" \
        "$here/a/cyber205-2pipe.model" | diff - "$here/shown"
    verdict $? "the model does not tell its own error: $1"
}
shown LINPACK cyber205-2pipe linpack.s '50 * 686666 / clocks / 17'
shown 'Livermore 1' eta10g livermore_1.s 'clocks / 1763'
shown 'Livermore 11' eta10g livermore_11.s 'clocks / 20092'

"$build/fit205" --brief -W 16 -H 10 --hold-out 'cylinder vector' \
    > "$here/held"
sed '1,/^Only compared/d' "$here/held" | grep -q '^cylinder vector '
verdict $? "--hold-out does not hold out"
"$build/fit205" --brief -W 16 -H 10 --hold-out 'cylinder vector' --angle 37 \
    > "$here/wide"
verdict $? "fit205 --angle"
! cmp -s "$here/wide" "$here/held"
verdict $? "--angle makes no other view"
for arguments in "--hold-out nothing" "--write $here/other.model" \
    "--data $here"; do
    # The arguments are words.
    # shellcheck disable=SC2086
    ! "$build/fit205" --brief -W 16 -H 10 $arguments \
        > "$here/out" 2> "$here/errors"
    verdict $? "fit205 $arguments did not fail"
    expect "$arguments: no message" grep -q '^fit205: ' "$here/errors"
done

# Wrong arguments are reported before the fit begins.
while read -r text arguments; do
    code=0
    # shellcheck disable=SC2086
    "$build/fit205" $arguments > "$here/out" 2> "$here/errors" ||
        code=$?
    [ "$code" -eq 2 ] && grep -q -e "$text" "$here/errors" &&
        [ ! -s "$here/out" ]
    verdict $? "fit205 $arguments: $code, not 2"
done << 'END'
extra extra
--jobs --jobs 0
--sideways --sideways
--width --width
END
for arguments in "--json $here/missing/file" "--write $here/cyber720" \
    "--write $here/missing/cyber720.model"; do
    # shellcheck disable=SC2086
    ! timeout 30 "$build/fit205" $arguments > "$here/out" 2> "$here/errors"
    verdict $? "fit205 $arguments did not fail"
    expect "$arguments: told too late" grep -q '^fit205: ' "$here/errors"
done
! "$build/fit205" --brief -W 16 -H 10 > /dev/full 2> "$here/errors"
verdict $? "a report that cannot be written is no error"
counted
