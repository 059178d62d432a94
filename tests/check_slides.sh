#!/bin/sh
# check_slides.sh PAGE FOLDER - checks the deck of a lecture's page in FOLDER. Every
# slide must have notes for the speaker, fit, and be one page in print, with and without
# notes. Nothing may be loaded from another host. Planted faults must be found.
set -u
. "$(dirname "$0")/count.sh"
page=$1 folder=$(cd "$2" && pwd)
cd "$(dirname "$0")/.." || exit 1
name=$(basename "$page" .md)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
said=$work/said
slides=$(grep -c '^##* ' "$page")

# Prints the tags of a deck's sections, one per line, after its scripts have run.
sections() { # HTML
    sh docs/slides/browser.sh "$1" --dump-dom | grep -o '<section[^>]*>'
}

# Prints the faults of a deck.
faults() { # HTML
    sections "$1" >"$work/sections"
    [ "$(wc -l <"$work/sections")" -eq "$slides" ] || echo "not $slides slides"
    grep -n too-long "$work/sections" | sed 's/:.*/: more than a slide holds/'
    awk '
        /^<section/ { slide++; said = 0 }
        /^<blockquote/ { said = 1 }
        /^<\/section/ && !said { print slide ": nothing to say" }' "$1"
    (cd "$(dirname "$1")" && echo "${1##*/}" |
        awk -f "$OLDPWD/tests/site_faults.awk" | grep -v 'data:image')
}

faults "$folder/$name.html" >"$said"
expect "$name.html" [ ! -s "$said" ]
for pdf in "$name" "$name-notes"; do
    pdfinfo "$folder/$pdf.pdf" >"$said"
    expect "$pdf.pdf: not $slides pages" grep -q "^Pages: *$slides\$" "$said"
    pdftotext "$folder/$pdf.pdf" - | tr '\n' ' ' >"$said"
    grep '^##* ' "$page" | sed 's/^#* //; s/\*//g' >"$work/titles"
    while read -r title; do
        expect "$pdf.pdf: no $title" grep -qF "$title" "$said"
    done <"$work/titles"
done
grep -qF "$(sed -n 's/^> //p' "$page" | sed 1q | cut -c 1-40)" "$said"
verdict $? "$name-notes.pdf: no notes"

# planted SED MESSAGE
planted() {
    sed "$1" "$page" >"$work/docs/slides/planted.md"
    (cd "$work" && sh docs/slides/deck.sh docs/slides/planted.md) \
        >"$work/docs/slides/planted.html"
    faults "$work/docs/slides/planted.html" >"$work/said"
    expect "not found when it was planted: $2" grep -q "$2" "$work/said"
}

mkdir -p "$work/docs"
cp -r docs/slides docs/site docs/pictures "$work/docs"
planted '/^    EXIT/s/^.*$/&\n&\n&\n&\n&\n&\n&\n&\n&\n&\n&/; /^            EXIT/s/^.*$/&\n&\n&\n&\n&\n&\n&\n&\n&\n&\n&/' \
    'more than a slide holds'
planted '/^> Amdahl, 1967/,/^$/d' '3: nothing to say'
planted 's|^- a scalar unit|<script src="https://example.org/a.js"></script>\n\n&|' \
    'asks another host'
counted
