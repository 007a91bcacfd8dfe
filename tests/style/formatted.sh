#!/usr/bin/env bash
# Usage: formatted.sh CLANG_FORMAT, at the root of the sources. Generated tables of coefficients are as their writer left them.
set -euo pipefail

find contact friction grasp dynamics cli verification tests bench \( -name '*.h' -o -name '*.cc' \) ! -name '*_coefficients.h' -print0 |
  xargs -0 "$1" --dry-run --Werror
