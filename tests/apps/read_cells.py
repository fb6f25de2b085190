"""Reads cells.vtp with VTK's own reader: read_cells.py PROGRAM DIRECTORY. Leaves with 77 where there is no VTK."""
import json
import os
import subprocess
import sys

try:
    from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_INT
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError as missing:
    print("skipped: python3-vtk9 is not installed:", missing)
    sys.exit(77)

program, directory = sys.argv[1:]
os.makedirs(directory, exist_ok=True)
model = os.path.join(directory, "octahedron.obj")
with open(model, "w") as f:
    f.write("v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
            "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n")
surface_area = 8 * 3 ** 0.5 / 2

out = os.path.join(directory, "out")
run = subprocess.run([program, "voronoi", model, "--cells", "100k", "--seeds", "12", "--no-picture", "--json", "--out", out],
                     stdout=subprocess.PIPE, check=True)
report = json.loads(run.stdout)

reader = vtkXMLPolyDataReader()
reader.SetFileName(os.path.join(out, "cells.vtp"))
reader.Update()
cells = reader.GetOutput()
data = cells.GetPointData()
n = report["cells"]
assert cells.GetNumberOfPoints() == cells.GetNumberOfVerts() == n, (cells.GetNumberOfPoints(), n)
names = {data.GetArrayName(k) for k in range(data.GetNumberOfArrays())}
assert names == {"label", "arrival", "patch", "area"}, names
for name, kind, least, greatest in (("label", VTK_INT, 0, 11), ("patch", VTK_INT, 0, 7), ("arrival", VTK_INT, 0, report["steps"])):
    array = data.GetArray(name)
    assert array.GetDataType() == kind and array.GetNumberOfTuples() == n, name
    assert array.GetRange() == (least, greatest), (name, array.GetRange())
area = data.GetArray("area")
assert area.GetDataType() == VTK_DOUBLE
total = sum(area.GetValue(k) for k in range(n))
assert abs(total / surface_area - 1) < 0.005, (total, surface_area)
for k in range(0, n, 997):  # on the octahedron |x| + |y| + |z| = 1
    assert abs(sum(map(abs, cells.GetPoint(k))) - 1) < 1e-12, cells.GetPoint(k)
print(n, "cells, area", total)
