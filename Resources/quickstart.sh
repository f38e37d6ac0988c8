#!/usr/bin/env bash
# Installs what is missing, builds facetobone and plans a case.
#
#   bash Resources/quickstart.sh                 the project's own virtual patient
#   bash Resources/quickstart.sh CASE.json [DIR] your case, into DIR
set -euo pipefail

case "${1:-}" in -h | --help) sed -n '2,5s/^# \{0,1\}//p' "$0"; exit 0 ;; esac
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
: "${FACETOBONE_DATA:=$root/../shared/data}"
export FACETOBONE_DATA
case_file="${1:-}"
if [ -n "$case_file" ] && [ ! -f "$case_file" ]; then
  echo "quickstart: $case_file: there is no such file; give the path of a case file (JSON)" >&2
  exit 2
fi

# shellcheck source=Resources/install_packages.sh
source "$root/Resources/install_packages.sh"
install_missing_packages "$root/Resources/packages.txt"

log="$root/.build/release/quickstart.log"
mkdir -p "$(dirname "$log")"
echo "Building facetobone (the first time takes some minutes)"
if ! (cd "$root" && cmake --preset release && cmake --build --preset release --target facetobone) >"$log" 2>&1; then
  tail -n 30 "$log" >&2
  echo "The build failed; the whole log is $log" >&2
  exit 1
fi
facetobone="$root/.build/release/bin/facetobone"

if [ -z "$case_file" ]; then
  patient="$root/.build/quickstart/patient"
  echo "Making the virtual patient in $patient"
  "$facetobone" sample --out "$patient"
  case_file="$patient/case.json"
fi
name=$(basename "$case_file" .json)
plan="${2:-$root/.build/quickstart/plan-$name}"
echo "Planning $case_file"
"$facetobone" run "$case_file" --output "$plan"
