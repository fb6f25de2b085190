#include "verdigris/io/read_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <string_view>

#include "formats.hpp"
#include "text_cursor.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

using Reader = Mesh (*)(io::FileBytes, const std::filesystem::path&, ReadReport&);

struct Format {
  std::string_view extension;
  Reader read;
};

constexpr std::array formats{
    Format{".glb", io::read_gltf}, Format{".gltf", io::read_gltf}, Format{".obj", io::read_obj},
    Format{".off", io::read_off},  Format{".om", io::read_om},     Format{".ply", io::read_ply},
    Format{".stl", io::read_stl},
};

/// How files begin that are certainly not what a model's extension says.
struct Signature {
  std::string_view start, name, extension;
};

constexpr std::array signatures{
    Signature{"ply\n", "a PLY file", ".ply"},
    Signature{"ply\r", "a PLY file", ".ply"},
    Signature{"glTF", "a binary glTF file", ".glb"},
    Signature{"PK\x03\x04", "a ZIP archive", ""},
    Signature{"\x1f\x8b", "a gzip archive", ""},
    Signature{"\x89PNG", "a PNG picture", ""},
    Signature{"\xFF\xD8\xFF", "a JPEG picture", ""},
    Signature{"<!DOCTYPE", "a web page", ""},
    Signature{"<!doctype", "a web page", ""},
    Signature{"<html", "a web page", ""},
    Signature{"<HTML", "a web page", ""},
    Signature{"<?xml", "an XML file", ""},
    Signature{"Kaydara FBX", "an FBX file", ""},
    Signature{"BLENDER", "a Blender file", ""},
    Signature{"version https://git-lfs", "a Git LFS pointer", ""},
    Signature{"\xFF\xFE", "UTF-16 text", ""},
    Signature{"\xFE\xFF", "UTF-16 text", ""},
};

void check_signature(std::string_view bytes, std::string_view extension, const std::filesystem::path& file) {
  for (const Signature& s : signatures) {
    if (!bytes.starts_with(s.start) || s.extension == extension) continue;
    // A binary STL may begin with anything: its size decides.
    if (extension == ".stl" && s.name != "a web page") continue;
    throw InputError(io::shown(file), fmt::format("this is {}, not what its extension says", s.name),
                     s.extension.empty()
                         ? "unpack, download or export the model itself (as OBJ, OFF, PLY, STL, OM or glTF)"
                         : fmt::format("rename it to end in {}", s.extension));
  }
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& file, ReadReport* report) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const auto* const format =
      std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return f.extension == extension; });
  io::FileBytes bytes = io::read_file(file);  // first: "no such file" says more than "unknown extension"
  if (format == formats.end())
    throw InputError(io::shown(file),
                     fmt::format("the extension '{}' is not of a known model format", extension),
                     "export the model as .obj, .off, .ply, .stl, .om, .glb or .gltf");
  check_signature(bytes.view(), extension, file);

  ReadReport found;
  try {
    Mesh mesh = weld(format->read(std::move(bytes), file, found), &found.weld);
    if (mesh.triangles.empty())
      throw InputError(io::shown(file), "every face has two corners in one place: no triangle is left",
                       "check the export's scale and number of decimals");
    if (report) *report = std::move(found);
    return mesh;
  } catch (const std::bad_alloc&) {
    throw InputError(io::shown(file), "there is not enough memory to read it",
                     "simplify the model or free memory");
  }
}

}  // namespace verdigris
