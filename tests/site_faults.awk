# site_faults.awk - prints the faults of a site of HTML files, one per line:
#
#   cd SITE && find . -type f | awk -f site_faults.awk
#
# - a link, picture, script .. without its file, or without its anchor in the file;
# - anything but a link that is loaded from another host, in HTML, SVG and style sheets.
#
# An address from the root "/" belongs to the site. Files in page/ are skipped: that
# page has separate tests.

function complain(file, text) {
    print file ": " text
}

# Resolves a path relative to a folder: "docs", "../a.html" -> "a.html"
function joined(folder, path,    parts, count, i, kept, text) {
    if (path ~ /^\//)
        folder = ""
    count = split(folder "/" path, parts, "/")
    kept = 0
    for (i = 1; i <= count; i++) {
        if (parts[i] == "..")
            kept--
        else if (parts[i] != "" && parts[i] != ".")
            parts[++kept] = parts[i]
    }
    for (i = 1; i <= kept; i++)
        text = text (i > 1 ? "/" : "") parts[i]
    return text
}

function foreign(address) {
    return address ~ /^([a-z]+:)?\/\//
}

function address(file, tag, name, value) {
    gsub(/&amp;/, "\\&", value)
    if (foreign(value)) {
        if (tag != "a")
            complain(file, tag " " name " asks another host: " value)
    } else if (value !~ /^[a-z]+:/ && value != "")
        links[++count] = file SUBSEP value
}

function attributes(file, text,    tag, name, value) {
    tag = tolower(text)
    sub(/[ \t\n\/>].*/, "", tag)
    while (match(text, /[ \t\n](id|name|href|xlink:href|src|srcset|poster|data|action)=("[^"]*"|'[^']*'|[^ >]*)/)) {
        name = substr(text, RSTART + 1, RLENGTH - 1)
        text = substr(text, RSTART + RLENGTH)
        value = name
        sub(/=.*/, "", name)
        sub(/^[^=]*=/, "", value)
        gsub(/^["']|["']$/, "", value)
        if (name == "id" || (name == "name" && tag == "a"))
            anchors[file, value]
        else if (name != "name")
            address(file, tag, name, value)
    }
}

function read_tags(file,    text, folder) {
    RS = "<"
    while ((getline text <file) > 0) {
        if (text ~ /url\(["']?([a-z]+:)?\/\//)
            complain(file, "a style asks another host")
        if (text ~ /^[a-zA-Z]/) {
            sub(/>.*/, "", text)
            attributes(file, text)
        }
    }
    RS = "\n"
    close(file)
}

function read_style(file,    text) {
    while ((getline text <file) > 0)
        if (text ~ /url\(["']?([a-z]+:)?\/\// || text ~ /@import/)
            complain(file, "asks another host, or another sheet")
    close(file)
}

{
    sub(/^\.\//, "")
    files[$0]
}
END {
    for (file in files)
        if (file ~ /^page\//)
            continue
        else if (file ~ /\.(html|svg)$/)
            read_tags(file)
        else if (file ~ /\.css$/)
            read_style(file)
    for (i = 1; i <= count; i++) {
        split(links[i], link, SUBSEP)
        folder = link[1]
        if (!sub(/\/[^\/]*$/, "", folder))
            folder = ""
        path = anchor = link[2]
        sub(/[?#].*/, "", path)
        if (!sub(/^[^#]*#/, "", anchor))
            anchor = ""
        to = path == "" ? link[1] : joined(folder, path)
        if (to == "" || to "/index.html" in files)
            to = to == "" ? "index.html" : to "/index.html"
        if (!(to in files))
            complain(link[1], "leads nowhere: " link[2])
        else if (anchor != "" && to ~ /\.html$/ && to !~ /^page\// && !((to, anchor) in anchors))
            complain(link[1], "no such anchor: " link[2])
    }
}
