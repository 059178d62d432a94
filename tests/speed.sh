#!/bin/sh
# speed.sh FILE - prints the seconds since the time in FILE. They depend on the machine,
# so it also prints the time of a loop on one processor.
set -eu
seconds=$(($(date +%s) - $(cat "$1")))
begin=$(date +%s%N)
awk 'BEGIN { for (i = 0; i < 100000000; i++) sum += i }'
loop=$((($(date +%s%N) - begin) / 1000000))
echo "make check took $seconds s with the build; 100,000,000 additions in awk take $loop ms here"
