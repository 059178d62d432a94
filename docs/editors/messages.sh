#!/bin/sh
# messages.sh - lines "REQUEST ARGUMENTS" become framed messages of the Debug Adapter
# Protocol: to see what c205 debug --dap answers.
awk '{
    arguments = substr($0, length($1) + 2)
    text = "{\"seq\": " NR ", \"type\": \"request\", \"command\": \"" $1 "\"" \
        (arguments == "" ? "" : ", \"arguments\": " arguments) "}"
    printf "Content-Length: %d\r\n\r\n%s", length(text), text
}'
