# masked.awk - masks a line of C, or of the assembler if `assembly` is set. `commented`
# must be 0 before the first line of a file.

function repeated(c, n,    text) {
    for (text = c; length(text) < n; text = text text)
        ;
    return substr(text, 1, n)
}

# Returns the line at the same length with comments, the first lines of directives and
# the contents of quotes masked.
function masked(line,    done, found, n) {
    if (!assembly && !commented && line ~ /^#/)
        return repeated(" ", length(line))
    while (line != "") {
        if (commented) {
            n = index(line, "*/")
            commented = n == 0
            n = n ? n + 1 : length(line)
            done = done repeated(" ", n)
        } else if (match(line, assembly ? ";|[\"']" : "/[*]|//|[\"']")) {
            found = substr(line, RSTART, RLENGTH)
            done = done substr(line, 1, RSTART - 1)
            line = substr(line, RSTART)
            if (found ~ /["']/) {
                match(line, "^" found "([^\\\\" found "]|\\\\.)*" found "?")
                done = done repeated("\"", RLENGTH)
            } else if (found == "/*") {
                commented = 1
                RLENGTH = 2
                done = done "  "
            } else
                return done repeated(" ", length(line))
            n = RLENGTH
        } else
            return done line
        line = substr(line, n + 1)
    }
    return done
}
