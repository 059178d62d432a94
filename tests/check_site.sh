#!/bin/sh
# check_site.sh BUILD - checks the manual as a site. Every link, anchor and picture must
# have a target. Nothing may be loaded from another host. Navigation and search index
# must contain every page of docs/ and every instruction. Planted faults must be found.
set -u
. "$(dirname "$0")/count.sh"
BUILD=$(cd "$1" && pwd)
cd "$(dirname "$0")/.." || exit 1
rules=$PWD/tests/site_faults.awk
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The expected pages and instructions.
find README.md docs -name '*.md' ! -path 'docs/slides/*' |
    sed 's/README\.md$/index.md/; s/\.md$/.html/' | sort >"$work/pages"
sed -n 's/^### //p' docs/isa.md | tr '[:upper:]' '[:lower:]' |
    sort >"$work/instructions"

# Prints the lines of the first list that the second lacks, each after the text.
missing() { # TEXT LIST LIST
    sort -u "$3" | comm -23 "$2" - | sed "s|^|$1: |"
}

# Prints the faults of a site, one per line.
faults() { # SITE
    (cd "$1" && find . -type f | awk -f "$rules")
    worker=$(sed -n 's/.*"search": "\([^"]*\)".*/\1/p' "$1/index.html")
    [ -f "$1/$worker" ] || echo "nobody searches"
    (cd "$1" && find . -name '*.html' | sed 's|^\./||') >"$work/there"
    missing "no page" "$work/pages" "$work/there"
    # The page for unknown addresses has only the navigation.
    grep -o 'href="/[^"]*"' "$1/404.html" |
        sed 's|^href="/||; s|"$||; s|^\.$|index.html|' >"$work/there"
    missing "not in the navigation" "$work/pages" "$work/there"
    sed 's/"location":"/\n&/g' "$1/search/search_index.json" |
        sed -n 's/^"location":"\([^"]*\)".*/\1/p' >"$work/searched"
    missing "not searched" "$work/pages" "$work/searched"
    sed -n 's|^docs/isa/.*#||p' "$work/searched" >"$work/there"
    missing "not searched" "$work/instructions" "$work/there"
}

faults "$BUILD/site" >"$work/faults"
said=$work/faults
expect "the site" [ ! -s "$work/faults" ]

# planted FILE SED MESSAGE
planted() {
    cp "$work/copy/$1" "$work/kept"
    sed -i "$2" "$work/copy/$1"
    faults "$work/copy" >"$work/faults"
    expect "not found when it was planted in $1: $3" grep -qF "$3" "$work/faults"
    cp "$work/kept" "$work/copy/$1"
}

appended() { # FILE LINE MESSAGE: plants a line at the end of a file
    planted "$1" "\$a $2" "$3"
}

cp -r "$BUILD/site" "$work/copy"
appended index.html '<a href="docs/nowhere.html">a page</a>' \
    'index.html: leads nowhere: docs/nowhere.html'
appended docs/machine.html "<a class=x href='timing.html#nowhere'>a heading</a>" \
    'docs/machine.html: no such anchor: timing.html#nowhere'
appended docs/gallery.html '<img src=pictures/nowhere.png>' \
    'docs/gallery.html: leads nowhere: pictures/nowhere.png'
appended docs/isa.html '<script src="https://example.org/a.js"></script>' \
    'docs/isa.html: script src asks another host'
appended docs/timing.html '<link rel="stylesheet" href="//example.org/a.css">' \
    'docs/timing.html: link href asks another host'
appended docs/heat.html '<p style="background: url(http://example.org/a.png)">' \
    'docs/heat.html: a style asks another host'
appended site.css 'a { background: url("https://example.org/a.png") }' \
    'site.css: asks another host'
planted 404.html 's|"/docs/points.html"|"/docs/mass.html"|' \
    'not in the navigation: docs/points.html'
planted search/search_index.json 's|"docs/mass.html"|"x"|' \
    'not searched: docs/mass.html'
planted search/search_index.json 's|#addnv"|#x"|' 'not searched: addnv'
rm "$work/copy/docs/heat.html"
faults "$work/copy" | grep -qF 'no page: docs/heat.html'
verdict $? "a page that is not there is not found"
counted
