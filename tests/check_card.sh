#!/bin/sh
# check_card.sh C205 FOLDER - the card in FOLDER, on either paper: two pages, every
# instruction, directive and verb of the debugger, and nothing beyond the page or
# its column, or upon something else.
set -u
. "$(dirname "$0")/count.sh"
c205=$1 folder=$2
cd "$(dirname "$0")/.." || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
said=$work/said

"$c205" isa --names >"$work/names"
"$c205" isa --format csv | sed 1d | cut -d , -f 1,2 | tr , ' ' >"$work/codes"
sed -n 's/^ *\(} directives.. = \)*{* *{ "\(\.[a-z]*\)".*/\2/p' asm/*.c >"$work/directives"
echo help >"$work/help"
"$c205" debug -x "$work/help" asm/examples/first.s |
    sed -n 's/^\([a-z][-a-z]*\)[ |].*/\1/p; /^goto/s/.*/goto/p' >"$work/verbs"

# Words that lie outside of what printers print, reach from the left column into the
# right one, or begin before the one on their left ends.
astray() { # of pdftotext -bbox, on stdin
    awk -F '"' '
        /<page / { page++; width = $2; height = $4 }
        /<word / {
            split($9, text, /[<>]/)
            if ($2 < 17 || $6 > width - 17 || $4 < 17 || $8 > height - 17)
                print "at the edge: " text[2]
            if ($2 < width / 2 && $6 > width / 2)
                print "from column to column: " text[2]
            print page, int($8 + .5), $2, $6, text[2] | "sort -n -k 1,1 -k 2,2 -k 3,3"
        }' | awk '
        /:/ && !/^[0-9]/ { print; next }
        $1 == page && $2 == line && $3 < end - .2 { print "upon another:", $5 }
        { page = $1; line = $2; end = $4 }'
}

for paper in card:595:842 card-letter:612:792; do
    pdf=$folder/${paper%%:*}.pdf
    size=${paper#*:}
    pdfinfo "$pdf" >"$said"
    grep -q '^Pages: *2$' "$said"
    verdict $? "$pdf: not two pages"
    grep -q "^Page size: *${size%:*}.* x ${size#*:}" "$said"
    verdict $? "$pdf: not on ${paper%%:*} paper"
    pdffonts "$pdf" | sed 1,2d >"$said"
    ! grep -qv ' yes \(yes\|no \) \(yes\|no \) ' "$said"
    verdict $? "$pdf: a font is missing"
    pdftotext -bbox "$pdf" - | astray >"$said"
    [ ! -s "$said" ]
    verdict $? "$pdf: what stands wrong"
    pdftotext -layout "$pdf" - | tr -s ' ' >"$work/text"
    while read -r name code; do
        grep -q "\(^\| \)$name $code " "$work/text"
        verdict $? "$pdf: no $name"
    done <"$work/codes"
    pdftotext "$pdf" - | tr -c '[:alnum:].-' '\n' | sort -u >"$work/words"
    while read -r word; do
        grep -qxF -e "$word" "$work/words"
        verdict $? "$pdf: no $word"
    done <<END
$(cat "$work/directives" "$work/verbs")
END
done
counted
