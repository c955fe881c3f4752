#!/usr/bin/env bash
# What other programs say to the manual pages: man-db sets each one without a warning, and mandoc finds nothing that is
# worse than a matter of style.   man_pages_test.sh FOLDER
set -uo pipefail
failures=0
export MANWIDTH=80 LC_ALL=C.UTF-8
[ "$(find "$1" -name '*.[15]' | wc -l)" -gt 15 ] || { echo "FAILED: few pages in $1"; failures=1; }
for page in "$1"/*; do
  said=$(man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null)
  [ -z "$said" ] || { echo "FAILED: man says of $page: $said"; failures=$((failures + 1)); }
  command -v mandoc >/dev/null || continue
  # There is no date on a page, since a page made again must be the same.
  said=$(mandoc -T lint -W warning "$page" | grep -v 'missing date')
  [ -z "$said" ] || { echo "FAILED: mandoc says: $said"; failures=$((failures + 1)); }
done
[ "$failures" -eq 0 ] && echo "all as expected"
exit $((failures > 0))
