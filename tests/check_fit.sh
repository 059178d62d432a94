#!/bin/sh
# check_fit.sh BUILD - the fit at a reduced size: the same at each run, the
# fitted model that is shipped comes out again, and it can be used.
set -eu
build=$1
here=$build/check-fit
shipped=vm/models/cyber205-2pipe-fitted.model
rm -rf "$here"
mkdir -p "$here/a" "$here/b"

fail() {
    echo "check_fit: $*" >&2
    exit 1
}

fit() {
    "$build/fit205" --brief -W 16 -H 10 --jobs "$1" \
        --write "$2/cyber205-2pipe-fitted.model" --json "$2/fit.json" \
        > "$2/report"
}

fit 2 "$here/a"
fit 1 "$here/b"
diff -r "$here/a" "$here/b" || fail "two fits differ"

# Names, values and units, without the remarks.
constants() {
    sed 's/#.*//' "$1" | awk 'NF == 4 && $4 == "F" { print $1, $2, $3 }'
}

# With fewer rays each constant comes out within 3 percent, or a clock.
constants "$shipped" > "$here/shipped"
constants "$here/a/cyber205-2pipe-fitted.model" > "$here/fitted"
[ -s "$here/shipped" ] || fail "$shipped holds no fitted constants"
paste -d ' ' "$here/shipped" "$here/fitted" | awk '
    {
        apart = $2 > $5 ? $2 - $5 : $5 - $2
        allowed = .03 * $2
        if ($3 == "clk" && allowed < 1)
            allowed = 1
        if ($1 != $4 || apart > allowed) {
            print "shipped " $1 " " $2 ", fitted again " $4 " " $5
            bad = 1
        }
    }
    END { exit bad }' || fail "the shipped model does not come out again"

"$build/rt205" speedup --model "$here/a/cyber205-2pipe-fitted.model" \
    -W 16 -H 10 > "$here/speedup"
grep -q '^Fitted figures' "$here/speedup" ||
    fail "rt205 speedup does not say that the model is fitted"
"$build/c205" model cyber205-2pipe-fitted > "$here/model" ||
    fail "the shipped model is not built in"

"$build/fit205" --brief -W 16 -H 10 --hold-out 'cylinder vector' \
    > "$here/held"
sed '1,/^Only compared/d' "$here/held" | grep -q '^cylinder vector ' ||
    fail "--hold-out does not hold out"
for arguments in "--hold-out nothing" "--write $here/other.model" \
    "--data $here"; do
    # The arguments are words, so they are not quoted.
    # shellcheck disable=SC2086
    if "$build/fit205" --brief -W 16 -H 10 $arguments \
        > "$here/out" 2> "$here/errors"; then
        fail "fit205 $arguments did not fail"
    fi
    grep -q '^fit205: ' "$here/errors" || fail "$arguments: no message"
done
echo "check_fit: the fitted model comes out again"
