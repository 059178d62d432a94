#!/bin/sh
# print.sh C205 FOLDER - the card of the instructions as FOLDER/card.pdf on A4, and
# card-letter.pdf, which hold their fonts.
set -eu
fonts=/usr/share/fonts/type1/urw-base35
folder=$2
mkdir -p "$folder/devpdf"
while read -r name file; do
    printf '\t%s\t%s/%s.t1\n' "$name" "$fonts" "$file"
done >"$folder/devpdf/download" <<'END'
Helvetica NimbusSans-Regular
Helvetica-Bold NimbusSans-Bold
Helvetica-Oblique NimbusSans-Italic
Symbol StandardSymbolsPS
END
"$1" isa --card >"$folder/card.roff"
for paper in a4 letter; do
    groff -Tpdf -F "$folder" -ww -dpaper=$paper -P-p$paper \
        "$folder/card.roff" >"$folder/card-$paper.pdf"
done
mv "$folder/card-a4.pdf" "$folder/card.pdf"
