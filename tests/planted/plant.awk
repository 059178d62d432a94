# plant.awk - makes faults that the project had earlier.
#
#     awk -f masked.awk -f plant.awk LIST
#         prints "FILE NUMBER LINE WHAT" for each fault of the list; one without a
#         place is reported on stderr, and the status is 1
#     awk -f masked.awk -f plant.awk -v number=3 LIST
#         prints the file with this fault
#     awk -f masked.awk -f plant.awk -v number=3 -v parts=1 LIST
#         prints the part that finds it
#
# The list has a paragraph for each fault:
#
#     # description
#     ! the part of make check that must find it
#     = file
#     - correct text, in one or more such lines
#     + text that replaces it
#
# A text is found by its tokens; blanks and comments do not count. A name or a quoted
# text matches any other, consistently; all other tokens, and names of instructions,
# match themselves alone. Of the places that match, the one with the most unchanged
# names is chosen. It must be unique, also if any one of the names were changed, so that
# a fault is still found after a renaming.

# Appends the tokens of a line; their positions are those of its masked code.
function take_tokens(line, row,    code, p) {
    code = masked(line)
    for (p = 1; match(substr(code, p), /[A-Za-z_0-9.]+|"+|[^ \t]/); p += RLENGTH) {
        p += RSTART - 1
        token[++tokens] = substr(line, p, RLENGTH)
        rows[tokens] = row
        places[tokens] = p
    }
}

function is_open(word) {
    return word ~ /^["']/ || word ~ /^[A-Za-z_]/ && !(assembly && word ~ /^[A-Z]+$/) &&
        word !~ /^(if|else|for|while|case|return|struct|const|true|false|NULL)$/
}

# Returns whether the correct text can begin at token `at`.
function matches(at,    i, k) {
    for (i = 1; i <= n; i++)
        if (!open[i]) {
            if (token[at + i] != right[i])
                return 0
        } else if (!is_open(token[at + i]))
            return 0
    for (i = 1; i <= n; i++)
        for (k = 1; k < i; k++)
            if (right[k] == right[i] && token[at + k] != token[at + i])
                return 0
    return 1
}

# Returns the only candidate with the most unchanged names, without counting `other`.
function best_place(other,    c, i, unchanged, best, place) {
    best = -1
    for (c = 1; c <= candidates; c++) {
        unchanged = 0
        for (i = 1; i <= n; i++)
            unchanged += right[i] != other && right[i] == token[candidate[c] + i]
        if (unchanged >= best)
            place = unchanged > best ? candidate[c] : ""
        if (unchanged > best)
            best = unchanged
    }
    return place
}

# Sets `before`, the token before the correct text. Returns a reason if it has no place.
function find_place(    i, at, line) {
    assembly = file ~ /\.s$/
    tokens = commented = lines = candidates = 0
    take_tokens(was)
    n = tokens
    for (i = 1; i <= n; i++) {
        right[i] = token[i]
        open[i] = is_open(token[i])
    }
    tokens = 0
    while ((getline line <file) > 0) {
        text[++lines] = line
        take_tokens(line, lines)
    }
    close(file)
    for (at = 0; at + n <= tokens; at++)
        if (matches(at))
            candidate[++candidates] = at
    before = best_place("")
    if (before == "")
        return "no place, or more than one"
    for (i = 1; i <= n; i++)
        if (open[i] && best_place(right[i]) != before)
            return "it is lost if " right[i] " has another name"
    return ""
}

# Returns the wrong text, with the names that the correct text matched.
function renamed(    i, line, out, p, word) {
    line = wrong
    while (match(line, /[A-Za-z_][A-Za-z_0-9.]*/)) {
        word = substr(line, RSTART, RLENGTH)
        for (i = n; i > 0; i--)
            if (right[i] == word)
                word = token[before + i]
        out = out substr(line, 1, RSTART - 1) word
        line = substr(line, RSTART + RLENGTH)
    }
    return out line
}

function print_planted(    i, first, last) {
    first = before + 1
    last = before + n
    for (i = 1; i <= lines; i++)
        if (i == rows[first])
            print substr(text[i], 1, places[first] - 1) renamed() \
                substr(text[rows[last]], places[last] + length(token[last]))
        else if (i < rows[first] || i > rows[last])
            print text[i]
}

function end_fault(    reason) {
    if (wrong == "" && was == "")
        return
    faults++
    if (number == "") {
        reason = find_place()
        if (reason == "")
            print file, faults, rows[before + 1], what
        else
            print "FAIL " file ": " what ": " reason >"/dev/stderr"
        failed += reason != ""
    } else if (number == faults && parts)
        print part
    else if (number == faults && find_place() == "")
        print_planted()
    was = wrong = ""
}

/^# / { what = substr($0, 3) }
/^! / { part = substr($0, 3) }
/^= / { file = substr($0, 3) }
/^- / { was = was " " substr($0, 3) }
/^\+/ { wrong = wrong (wrong == "" ? "" : "\n") substr($0, 3) }
/^$/ { end_fault() }

END {
    end_fault()
    exit failed > 0
}
