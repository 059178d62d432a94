#!/bin/sh
# print.sh C205 FOLDER - prints the card of the instructions to FOLDER/card.pdf (A4) and
# FOLDER/card-letter.pdf, both with embedded fonts.
set -eu
fonts=/usr/share/fonts/type1/urw-base35
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$2" "$work/devpdf"
while read -r name file; do
    printf '\t%s\t%s/%s.t1\n' "$name" "$fonts" "$file"
done >"$work/devpdf/download" <<'END'
Helvetica NimbusSans-Regular
Helvetica-Bold NimbusSans-Bold
Helvetica-Oblique NimbusSans-Italic
Symbol StandardSymbolsPS
END
"$1" isa --card >"$work/card.roff"
for paper in a4 letter; do
    groff -Tpdf -F "$work" -ww -dpaper=$paper -P-p$paper \
        "$work/card.roff" >"$work/$paper.pdf"
done
mv "$work/a4.pdf" "$2/card.pdf"
mv "$work/letter.pdf" "$2/card-letter.pdf"
