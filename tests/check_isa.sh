#!/bin/sh
# check_isa.sh C205 - checks that docs/isa.md and the grammar for editors equal the
# output of the command. Every instruction must have a correct example.
set -u
. "$(dirname "$0")/count.sh"
c205=$1
cd "$(dirname "$0")/.." || exit 1
examples=asm/isa_examples
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$c205" isa --markdown >"$work/isa.md"
verdict $? "c205 isa --markdown"
diff docs/isa.md "$work/isa.md" >"$work/diff"
verdict $? "docs/isa.md is not what the table says: make docs"
head -n 20 "$work/diff"
grammar=docs/editors/vscode/c205.tmLanguage.json
"$c205" isa --grammar | diff "$grammar" - >"$work/diff"
verdict $? "$grammar is not what the table says: make docs"
head -n 20 "$work/diff"

# The text and the page of an instruction have the same rules.
rules='length|padding|control|specials|with ,H|note'
# The list consists of names.
# shellcheck disable=SC2046
"$c205" isa $("$c205" isa --names) |
    sed -nE "s/^  ($rules)  +(.{1,20}).*/\1: \2/p" >"$work/rules"
sed -nE 's/ \|$//; s/\\\|/|/g
    s/^\| short source/| padding/; s/^\| control vector/| control/
    s/^\| special values/| specials/; s/^\| with .,H./| with ,H/
    '"s/^\| ($rules) \| (.{1,20}).*/\1: \2/p" "$work/isa.md" | diff - "$work/rules" >"$work/diff"
verdict $? "c205 isa MNEMONIC does not have the rules of the page"
head -n 20 "$work/diff"

"$c205" isa --search "Square ROOT" --names >"$work/found"
"$c205" isa --format csv | grep -i "square root" | cut -d, -f1 | diff - "$work/found" >"$work/diff"
verdict $? "c205 isa --search finds other rows than grep"
head -n 20 "$work/diff"
expect "c205 isa --search finds a name" sh -c "'$c205' isa --search mpysv --names | grep -qx MPYSV"
"$c205" isa --search "no such words" >"$work/found" 2>"$work/error"
[ $? -eq 1 ] && grep -q "no instruction has 'no such words'" "$work/error"
verdict $? "c205 isa --search finds what is not there"

"$c205" isa --names | tr '[:upper:]' '[:lower:]' | sort >"$work/rows"
for example in "$examples"/*.s; do
    name=$(basename "$example" .s)
    expect "$example: no such instruction" grep -qx "$name" "$work/rows"
    expect "$example: no $name in it" grep -qiw "^[^;]*$name" "$example"
    expect "$example: expects nothing" grep -q '^; expect' "$example"
done
"$c205" run --check "$examples"/*.s
verdict $? "an example does not do what it expects"
counted
