#!/usr/bin/env bash
# All tests, from a bare Debian 12: an optimised build with every warning an error, then one with assertions and
# sanitizers, then both against each other. Builds under build/; a second run only rebuilds what changed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec < /dev/null
export CTEST_OUTPUT_ON_FAILURE=1
jobs=$(nproc)
SECONDS=0
title() { printf '\n== %s (%d:%02d)\n' "$1" $((SECONDS / 60)) $((SECONDS % 60)); }

title "packages"
scripts/install.sh build test

release=build/test-release
title "release, warnings are errors"
cmake --preset release -B $release -DVERDIGRIS_TESTS=ON -DVERDIGRIS_BENCH=ON -DVERDIGRIS_WERROR=ON
cmake --build $release
title "all tests"
ctest --test-dir $release -j "$jobs"

# Debug in all that matters here, assertions and another optimiser; -O0 would only make the wait longer.
sanitized=build/test-asan
title "debug with AddressSanitizer and UndefinedBehaviorSanitizer"
cmake --preset asan -B $sanitized -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" -DVERDIGRIS_TESTS=ON
cmake --build $sanitized
title "tests, without the long ones"
ctest --test-dir $sanitized -j "$jobs" -LE long

title "the same bits: release and debug, 1 and 2 threads"
first=
for build in $release $sanitized; do
  for threads in 1 2; do
    out=$build/same-bits-$threads
    "$build"/apps/verdigris/verdigris voronoi /usr/share/glmark2/models/bunny.obj --cells 300k --seeds 64 --seed 7 \
      --threads $threads --no-picture --quiet --out "$out"
    first=${first:-$out}
    for file in cells.vtp regions.csv curve.csv; do cmp "$first/$file" "$out/$file"; done
    echo "$out/cells.vtp $(md5sum < "$out/cells.vtp")"
  done
done
title "passed"
