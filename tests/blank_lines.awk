# blank_lines.awk - prints FILE:LINE of each blank line between the declarations at the
# beginning of a block and its statements.
#
#   awk -f tests/blank_lines.awk FILE.c ..

function without_comment(text) {
    sub(/ *\/\*.*\*\/ *$/, "", text)
    return text
}

# Returns the number of braces that a line opens, minus those that it closes.
function opened(text, count) {
    gsub(/'[{}]'|"([^"\\]|\\.)*"/, "", text)
    count = gsub(/\{/, "", text)
    return count - gsub(/\}/, "", text)
}

function is_declaration(text) {
    if (substr(text, 1, length(margin)) != margin || substr(text, length(margin) + 1, 1) == " ")
        return 0
    text = substr(text, length(margin) + 1)
    if (text ~ /^(return|goto|break|continue|else|case|if|for|while|do|switch|default)[ ;(:]/)
        return 0
    return text ~ /^(static|const|struct|enum|union|SCOPED|SCOPED_VALUE|FREED)[ (]/ ||
        text ~ /^[A-Za-z_][A-Za-z0-9_]*( [A-Za-z_][A-Za-z0-9_]*)* [*(]*[A-Za-z_][A-Za-z0-9_]*(\[[^]]*\])*( =.*|;|,.*|\)\(.*)$/
}

FNR == 1 { state = "" }
{
    text = without_comment($0)
    if (state == "within") { # a declaration of several lines
        depth += opened(text)
        if (depth == 0 && text ~ /;$/)
            state = "after"
    } else if (state && text == "" && $0 != "") {
        next # a comment
    } else if (state == "after" && text == "") {
        print FILENAME ":" FNR
        state = ""
    } else if (state && is_declaration(text)) {
        depth = opened(text)
        state = depth == 0 && text ~ /;$/ ? "after" : "within"
    } else if (/^\{$/ || (/^ .*\{$/ && /(\)|else|do) \{$|^ +\{$|^ +(for|while|if|switch) /)) {
        match($0, /^ */)
        margin = sprintf("%*s", RLENGTH + 4, "")
        state = "begin"
    } else {
        state = ""
    }
}
