#!/bin/sh
# check_web_engine.sh BUILD JOBS - compares the engine of the page, run in node, with
# c205. It runs every third program, or all programs with THOROUGH=1
# (web/tests/node/engine.mjs).
set -u
build=$1 jobs=$2
cd "$(dirname "$0")/.." || exit 1

if ! command -v node >/dev/null; then
    echo "there is no node: the engine of the page was not tried"
    echo "0 passed, 0 failed"
    exit 0
fi
seq 0 $((jobs - 1)) | xargs -I SHARE -P "$jobs" \
    node web/tests/node/engine.mjs "$build" SHARE $((${THOROUGH:+1} + 0 ? jobs : 3 * jobs))
