# messages.awk - lists the messages of the programs and of the page for reading.
#
#     awk -f messages.awk FILE ..
#
# A line has FILE:LINE: and the text. The messages are
#   of a C file, the string literals in calls of the functions that report, those that a
#     function returns, and those that a variable for a reason is set to;
#   of a .def file, all string literals with a space;
#   of JavaScript, the string literals and templates in calls of say and new Error.
# Literals next to each other are one text. Texts without a space are not listed.

BEGIN {
    calls = "bad|broken|cmd_failed|cmd_print_line|cmd_usage|csv_wrong|dap_fault|" \
        "debug_fault|diagnostics_add|error_set|evaluate_range|expect_name|expected|" \
        "expected_name|fail|fail_whole|failed|fault|give_up|halt|image_file_read|" \
        "layout_fail|operand_found_vector|parse_integer|primitive_leave_out|" \
        "reader_expected|reader_fault|reader_report|reader_warn|refuse|report|" \
        "report_file|report_full|report_printf|runtime_report|send_refusal|" \
        "serializer_refuse|serializer_require|set_path_error|shape_empty|" \
        "shape_leave_out|warn|wrong|wrong_limit"
    reason = "(problem|reason|why|message)"
}

# Returns the position after the literal that begins at `at`.
function literal_end(text, at,    quote, c) {
    quote = substr(text, at, 1)
    while ((c = substr(text, ++at, 1)) != quote && c != "")
        if (c == "\\")
            at++
    return at + 1
}

# Prints the literals from `at` to a parenthesis (1) or a semicolon (0).
function list(at, parentheses,    c, depth, end, words, start, between) {
    depth = parentheses
    while ((c = substr(source, at, 1)) != "") {
        if (c == "\"" || c == "`") {
            if (!start)
                start = at
            end = literal_end(source, at)
            words = words substr(source, at + 1, end - at - 2)
            at = end
            continue
        }
        # A macro such as PRIu64 continues the text.
        if (c !~ /[ \n]/ && start && !(script == 0 && substr(source, at) ~ /^PRI[a-zA-Z0-9]*/)) {
            put(start, words)
            words = start = ""
        } else if (start && c == "P") {
            match(substr(source, at), /^PRI[a-zA-Z0-9]*/)
            at += RLENGTH
            continue
        }
        depth += (c ~ /[({\[]/) - (c ~ /[)}\]]/)
        if (c == ";" || (parentheses && depth == 0))
            break
        at++
    }
    if (start)
        put(start, words)
}

function put(start, words,    line) {
    if (words !~ / / || words !~ /[a-z][a-z]/ || start in listed)
        return
    listed[start]
    line = 1
    while (line < lines && begins[line + 1] <= start)
        line++
    print file ":" line ": " words
}

# Replaces comments by spaces. Literals remain.
function without_comments(text,    at, end, plain, c) {
    while (match(text, /["'`]|\/[*\/]/)) {
        plain = plain substr(text, 1, RSTART - 1)
        text = substr(text, RSTART)
        c = substr(text, 1, 2)
        if (c == "/*" || c == "//") {
            end = c == "/*" ? index(text, "*/") + 2 : index(text "\n", "\n")
            comment = substr(text, 1, end - 1)
            gsub(/[^\n]/, " ", comment)
            plain = plain comment
        } else {
            end = literal_end(text, 1)
            plain = plain substr(text, 1, end - 1)
        }
        text = substr(text, end)
    }
    return plain text
}

function list_file(    rest, at, pattern, called) {
    script = file ~ /[.]js$/
    source = without_comments(source)
    split("", listed)
    if (file ~ /[.]def$/) {
        list(1, 0)
        return
    }
    pattern = script ? "(^|[^a-zA-Z0-9_.])(say|new Error)[(]" \
        : "(^|[^a-zA-Z0-9_.>])((" calls ")[(]|return \"|return [^;\"]*[?] *\"|" reason " = )"
    at = 1
    rest = source
    while (match(rest, pattern)) {
        called = substr(rest, RSTART, RLENGTH)
        at += RSTART + RLENGTH - 1 - (called ~ /"$/)
        list(at, called ~ /[(]$/)
        at += called ~ /"$/
        rest = substr(source, at)
    }
}

FNR == 1 {
    if (file)
        list_file()
    file = FILENAME
    source = ""
    lines = 0
}
{
    begins[++lines] = length(source) + 1
    source = source $0 "\n"
}
END { list_file() }
