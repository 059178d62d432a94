#!/bin/sh
# deck.sh PAGE - a lecture in Markdown as a deck of slides, one HTML file with all that
# it needs, on stdout.  Each heading begins a slide; quotations are what the speaker
# says.  It is shown and printed by a browser; #notes prints the notes below.
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
    markdown_py -x tables -x fenced_code |
    awk -v folder="$(dirname "$page")" -f docs/slides/deck.awk
cat <<END
<script>
$(cat docs/slides/deck.js)
</script>
</body>
</html>
END
