#!/bin/sh
# check_card.sh C205 FOLDER - checks the card in FOLDER in both paper sizes. It must
# have two pages, every instruction of the table, every directive and every command of
# the debugger. No text may be outside of the page or its column, or overlap other text.
set -u
. "$(dirname "$0")/count.sh"
c205=$1 folder=$2
cd "$(dirname "$0")/.." || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
said=$work/said

# Prints the rows of the table without blanks: name and code, class, operands and
# effect. ! replaces |.
"$c205" isa --format md |
    sed '1,2d; s/^| //; s/ *|$//; s/\\|/!/g; s/\\//g' |
    awk -F '[|]' '{ gsub(/ /, ""); print $1 $2, $7, $4 $9 }' >"$work/rows"
sed -n 's/^ *\(} directives.. = \)*{* *{ "\(\.[a-z]*\)".*/\2/p' asm/text/*.c \
    >"$work/words"
echo help >"$work/help"
"$c205" debug -x "$work/help" asm/examples/first.s |
    sed -n 's/^\([a-z][-a-z]*\)[ |].*/\1/p' >>"$work/words"

# Prints the text of a card without blanks, in the notation of the table.
plain_text() { # PDF
    pdftotext -raw "$1" - | tr -d ' \n\f' |
        sed "s/×/x/g; s/≥/>=/g; s/≤/<=/g; s/≠/isnotequalto/g; s/[−‐]/-/g; s/’/'/g
            s/±//g; s/|/!/g"
}

# Prints the rows that the text lacks. A row of the text has a name, a code, marks, the
# class, an optional letter for the vector unit's part, operands and effect.
missing_rows() { # TEXT ROWS
    awk '
        NR == FNR { text = $0; next }
        {
            at = index(text, $1)
            rest = substr(text, at + length($1), 200)
            sub(/^H?[01]?/, "", rest)
            good = at && index(rest, $2) == 1
            rest = substr(rest, length($2) + 1)
            if (!good || (index(rest, $3) != 1 && index(rest, $3) != 2))
                print $1
        }' "$1" "$2"
}

# Prints words that are outside of the printable area, extend from the left column into
# the right column, or begin before the end of the word to their left.
astray() { # PDF
    pdftotext -bbox "$1" - | awk -F '"' '
        /<page / { page++; width = $2; height = $4 }
        /<word / {
            split($9, text, /[<>]/)
            print page, ($2 < width / 2), int($8 + .5), $2, $6, text[2], \
                ($2 < 17 || $6 > width - 17 || $4 < 17 || $8 > height - 17), \
                ($2 < width / 2 && $6 > width / 2)
        }' | sort -n -k 1,1 -k 2,2 -k 3,3 -k 4,4 >"$work/places"
    [ -s "$work/places" ] || echo "no words"
    awk '
        $7 { print "at the edge:", $6 }
        $8 { print "from column to column:", $6 }
        $1 " " $2 " " $3 == line && $4 < end - .2 { print "upon another:", $6 }
        { line = $1 " " $2 " " $3; end = $5 }' "$work/places"
}

for paper in card:595:842 card-letter:612:792; do
    pdf=$folder/${paper%%:*}.pdf
    size=${paper#*:}
    pdfinfo "$pdf" >"$said"
    expect "$pdf: not two pages" grep -q '^Pages: *2$' "$said"
    grep -q "^Page size: *${size%:*}.* x ${size#*:}" "$said"
    verdict $? "$pdf: another size of paper"
    pdffonts "$pdf" | sed 1,2d >"$said"
    expect "$pdf: a font is missing" ! grep -qv ' yes \(yes\|no \) \(yes\|no \) ' "$said"
    astray "$pdf" >"$said"
    expect "$pdf: what stands wrong" [ ! -s "$said" ]
    plain_text "$pdf" >"$work/text"
    missing_rows "$work/text" "$work/rows" >"$said"
    expect "$pdf: rows that are missing, or are others" [ ! -s "$said" ]
    pdftotext "$pdf" - | tr -c '[:alnum:].-' '\n' | sort -u >"$work/there"
    sort -u "$work/words" | comm -23 - "$work/there" >"$said"
    expect "$pdf: words that are missing" [ ! -s "$said" ]
done
[ "$(wc -l <"$work/rows")" -gt 150 ] && [ "$(wc -l <"$work/words")" -gt 50 ]
verdict $? "rows, directives and verbs were not read"
counted
