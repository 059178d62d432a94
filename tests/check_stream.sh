#!/bin/sh
# check_stream.sh BUILD - runs dieharder on the random stream of the machine: the words
# of its programs, 32 bits of each draw, ray by ray.
#
# A good stream is rated weak (a probability below .005 or above .995) in one of a
# hundred tests. A test that is weak for one seed must therefore pass for another seed.
# The generator without mixed output must fail, which shows that the tests work. Words
# and ratings are the same in every run.
#
# TESTS lists numbers of dieharder's tests, separated by commas. The default is all
# tests, except tests that dieharder rates as suspect and a test that takes minutes.
set -u
. "$(dirname "$0")/count.sh"
words=$1/tests/oracle/draw_words
tests="0,1,2,3,4,8,9,10,11,12,13,15,16,100,101,102,200 -n 6,201 -n 3,202 -n 5"
tests=${TESTS:-$tests,203 -n 1,204,205,206,207,208,209}

# Prints each probability with PASSED, WEAK or FAILED.
judge() { # WORDS-OPTIONS TEST ..
    # shellcheck disable=SC2086
    "$words" $1 2>/dev/null | dieharder -g 200 -S 1 -d $2 |
        awk -F '|' 'NF == 6 && $6 ~ /PASSED|WEAK|FAILED/ { print $1, $2, $5, $6 }'
}

all_passed() { # RATINGS: succeeds if all ratings are PASSED
    [ -n "$1" ] && ! printf '%s\n' "$1" | grep -qv PASSED
}

while read -r test; do
    found=$(judge 1 "$test" </dev/null)
    case $found in
    *FAILED*) ;;
    *WEAK*)
        echo "weak under one seed: dieharder -d $test"
        found=$(judge 2 "$test" </dev/null) ;;
    esac
    all_passed "$found"
    verdict $? "dieharder -d $test: $found"
done <<END_OF_TESTS
$(echo "$tests" | tr , '\n')
END_OF_TESTS

judge "--bare 1" 205 | grep -q FAILED
verdict $? "the generator without its output passes: nothing was judged"
counted
