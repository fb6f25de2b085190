#!/usr/bin/env bash
# Every benchmark, stage by stage, then the peers that are installed (Debian: golly, libcgal-dev, libeigen3-dev,
# libnoise-dev).
# Prints one table in Markdown, then what stands beside what as ratios; docs/performance.md keeps the last one. Close other
# programs first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/bench
cmake --preset release -B $build -DVERDIGRIS_TESTS=OFF -DVERDIGRIS_BENCH=ON > /dev/null
cmake --build $build > /dev/null

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

echo "# Measured on $(date +%F)"
echo
echo "$(nproc) x $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(g++ --version | head -n 1)"
echo
echo "| benchmark | ms | cells/s (triangles, ghosts) | bytes each | share of copy bandwidth | other |"
echo "|---|---|---|---|---|---|"

# One row for each line of Google Benchmark's JSON.
rows() {
  "$1" --benchmark_format=json "${@:2}" 2> /dev/null | awk '
    function value(line) { sub(/^[^:]*: */, "", line); sub(/,$/, "", line); gsub(/"/, "", line); return line }
    /"name": / { name = value($0) }
    /"label": / { name = name " " value($0) }
    /"real_time": / { ms = value($0) }
    /"(cells|triangles|ghosts)\/s": / { rate = sprintf("%.3g", value($0)) }
    /"B\/(cell|triangle|ghost)": / { bytes = sprintf("%.2f", value($0)) }
    /"of_copy": / { share = sprintf("%.2g", value($0)) }
    /"(mislabelled|factor_s|solves_s|vertices|Msamples\/s)": / {
      key = $1; gsub(/[":]/, "", key); other = other sprintf("%s %.3g ", key, value($0)) }
    /^ *}/ { if (name != "" && ms != "") printf "| %s | %.3g | %s | %s | %s | %s |\n", name, ms, rate, bytes, share, other
             name = ms = rate = bytes = share = other = "" }' | tee -a "$scratch/table"
}
for stage in read surface growth corrosion sweep life noise picture; do
  [ -x $build/bench/bench_$stage ] && rows $build/bench/bench_$stage
done
rows $build/bench/peers/bench_partition
rows $build/bench/peers/bench_peer_noise

if command -v bgolly > /dev/null; then
  for rule in B3/S23 B378/S235678 B357/S1358; do
    # A half-full soup of 4096 x 4096 as RLE, the same for every run.
    awk -v rule="$rule:T4096,4096" 'BEGIN {
      srand(1); print "x = 4096, y = 4096, rule = " rule
      for (y = 0; y < 4096; ++y) {
        line = ""
        for (x = 0; x < 4096; ++x) { line = line (rand() < 0.5 ? "o" : "b"); if (x % 64 == 63) line = line "\n" }
        printf "%s$\n", line
      } print "!" }' > "$scratch/soup.rle"
    seconds() { local t; t=$( { TIMEFORMAT=%U; time bgolly -a QuickLife -q -q -m "$1" -i 1 "$scratch/soup.rle" > /dev/null 2>&1; } 2>&1 ); echo "$t"; }
    none=$(seconds 0); hundred=$(seconds 100)
    awk -v a="$none" -v b="$hundred" -v rule="$rule" 'BEGIN {
      s = (b - a) / 100; printf "| bgolly QuickLife %s | %.3g | %.3g | | | 4096 x 4096 torus |\n", rule, 1000 * s, 16777216 / s }' |
      tee -a "$scratch/table"
  done
fi

echo
awk -f scripts/bench_ratios.awk "$scratch/table"
