#!/usr/bin/env bash
# Builds everything and runs the tests.
#
#   bash Testing/run.sh                     quick tier: under 30 minutes on 2 cores
#   bash Testing/run.sh --full [--only N]   every count and the real CTs; resumes where it stopped
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
: "${FACETOBONE_DATA:=$root/../shared/data}"
export FACETOBONE_DATA
full=()
while [ $# -gt 0 ]; do
  case "$1" in
    --full) full=(--full) ;;
    --only) full+=(--only "${2:?--only needs a name}"); shift ;;
    -h | --help) sed -n '2,5s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) echo "run.sh: unknown argument $1; see --help" >&2; exit 2 ;;
  esac
  shift
done

# shellcheck source=Resources/install_packages.sh
source "$root/Resources/install_packages.sh"
install_missing_packages "$root/Resources/packages.txt"
install_missing_packages "$root/Testing/packages.txt"

cd "$root"
cmake --preset release
cmake --build --preset release
if [ ${#full[@]} -gt 0 ]; then
  exec python3 Testing/Verification/full_tier.py --program .build/release/bin/facetobone \
    --data "$FACETOBONE_DATA" --work .build/full "${full[@]:1}"
fi
bash Testing/Browser/test_report_page.sh .build/release/browser --install
ctest --preset release -j2
