#!/usr/bin/env bash
# Opens a report in headless Chromium. The packages from npm are those of package-lock.json, installed
# once into a folder outside the sources.
#
#   bash Testing/Browser/test_report_page.sh WORK_FOLDER --install
#   bash Testing/Browser/test_report_page.sh WORK_FOLDER REPORT.html [CASE NAME]
# Exit code 77: this machine lacks Chromium, node or the npm packages.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work="$1"
shift
if [ "$1" = --install ]; then
  mkdir -p "$work"
  cmp -s "$here/package-lock.json" "$work/package-lock.json" && [ -d "$work/node_modules" ] && exit 0
  cp "$here/package.json" "$here/package-lock.json" "$work/"
  cd "$work"
  exec npm ci --ignore-scripts --no-audit --no-fund --loglevel=error
fi
if ! command -v node >/dev/null || ! command -v "${CHROMIUM:-chromium}" >/dev/null || [ ! -d "$work/node_modules" ]; then
  echo "skipped: no Chromium, node or npm packages here; bash Testing/run.sh installs them"
  exit 77
fi
cp "$here/report_page.mjs" "$work/" # beside node_modules, where node looks for them
exec node "$work/report_page.mjs" "$@"
