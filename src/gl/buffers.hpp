#pragma once
// The buffers of one chunk; filled once if it is kept, over and over if it is only passing through.

#include <cstddef>
#include <vector>

#include "objects.hpp"
#include "verdigris/picture/bands.hpp"
#include "verdigris/picture/layers.hpp"

namespace verdigris::gl {

// Strips and fans are taken apart before they are drawn: where patches hold few cells they are many and
// short, and Mesa's software renderer draws them one by one (bunny, 1M cells, 5.2M triangles: 2.6 s; 2.2 s as
// single triangles).
struct Buffers {
  VertexArray array;
  Buffer positions, normals, values, triangles;
  GLsizei index_count = 0;

  void upload(const BandMesh& bands, const std::vector<std::uint32_t>& indices, GLenum usage) {
    place(bands.positions, bands.normals, usage);
    fill(GL_ELEMENT_ARRAY_BUFFER, triangles, indices, usage);
    index_count = static_cast<GLsizei>(indices.size());
  }
  /// Other positions and normals for the triangles that are there.
  void place(const std::vector<glm::vec3>& at, const std::vector<PackedNormal>& facing, GLenum usage) {
    glBindVertexArray(array);
    fill(GL_ARRAY_BUFFER, positions, at, usage);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    fill(GL_ARRAY_BUFFER, normals, facing, usage);
    glVertexAttribPointer(1, 2, GL_SHORT, GL_TRUE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
  }

  void draw(const std::vector<Rgba8>& colours) const {
    glBindVertexArray(array);
    fill(GL_ARRAY_BUFFER, values, colours, GL_STREAM_DRAW);
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
    glEnableVertexAttribArray(2);
    glDisableVertexAttribArray(3);
    draw();
  }
  void draw(const std::vector<LayerCell>& cells) const {
    glBindVertexArray(array);
    fill(GL_ARRAY_BUFFER, values, cells, GL_STREAM_DRAW);
    constexpr GLsizei stride = sizeof(LayerCell);
    glVertexAttribPointer(2, 4, GL_UNSIGNED_SHORT, GL_TRUE, stride, nullptr);
    glVertexAttribPointer(3, 3, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                          reinterpret_cast<const void*>(offsetof(LayerCell, present)));
    glEnableVertexAttribArray(2);
    glEnableVertexAttribArray(3);
    draw();
  }

 private:
  template <class T>
  static void fill(GLenum target, GLuint buffer, const std::vector<T>& data, GLenum usage) {
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), usage);
  }
  void draw() const { glDrawElements(GL_TRIANGLES, index_count, GL_UNSIGNED_INT, nullptr); }
};

}  // namespace verdigris::gl
