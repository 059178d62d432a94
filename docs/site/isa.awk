# isa.awk - splits docs/isa.md: writes a page for each family of instructions to a
# folder, and all other text, which begins with the index, to stdout.
#
# The file `families` gets a line "ANCHOR PAGE" for each instruction.
#
#   awk -v folder=DIR -v families=FILE -f isa.awk docs/isa.md

function page_of(title) {
    sub(/:.*/, "", title)
    title = tolower(title)
    gsub(/[^a-z]+/, "-", title)
    return "docs/isa/" title ".md"
}

# Returns a line whose links are valid one folder deeper.
function deeper(line,    done) {
    gsub(/\]\(#/, "](isa.md#", line)
    while (match(line, /\]\([a-z]+\.md/)) {
        done = done substr(line, 1, RSTART + 1) "../" \
            substr(line, RSTART + 2, RLENGTH - 2)
        line = substr(line, RSTART + RLENGTH)
    }
    return done line
}

# In the index, the title of a family links to its page.
/^- / && match($0, /: \[/) {
    title = substr($0, 3, RSTART - 3)
    family = page_of(title)
    sub(/^docs\//, "", family)
    $0 = "- [" title "](" family ")" substr($0, RSTART)
}
# A section is a family if its first line is the heading of an instruction.
/^## / {
    heading = $0
    page = ""
    next
}
heading != "" && /^$/ { next }
heading != "" && /^### / {
    title = substr(heading, 4)
    page = page_of(title)
    print "# " title "\n" >(folder "/" page)
}
heading != "" && page == "" { print heading "\n" }
{ heading = "" }
page == "" { print; next }
/^### / {
    print tolower($2), page >families
    sub(/^#/, "")
}
{ print deeper($0) >(folder "/" page) }
