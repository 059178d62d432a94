#!/bin/sh
# deck.sh PAGE - converts a lecture in Markdown to a deck of slides: one self-contained
# HTML file, on stdout.
#
# Each heading begins a slide, and quotations are the notes for the speaker. The command
# of a printed block is above the block, so the line below it is left out. A browser shows
# and prints the deck; with #notes, the notes are below the slides.
set -eu
cd "$(dirname "$0")/../.."
page=$1
title=$(sed -n 's/^# //p' "$page")
cat <<END
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>$title</title>
<style>
$(cat docs/slides/deck.css)
</style>
</head>
<body>
END
awk -v page="$page" -v families=/dev/null -v linked=/dev/null \
    -f docs/site/page.awk "$page" |
    sed "/^Printed by /d" |
    markdown_py -x tables -x fenced_code |
    awk -v folder="$(dirname "$page")" -f docs/slides/deck.awk
cat <<END
<script>
$(cat docs/slides/deck.js)
</script>
</body>
</html>
END
