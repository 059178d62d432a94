# page_faults.awk - prints the faults of pages in Markdown, one per line:
#
#   awk -f page_faults.awk PAGE ..
#
# - a table that is not rendered as one: a row without a head, a row with more or fewer
#   cells than its head, no empty line before it or after it;
# - a link whose file or heading does not exist, or that has no target;
# - a paragraph without an end, a sentence that begins in the middle of another one;
# - a figure followed by "times" or "%" in README.md or on the first screen of a page
#   (its first 40 lines), unless a printed block of the same section contains it (see
#   check_docs.sh) or its sentence names its source.

BEGIN {
    SCREEN = 40
    SOURCES = "Plunkett|Purdue|LINPACK|Livermore|GAMTEB|Control Data"
    FIGURE = "[0-9][0-9.,]*"
    MULTIPLE = FIGURE "((,| and| or| to) +" FIGURE ")*( |-)*(%|times|x (as|faster|slower)|×|per ?cent|fold)"
    # Words that begin a sentence, and seldom follow another word with a capital.
    BEGINS = "^(The|An|It|This|That|These|Those|If|When|Where|What|They|There|In|Its|But|So|And|For|Each|Every|Here|Then|No|Not|With|Without|As|At|By|On|To) "
}

function complain(line, text) {
    print page ":" line ": " text
}

# ---- Figures -----------------------------------------------------------------

function plain(figure) {
    gsub(/,/, "", figure)
    sub(/\.$/, "", figure)
    return figure
}

function keep_printed(line) {
    while (match(line, FIGURE)) {
        printed[section, plain(substr(line, RSTART, RLENGTH))]
        line = substr(line, RSTART + RLENGTH)
    }
}

function keep_figures(line, text,    count, sentences, i, rest, found) {
    gsub(/[`*]/, "", text)
    gsub(/[.!?][")*_]* +[A-Z]/, "\n&", text)
    count = split(text, sentences, "\n")
    for (i = 1; i <= count; i++) {
        rest = sentences[i]
        if (rest ~ SOURCES)
            continue
        while (match(rest, MULTIPLE)) {
            found = substr(rest, RSTART, RLENGTH)
            rest = substr(rest, RSTART + RLENGTH)
            while (match(found, FIGURE)) {
                figure_line[++figures] = line
                figure_section[figures] = section
                figure[figures] = substr(found, RSTART, RLENGTH)
                found = substr(found, RSTART + RLENGTH)
            }
        }
    }
}

function check_figures(    i) {
    for (i = 1; i <= figures; i++)
        if (!((figure_section[i], plain(figure[i])) in printed))
            complain(figure_line[i], "no command printed the figure " figure[i])
}

# ---- Links -------------------------------------------------------------------

# Returns the anchor by which links refer to a heading.
function anchor_of(heading) {
    heading = tolower(heading)
    gsub(/`|\*|\]\([^)]*\)/, "", heading)
    gsub(/[^a-z0-9_ \200-\377-]/, "", heading)
    gsub(/ /, "-", heading)
    return heading
}

# Returns true if a file exists. Each file is looked up once.
function is_there(file) {
    if (!(file in exists)) {
        exists[file] = file !~ /'/ && !system("[ -e '" file "' ]")
        if (exists[file] && file ~ /\.md$/)
            read_anchors(file)
    }
    return exists[file]
}

