# Ratios between rows of the table of bench.sh: how many times as fast the first is as the second, by cells a second where both
# have them, else by time. Rows that are missing give no ratio.

BEGIN { FS = " *[|] *" }
{
  name = $2
  sub(/\/(min_time|iterations):.*/, "", name)
  ms[name] = $3
  rate[name] = $4
}
function ratio(what, a, b, by_time) {
  if (!ms[a] || !ms[b]) return
  printf "| %s | %.3g |\n", what, !by_time && rate[a] && rate[b] ? rate[a] / rate[b] : ms[b] / ms[a]
}
END {
  print "| how many times as fast | ratio |"
  print "|---|---|"
  split("Life Coagulations Amoeba", rule, " ")
  split("B3/S23 B378/S235678 B357/S1358", notation, " ")
  split("62 448 2048", side, " ")
  split("961 50,176 1,048,576", cells, " ")
  for (r = 1; r <= 3; ++r)
    for (k = 1; k <= 3; ++k)
      ratio(rule[r] ", torus, " cells[k] " cells a patch: as bgolly", "torus/" side[k] "/" r - 1 "/1 " rule[r],
            "bgolly QuickLife " notation[r])
  for (k = 1; k <= 3; ++k)
    ratio("Life, torus, " cells[k] " cells a patch: as the plain bit-sliced step", "torus/" side[k] "/0/1 Life",
          "flat Life, no surface")
  for (patch = 1000; patch <= 50000; patch *= 50) {
    ratio("Voronoi, 1M cells, " patch " a patch: as Dijkstra on 1M vertices", "growth/1000000/" patch, "dijkstra/316", 1)
    ratio("the same: as the heat method on 1M vertices", "growth/1000000/" patch, "heat_method/316", 1)
  }
  ratio("Voronoi growth, a cell of 1M: as one of 30M", "grow/1000000/1000/1", "grow/30000000/1000/1")
  ratio("10M cells, 1000 a patch, building them: as growth over them", "build/10000000/1000", "grow/10000000/1000/1", 1)
  ratio("10M cells, 1000 a patch, growth on two threads: as on one", "grow/10000000/1000/2", "grow/10000000/1000/1")
  ratio("the same, full sweep of a byte a cell", "life_bytes/10000000/1000/2", "life_bytes/10000000/1000/1")
  ratio("the same, packed Life", "sphere/10000000/1000/2 Life", "sphere/10000000/1000/1 Life")
  ratio("fBm, 6 octaves: as libnoise", "fbm", "libnoise_fbm", 1)
  ratio("ridged, 6 octaves: as libnoise", "ridged", "libnoise_ridged", 1)
}
