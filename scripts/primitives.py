#!/usr/bin/env python3
"""Draws docs/primitives.png, a sheet of every primitive of the catalogue and its variants, and docs/primitives.md,
their parameters, from what the program says of itself.

    scripts/primitives.py PROGRAM [--check]

PROGRAM is the verdigris to ask; --check only looks whether docs/primitives.md is up to date. Pictures need PIL
(Debian: python3-pil, fonts-dejavu-core).
"""

import json
import pathlib
import subprocess
import sys
import tempfile

DOCS = pathlib.Path(__file__).resolve().parent.parent / "docs"

# What is shown of each primitive beside its defaults: (options, caption).
VARIANTS = {
    "cellular": [(["--distance", "F2"], "distance F2"), (["--distance", "F2-F1"], "distance F2-F1"),
                 (["--metric", "manhattan"], "metric manhattan"), (["--metric", "chebyshev"], "metric chebyshev")],
    "fbm": [(["--h", "0.3"], "h 0.3"), (["--h", "0.6"], "h 0.6"), (["--basis", "value"], "basis value"),
            (["--lacunarity", "4", "--octaves", "4"], "lacunarity 4, octaves 4")],
    "ridged": [(["--gain", "0"], "gain 0"), (["--h", "0.8"], "h 0.8")],
    "multifractal": [(["--offset", "2"], "offset 2")],
    "hybrid": [(["--h", "0.6", "--offset", "0.4"], "h 0.6, offset 0.4")],
    "warp": [(["--strength", "1"], "strength 1")],
    "midpoint": [(["--h", "0.5"], "h 0.5")],
    "diamond-square": [(["--h", "0.5"], "h 0.5")],
    "sierpinski-tetrahedron": [(["--section", "0.2"], "section 0.2")],
    "menger-sponge": [(["--section", "0.5"], "section 0.5")],
    "mandelbrot": [(["--centre_x", "-0.7436", "--centre_y", "0.1318", "--extent", "0.006"],
                    "extent 0.006 at -0.744, 0.132")],
    "julia": [(["--c_x", "-0.4", "--c_y", "0.6"], "c -0.4 + 0.6 i")],
    "lsystem": [(["--preset", name], f"preset {name}") for name in ("hilbert", "dragon", "cracks")],
}

COLUMNS, TILE, GAP, CAPTION = 6, 192, 16, 40
PAPER, INK, FAINT = (250, 248, 243), (38, 50, 47), (110, 122, 116)


def ask(program, *arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def number(value):
    return f"{value:.10g}" if isinstance(value, (int, float)) else value


def markdown(primitives):
    lines = ["# Primitives of synthesis", "",
             "Made by `scripts/primitives.py` from what the program says of itself (`verdigris synth --list`).", "",
             "![Every primitive, seed 1, each with the parameters that differ from the defaults](primitives.png)", "",
             "Each is a command (`verdigris synth NAME --size 1024 --out h.png`), a source of masks in scene files and "
             "an entry of `builtin_primitives()`.", ""]
    for p in primitives:
        lines += [f"## {p['name']}", "", p["summary"][0].upper() + p["summary"][1:] +
                  f". Reads up to {p['dimension']} coordinate{'s' if p['dimension'] > 1 else ''}.", "",
                  "| parameter | default | allowed | unit | |", "|---|---|---|---|---|"]
        for q in p["parameters"]:
            if "choices" in q:
                allowed, unit = ", ".join(q["choices"]) or "text", ""
            else:
                allowed = f"{number(q['least'])} .. {number(q['greatest'])}" + (", whole" if q["integer"] else "")
                unit = "" if q["unit"] == "1" else q["unit"]
            default = str(number(q["default"])).replace("\n", "<br>").replace("|", "\\|")
            lines.append(f"| {q['name']} | {default} | {allowed} | {unit} | {q['help']} |")
        lines.append("")
    return "\n".join(lines)


def sheet(program, primitives):
    from PIL import Image, ImageDraw, ImageFont

    fonts = "/usr/share/fonts/truetype/dejavu/"
    title, name_font, small = (ImageFont.truetype(fonts + f, s) for f, s in
                               (("DejaVuSans-Bold.ttf", 26), ("DejaVuSans-Bold.ttf", 15), ("DejaVuSans.ttf", 12)))
    tiles = []
    for p in primitives:
        for options, caption in [([], "defaults")] + VARIANTS.get(p["name"], []):
            tiles.append((p["name"], options, caption))
    rows = -(-len(tiles) // COLUMNS)
    top = 76
    page = Image.new("RGB", (GAP + COLUMNS * (TILE + GAP), top + rows * (TILE + CAPTION + GAP)), PAPER)
    draw = ImageDraw.Draw(page)
    draw.text((GAP, 18), "verdigris synth", font=title, fill=INK)
    draw.text((GAP, 50), "every primitive with its defaults, and some of what its parameters do; seed 1", font=small,
              fill=FAINT)
    with tempfile.TemporaryDirectory() as folder:
        for k, (name, options, caption) in enumerate(tiles):
            file = pathlib.Path(folder) / "tile.png"
            # Drawn at twice the size: detail is averaged, as it would be from farther away.
            ask(program, "synth", name, *options, "--size", str(2 * TILE), "--shaded", "--out", str(file), "--quiet")
            x, y = GAP + k % COLUMNS * (TILE + GAP), top + k // COLUMNS * (TILE + CAPTION + GAP)
            page.paste(Image.open(file).convert("RGB").resize((TILE, TILE), Image.LANCZOS), (x, y))
            draw.text((x, y + TILE + 4), name, font=name_font, fill=INK)
            draw.text((x, y + TILE + 23), caption, font=small, fill=FAINT)
    # 256 colours keep it under a megabyte.
    page.quantize(256, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(
        DOCS / "primitives.png", optimize=True)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = sys.argv[1]
    primitives = json.loads(ask(program, "list", "--json"))["primitives"]
    text = markdown(primitives)
    file = DOCS / "primitives.md"
    if "--check" in sys.argv:
        sys.exit(0 if file.read_text() == text else "docs/primitives.md is not what the program says of itself")
    file.write_text(text)
    sheet(program, primitives)


if __name__ == "__main__":
    main()
