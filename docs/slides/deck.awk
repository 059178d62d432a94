# deck.awk - converts the HTML of a lecture to slides: a section for each heading, with
# its pictures embedded.
#
#   markdown_py FILE | awk -v page=docs/slides/x.md -v folder=docs/slides -f deck.awk

function close_slide() {
    if (slides++)
        print "</section>"
}

# Returns a picture as an address of the form "data:image/png;base64,..".
function picture(path,    line, text, kind) {
    kind = path ~ /\.svg$/ ? "svg+xml" : "png"
    line = "base64 -w 0 " folder "/" path
    line | getline text
    close(line)
    return "data:image/" kind ";base64," text
}

/^<h[12][ >]/ {
    close_slide()
    print "<section" (/^<h1/ ? " class=\"first\"" : "") ">"
}
/<img / && match($0, /src="[^"]*"/) {
    path = substr($0, RSTART + 5, RLENGTH - 6)
    $0 = substr($0, 1, RSTART + 4) picture(path) substr($0, RSTART + RLENGTH - 1)
}
{ print }
END { close_slide() }
