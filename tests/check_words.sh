#!/bin/sh
# check_words.sh - checks that no comment, page or name contains a word that
# tests/words.txt replaces.
#
# Comments are comments of C files, JavaScript, CSS, programs, scenes, scripts, models
# and observations. Names are identifiers of C files and of the web page: names in
# JavaScript and CSS, and the ids and classes of HTML. Pages are the text of README.md
# and docs outside of code blocks. Planted faults of each kind must be found.
set -u
. "$(dirname "$0")/count.sh"
cd "$(dirname "$0")/.." || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Prints the faults of files, one per line.
faults() { # FILE ..
    awk '
    FILENAME == "tests/words.txt" {
        if (/^\[[a-z ]+\]$/)
            section = $0
        else if (/^[^#]/ && (at = index($0, " = "))) {
            n++
            pattern[n] = substr($0, 1, at - 1)
            instead[n] = substr($0, at + 3)
            place[n] = section
        }
        next
    }
    FNR == 1 {
        page = FILENAME ~ /[.]md$/
        # The start of a comment that extends to the end of its line; "": C comments.
        mark = FILENAME ~ /[.]([ch]|css|m?js)$/ ? "" : "#"
        script = FILENAME ~ /[.]m?js$/
        html = FILENAME ~ /[.]html$/
        web = script || html || FILENAME ~ /[.]css$/
        if (FILENAME ~ /[.](s|inc)$/)
            mark = ";"
        if (FILENAME ~ /[.](cc|pov|suppressions)$|(scenes|library)\/[^\/]*[.]inc$/)
            mark = "//"
        comment = block = 0
    }
    {
        prose = names = ""
        if (page) {
            if (/^```/)
                block = !block
            if (!block && !/^(    |<!--|\|)/)
                prose = $0
        } else if (html) {
            rest = $0
            while (match(rest, /(id|class)="[^"]*"/)) {
                names = names " " substr(rest, RSTART, RLENGTH)
                rest = substr(rest, RSTART + RLENGTH)
            }
            gsub(/(id|class)=|"/, " ", names)
        } else if (mark != "") {
            if (match($0, "(^|[ \t])" mark))
                prose = substr($0, RSTART)
        } else {
            rest = $0
            while (rest != "")
                if (comment) {
                    end = index(rest, "*/")
                    prose = prose " " (end ? substr(rest, 1, end - 1) : rest)
                    rest = end ? substr(rest, end + 2) : ""
                    comment = !end
                } else {
                    begin = index(rest, "/*")
                    names = names " " (begin ? substr(rest, 1, begin - 1) : rest)
                    rest = begin ? substr(rest, begin + 2) : ""
                    comment = begin > 0
                }
            gsub(/"([^"\\]|\\.)*"/, "\"\"", names)
            if (script && match(names, /(^|[ \t])\/\//)) {
                prose = prose " " substr(names, RSTART)
                names = substr(names, 1, RSTART)
            }
        }
        for (i = 1; i <= n; i++) {
            text = place[i] == "[names]" || (place[i] == "[names of the page]" && web) ? names \
                : place[i] == "[comments and pages]" ? tolower(prose) : ""
            if (text != "" && match(" " text " ", "[^A-Za-z0-9_](" pattern[i] ")[^A-Za-z0-9_]"))
                printf "%s:%d: \"%s\": write: %s\n", FILENAME, FNR,
                    substr(" " text " ", RSTART + 1, RLENGTH - 2), instead[i]
        }
    }' tests/words.txt "$@"
}

find vm base asm rt scenes web tests docs .ci README.md Makefile \
    -name node_modules -prune -o -type f \( -path '.ci/*' -o -path 'docs/s*/*.*' \
    -o -name Makefile -o -name '*.[chs]' -o -name '*.js' -o -name '*.mjs' -o -name '*.css' \
    -o -name '*.html' \
    -o -name '*.cc' -o -name '*.md' -o -name '*.inc' -o -name '*.pov' -o -name '*.sh' \
    -o -name '*.awk' -o -name '*.mk' -o -name '*.csv' -o -name '*.model' -o -name '*.txt' \) \
    ! -name isa.md ! -name words.txt ! -name NOTICE.md -print >"$work/files"
# The names contain no blanks.
# shellcheck disable=SC2046
faults $(cat "$work/files") >"$work/faults"
if [ -s "$work/faults" ]; then
    cat "$work/faults"
    fail "words that tests/words.txt replaces: $(wc -l <"$work/faults")"
else
    pass
fi

planted() { # FILE LINE WORD: a copy with this line must have a fault about the word
    cp "$1" "$work/planted.${1##*.}"
    printf '%b\n' "$2" >>"$work/planted.${1##*.}"
    if faults "$work/planted.${1##*.}" | grep -q "\"$3\""; then
        pass
    else
        fail "a planted word is not found: $2"
    fi
}
planted base/arena.c '/* Blocks by chance,\n * one at the most. */' 'by chance'
planted base/arena.c '/* Blocks,\n * one at the most. */' 'at the most'
planted base/arena.c 'enum { BLOCKS_MOST = 1 };' BLOCKS_MOST
planted README.md 'The clock goes on.' 'goes on'
planted README.md 'That is told later.' told
planted tests/programs/keep.inc '; A word that goes on.' 'goes on'
planted vm/models/cyber720.model '# The load stands before it.' 'stands before'
planted scenes/first.pov 'sphere { 0, 1 } // told' told
planted web/page/bar.js 'const told = 1;' told
planted web/page/bar.js 'class Bar { #asked = "a // b"; }' asked
planted web/page/bar.js 'const PATIENCE = 3;' PATIENCE
planted web/page/bar.js 'sayClock(); // the clock' sayClock
planted web/page/bar.js 'run(); // The run goes on.' 'goes on'
planted web/tests/browser/run.mjs 'const kept = 1;' kept
planted web/page/page.css '.said-at { top: 0; }' said-at
planted web/page/index.html '<p id="told">A text that is kept</p>' told
planted docs/site/lay.sh 'echo told \0043 anew' anew
counted
