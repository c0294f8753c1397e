#!/usr/bin/env bash
# Pages in a real browser: `check.sh PAIRTRAWL SCENE PLAN FOLDER`. Says plainly when it is skipped.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
pairtrawl=$1 scene=$2 plan=$3 out=$4

if ! command -v npm >/dev/null; then
    echo "skipped: pages in a browser need Node.js and npm"
    exit 0
fi
browser() { command -v chromium || command -v chromium-browser || command -v google-chrome; }
if ! browser >/dev/null && [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    apt-get install --yes --quiet chromium poppler-utils >/dev/null 2>&1 || true
fi
if ! CHROMIUM=$(browser); then
    echo "skipped: there is no Chromium to open pages with"
    exit 0
fi
export CHROMIUM
mkdir -p "$out"
if ! npm install --silent --no-save --prefix "$out" playwright-core >/dev/null; then
    echo "skipped: playwright-core cannot be installed"
    exit 0
fi

# One drive with far more in the net than the robots can tow: a report of failure.
status=0
"$pairtrawl" run "$scene" "$plan" --trials 1 --quick --payload 40 -o "$out/failed" >/dev/null || status=$?
[ "$status" = 7 ] || { echo "the run should have failed with 7, not $status" >&2; exit 1; }
"$pairtrawl" rehearse "$scene" "$plan" --quick -o "$out/rehearsed" >/dev/null
cd "$out"
node "$here/check.mjs" "$out/rehearsed/report.html" "$out/failed/report.html"
