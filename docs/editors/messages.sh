#!/bin/sh
# messages.sh - converts lines "REQUEST ARGUMENTS" to messages of the Debug Adapter
# Protocol with their headers, as input of c205 debug --dap.
awk '{
    arguments = substr($0, length($1) + 2)
    text = "{\"seq\": " NR ", \"type\": \"request\", \"command\": \"" $1 "\"" \
        (arguments == "" ? "" : ", \"arguments\": " arguments) "}"
    printf "Content-Length: %d\r\n\r\n%s", length(text), text
}'