function read_anchors(file,    line, fenced, name) {
    while ((getline line <file) > 0) {
        if (line ~ /^```/)
            fenced = !fenced
        if (!fenced && sub(/^#+ +/, "", line)) {
            name = anchor_of(line)
            anchors[file, name (uses[file, name] ? "-" uses[file, name] : "")]
            uses[file, name]++
        }
    }
    close(file)
}

function joined(folder, path,    parts, count, i, kept, text) {
    count = split(folder path, parts, "/")
    for (i = 1; i <= count; i++)
        if (parts[i] == "..")
            kept--
        else if (parts[i] != "" && parts[i] != ".")
            parts[++kept] = parts[i]
    for (i = 1; i <= kept; i++)
        text = text (i > 1 ? "/" : "") parts[i]
    return text
}

function check_link(line, target,    file, folder, anchor) {
    if (target ~ /^(https?|mailto):/)
        return
    file = anchor = target
    sub(/#.*/, "", file)
    if (!sub(/^[^#]*#/, "", anchor))
        anchor = ""
    folder = page
    sub(/[^\/]*$/, "", folder)
    file = file == "" ? page : joined(folder, file)
    if (target == "" || !is_there(file))
        complain(line, "a link to nothing: " target)
    else if (anchor != "" && file ~ /\.md$/ && !((file, anchor) in anchors))
        complain(line, "a link to no heading: " target)
}

# Checks the links of a text without code.
function check_links(line, text,    target) {
    if (text ~ /\]\[[^\]]|\] \([^ )]*(\.md|#)[^ )]*\)/)
        complain(line, "a link without a target")
    while (match(text, /\]\([^)]*\)/)) {
        target = substr(text, RSTART + 2, RLENGTH - 3)
        text = substr(text, RSTART + RLENGTH)
        sub(/ +"[^"]*"$/, "", target)
        check_link(line, target)
    }
}

# ---- Tables ------------------------------------------------------------------

function cells_of(row) {
    gsub(/\\\|/, "", row)
    sub(/^ *\|/, "", row)
    sub(/\| *$/, "", row)
    return gsub(/\|/, "", row) + 1
}

function check_row(line) {
    if (!rows++) {
        if (before != "")
            complain(FNR, "a table without an empty line before it")
        width = cells_of(line)
    } else if (rows == 2 && line !~ /^[|: -]+$/)
        complain(FNR - 1, "a row of a table without a head")
    else if (cells_of(line) != width)
        complain(FNR, "a row of " cells_of(line) " cells in a table of " width)
}

function end_table(line) {
    if (rows == 1)
        complain(FNR - 1, "a row of a table without a head")
    if (rows && line != "")
        complain(FNR, "a table without an empty line after it")
    rows = 0
}

# ---- Paragraphs --------------------------------------------------------------

function without_code(text) {
    gsub(/``[^`]+(`[^`]+)*``/, "X", text)
    gsub(/`[^`]*`/, "X", text)
    return text
}

# A sentence may continue in a block, for instance a formula, in a table or in a list.
function check_end(next_line) {
    if (open_end && next_line !~ /^(    |<| ? ? ?[|]|[-*+] |[0-9]+\.)/)
        complain(open_line, "a paragraph without an end: .." open_end)
    open_end = ""
}

function check_sentences(line, text) {
    if (text !~ /[.:;!?]["')*_]*$/ && text !~ /^(<|!\[|[*][*][^*]*[*][*]$|[-*+] |[0-9]+\. )/) {
        open_end = substr(text, length(text) - 30)
        open_line = line
    }
    sub(/^([-*+]|[0-9]+\.) +/, "", text)
    gsub(/(e\.g|i\.e|cf|etc|vs)\./, "", text)
    if (match(text, /[^. ][.!?] [a-z][a-z]+ /))
        complain(line, "a sentence begins in lower case: " substr(text, RSTART, 40))
}

function end_paragraph() {
    if (paragraph == "")
        return
    check_links(begin, without_code(paragraph))
    if (!is_heading && !is_row)
        check_sentences(begin, without_code(paragraph))
    if (page ~ /README\.md$/ || begin <= SCREEN)
        keep_figures(begin, paragraph)
    paragraph = ""
}

function add_line(line) {
    if (paragraph == "")
        begin = FNR
    else if (paragraph ~ /[a-z,]$/ && line ~ BEGINS)
        complain(FNR, "a sentence begins within another one: " substr(line, 1, 40))
    sub(/^ +/, "", line)
    paragraph = paragraph (paragraph == "" ? "" : " ") line
}

function begin_page() {
    end_page()
    page = FILENAME
    section = figures = rows = in_code = after_mark = is_code = 0
    before = ""
    split("", printed)
}

function end_page() {
    end_paragraph()
    check_end("")
    end_table("")
    check_figures()
    figures = 0
}

FNR == 1 { begin_page() }
!/^$/ { check_end($0) }
/^```/ { end_paragraph(); in_code = !in_code; before = $0; next }
in_code { next }
/^<!--/ {
    end_paragraph()
    end_table($0)
    after_mark = /printed( slowly)? by:/
    before = ""
    next
}
/^    / && paragraph == "" {
    if (after_mark)
        keep_printed($0)
    before = $0
    next
}
/^$/ { end_paragraph(); end_table(""); before = ""; next }
{ is_heading = is_row = 0 }
/^#/ {
    end_paragraph()
    section++
    is_heading = 1
}
/^ ? ? ?\|/ {
    end_paragraph()
    check_row($0)
    is_row = 1
}
!/^ ? ? ?\|/ { end_table($0) }
/^ *([-*+]|[0-9]+\.) / { end_paragraph() }
{
    after_mark = 0
    add_line($0)
    before = is_heading ? "" : $0
}
is_heading || is_row { end_paragraph() }
END { end_page() }
