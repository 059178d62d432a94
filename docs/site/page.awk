# page.awk - converts a page of the manual to the Markdown of MkDocs.
#
#   awk -v page=docs/tracer.md -v families=FILE -v linked=FILE -f page.awk PAGE
#
# - A link to a file that is not a page gets the page that shows the file as its target.
#   The file `linked` gets the paths of these files in the repository.
# - A link to an instruction gets the page of its family as its target. The file
#   `families` has a line "ANCHOR PAGE" for each instruction.
# - A printed block has above it the command that prints it, or the name of the file that
#   it shows. A program is highlighted.
# - The contents of <details> are Markdown, too.

# Returns a path relative to the root: "docs", "../rt/x.s" -> "rt/x.s".
function joined(folder, path,    parts, count, i, text, kept) {
    count = split(folder "/" path, parts, "/")
    kept = 0
    for (i = 1; i <= count; i++) {
        if (parts[i] == ".." && kept)
            kept--
        else if (parts[i] != "" && parts[i] != "." && parts[i] != "..")
            parts[++kept] = parts[i]
    }
    text = parts[1]
    for (i = 2; i <= kept; i++)
        text = text "/" parts[i]
    return text
}

# Returns the path of a file relative to this page, through the root.
function from_here(path,    up, text) {
    up = page
    while (sub(/^[^\/]*\//, "", up))
        text = text "../"
    return text path
}

# Returns the target of a link in the manual.
function mended(target,    path, anchor) {
    if (target ~ /^[a-z]+:/)
        return target
    path = target
    anchor = ""
    if (path ~ /#/) {
        anchor = path
        sub(/#.*/, "", path)
        sub(/^[^#]*#/, "", anchor)
    }
    path = path == "" ? page : joined(folder, path)
    if (path == "docs/isa.md" && anchor in family)
        return from_here(family[anchor]) "#" anchor
    if (path ~ /\.md$/ && path != "README.md" && path !~ /^docs\//)
        print path >linked
    if (path ~ /\.(md|png|svg|jpg|html|pdf)$/)
        return path == page ? "#" anchor : from_here(path) (anchor == "" ? "" : "#" anchor)
    print path >linked
    return from_here(path) (target ~ /\/$/ ? "/index.md" : ".md")
}

# Returns code without the backslashes before bars: MkDocs does not end a cell at a bar in
# code.
function with_bars(code) {
    gsub(/\\\|/, "|", code)
    return code
}

# Returns a line with the targets of the manual. Code is not searched for links.
function links_mended(line,    done, piece) {
    done = ""
    while (match(line, /`[^`]*`|\]\([^) ]*\)/)) {
        piece = substr(line, RSTART, RLENGTH)
        done = done substr(line, 1, RSTART - 1)
        line = substr(line, RSTART + RLENGTH)
        if (piece ~ /^`/)
            piece = with_bars(piece)
        else
            piece = "](" mended(substr(piece, 3, length(piece) - 3)) ")"
        done = done piece
    }
    return done line
}

# Returns a text for HTML.
function escaped(text) {
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    return text
}

BEGIN {
    folder = page
    if (!sub(/\/[^\/]*$/, "", folder))
        folder = ""
    while ((getline line < families) > 0) {
        split(line, words, " ")
        family[words[1]] = words[2]
    }
}
/^```/ {
    sub(/c205/, "nasm")
    fenced = !fenced
}
# A printed program becomes a block with the name of its language.
program == 1 && /^    / {
    print "```nasm"
    program = 2
}
program == 2 && /^$/ {
    gap = gap "\n"
    next
}
program == 2 && /^    / {
    print gap substr($0, 5)
    gap = ""
    next
}
program == 2 {
    print "```" gap
    gap = ""
    program = 0
}
fenced || /^    / { print; next }
/^<!-- printed( slowly)? by: .* -->$/ {
    sub(/^<!-- printed( slowly)? by: /, "")
    sub(/ -->$/, "")
    sub(/ \| .*/, "")
    sub(/ -o \$DRAWN\/[^ ]*/, "")
    if (/^(c205|rt205|fit205) /)
        print "<p class=\"printed\">" escaped($0) "</p>"
    else if ($NF ~ /\//)
        print "<p class=\"shown\">" escaped($NF) "</p>"
    program = $NF ~ /\.s$/ && !/^(c205|rt205|fit205) /
    next
}
{
    gsub(/<details>/, "<details markdown=\"1\">")
    print links_mended($0)
}
END {
    if (program == 2)
        print "```"
}
