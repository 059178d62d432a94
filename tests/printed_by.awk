# printed_by.awk - writes or checks the line that names a printed block's command.
#
#     awk -v write=1 -f printed_by.awk PAGE    prints the page with these lines
#     awk -f printed_by.awk PAGE               prints missing or wrong lines
#
# The line is "Printed by `COMMAND`." The command is that of the comment above the
# block, up to its first " | ", if that is one command of the project.

function command_of(comment,    text) {
    text = comment
    sub(/^<!-- printed( slowly)? by: /, "", text)
    sub(/ -->$/, "", text)
    sub(/ \|.*| *2>.*/, "", text)
    gsub(/"?\$BUILD"?\//, "build/", text)
    gsub(/\$DRAWN\//, "", text)
    return text ~ /^([A-Z]+=[^ ]* )?(c205|rt205|fit205|build\/)[^;$]*$/ ? text : ""
}

# Called before the line after a block.
function end_block(line) {
    if (wanted && line == wanted) {
        put(line)
        wanted = ""
        return 1
    }
    if (wanted && write)
        printf "%s\n\n", wanted
    else if (wanted)
        printf "%s:%d: missing: %s\n", FILENAME, FNR, wanted
    wanted = ""
    return 0
}

function put(line) {
    if (write)
        print line
}

/^<!-- printed( slowly)? by: / {
    if (inside)
        end_block("")
    inside = 0
    command = command_of($0)
    wanted = command ? "Printed by `" command "`." : ""
    put($0)
    next
}
wanted && /^    / { inside = 1 }
wanted && inside && /^[^ ]/ {
    inside = 0
    if (end_block($0))
        next
}
write && /^Printed by `.*`\.$/ { dropped = 1; next }
write && dropped && /^$/ { dropped = 0; next }
{ dropped = 0; put($0) }
END {
    if (wanted && inside)
        end_block("")
}
