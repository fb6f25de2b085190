#!/usr/bin/env bash
# From a bare Debian 12 to pictures: installs what is missing, builds, partitions two models, films a third.
# scripts/demo.sh [DIRECTORY], by default out/ in the source tree.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=$(realpath -m "${1:-$root/out}")
cd "$root"

scripts/install.sh build demo
cmake --preset release -DVERDIGRIS_TESTS=OFF
cmake --build --preset release --target verdigris-cli

verdigris=build/release/apps/verdigris/verdigris
bunny=/usr/share/glmark2/models/bunny.obj
[[ -f $bunny ]] || { echo "There is no $bunny: install glmark2-data" >&2; exit 1; }

printf '\n'
"$verdigris" info "$bunny"
printf '\n'
"$verdigris" voronoi "$bunny" --seeds 64 --cells 1M --seed 7 --out "$out/bunny"
printf '\n'
"$verdigris" voronoi meshes/cup.obj --seeds 24 --cells 1M --seed 7 --out "$out/cup"
printf '\n'
"$verdigris" animate presets/copper-cup.toml --cells 300k --frames 72 --turn 60 --overlay --size 960x720 --out "$out/film"

cat <<END

Pictures:
  $out/bunny/picture.png
  $out/cup/picture.png
Film:
  $out/film/animation.mp4
Beside each picture:
  cells.vtp     all cells with label, arrival and area, for ParaView and VTK
  regions.csv   a row for each region: seed, cells, area, share
  curve.csv     cells filled in each step
  run.toml      every setting: $verdigris run $out/cup/run.toml --out again
Your own model, from this directory ($root):
  $verdigris voronoi MODEL.obj --out my-regions
END
