#include "verdigris/picture/camera.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <numbers>
#include <string>

#include "verdigris/base/error.hpp"

namespace verdigris {

Camera::Camera(glm::dvec3 backward, glm::dvec3 up_hint) {
  backward_ = glm::normalize(backward);
  right_ = glm::normalize(glm::cross(up_hint, backward_));
  up_ = glm::cross(backward_, right_);
}

namespace {

// Clip = projection * axes * translation, in double.
glm::dmat4 clip_matrix(const Camera& camera, glm::dvec3 origin) {
  const glm::dvec3 r = camera.right(), u = camera.up(), b = camera.backward(), t = origin - camera.eye;
  const double aspect = static_cast<double>(camera.width) / camera.height;
  const double sx = 1.0 / (camera.tangent * aspect), sy = 1.0 / camera.tangent;
  const double depth = camera.far - camera.near;
  const double za = -(camera.far + camera.near) / depth, zb = -2.0 * camera.far * camera.near / depth;
  glm::dmat4 m(0.0);
  for (int k = 0; k < 3; ++k) m[k] = glm::dvec4(sx * r[k], sy * u[k], za * b[k], -b[k]);
  m[3] = glm::dvec4(sx * glm::dot(r, t), sy * glm::dot(u, t), za * glm::dot(b, t) + zb, -glm::dot(b, t));
  return m;
}

InputError bad_view(std::string_view view) {
  return {"view", "\"" + std::string(view) + "\" is neither a view nor a direction",
          "say front, back, left, right, top, bottom, iso, or three numbers x,y,z that are not all zero"};
}

glm::dvec3 parse_direction(std::string_view view) {
  glm::dvec3 d(0.0);
  const char* p = view.data();
  const char* const end = p + view.size();
  for (int k = 0; k < 3; ++k) {
    while (p != end && *p == ' ') ++p;
    const auto [next, error] = std::from_chars(p, end, d[k]);
    if (error != std::errc() || !std::isfinite(d[k])) throw bad_view(view);
    p = next;
    if (k < 2 && (p == end || *p++ != ',')) throw bad_view(view);
  }
  const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  if (p != end || largest == 0.0) throw bad_view(view);
  return glm::normalize(d / largest);
}

}  // namespace

glm::mat4 Camera::clip_from_model(glm::dvec3 origin) const {
  return glm::mat4(clip_matrix(*this, origin));
}

glm::dvec3 Camera::to_pixel(glm::dvec3 point) const {
  const glm::dvec4 clip = clip_matrix(*this, point) * glm::dvec4(0.0, 0.0, 0.0, 1.0);
  const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
  return {(ndc.x + 1.0) * 0.5 * width, (1.0 - ndc.y) * 0.5 * height, (ndc.z + 1.0) * 0.5};
}

glm::dvec3 view_direction(std::string_view view, UpAxis up) {
  const glm::dvec3 upward = up == UpAxis::y ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 front = up == UpAxis::y ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
  const glm::dvec3 right(1, 0, 0);
  if (view == "front") return front;
  if (view == "back") return -front;
  if (view == "right") return right;
  if (view == "left") return -right;
  if (view == "top") return upward;
  if (view == "bottom") return -upward;
  if (view == "iso") return glm::normalize(front + 0.85 * right + 0.7 * upward);
  return parse_direction(view);
}

Camera frame_mesh(const Mesh& mesh, glm::dvec3 direction, const ViewSettings& settings) {
  if (settings.width <= 0 || settings.height <= 0)
    throw InputError("picture size", "width and height must be positive", "give for example 1280 x 960");
  if (!(settings.field_of_view > 0.0 && settings.field_of_view < 180.0))
    throw InputError("field of view", "must lie between 0 and 180 degrees", "30 is a good choice");
  glm::dvec3 up = settings.up == UpAxis::y ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 backward = glm::normalize(direction);
  if (std::abs(glm::dot(backward, up)) >
      1.0 - 1e-9) {  // from above the front lies at the bottom of the picture
    up = view_direction("front", settings.up) * (glm::dot(backward, up) > 0.0 ? -1.0 : 1.0);
  }
  Camera camera(backward, up);
  camera.width = settings.width;
  camera.height = settings.height;
  const double half_angle = settings.field_of_view * std::numbers::pi / 360.0;
  const double longer = std::max(settings.width, settings.height);
  camera.tangent = std::tan(half_angle) * settings.height / longer;
  const double inner = 1.0 - 2.0 * std::clamp(settings.margin, 0.0, 0.45);
  const double ty = camera.tangent * inner, tx = ty * settings.width / settings.height;

  // In camera axes about c, an eye at (ox, oy, d) sees (x, y, z) inside the frame if |x - ox| <= (d - z) tx,
  // and so for y: four maxima over the vertices give the nearest eye exactly.
  const Bounds bounds = mesh_bounds(mesh);
  const glm::dvec3 c = 0.5 * (bounds.lower + bounds.upper);
  constexpr double low = -std::numeric_limits<double>::infinity();
  double right = low, left = low, top = low, bottom = low, front = low, back = low;
  for (const glm::dvec3& position : mesh.positions) {
    const glm::dvec3 p = position - c;
    const double x = glm::dot(p, camera.right()), y = glm::dot(p, camera.up()), z = glm::dot(p, backward);
    right = std::max(right, x + z * tx);
    left = std::max(left, z * tx - x);
    top = std::max(top, y + z * ty);
    bottom = std::max(bottom, z * ty - y);
    front = std::max(front, z);
    back = std::max(back, -z);
  }
  if (mesh.positions.empty()) right = left = top = bottom = front = back = 1.0;
  const double size = std::max(glm::distance(bounds.lower, bounds.upper), 1e-30);
  const double distance =
      std::max({(right + left) / (2.0 * tx), (top + bottom) / (2.0 * ty), front + 0.05 * size});
  // Along the axis that has room to spare near parts take more of it than far ones: the margins on both sides
  // of the picture are made equal by bisection, between the limits at which either is used up.
  const auto centred = [&](glm::dvec3 axis, double most, double least, double tangent) {
    double low_offset = most - distance * tangent, high_offset = distance * tangent - least;
    for (int step = 0; step < 24; ++step) {
      const double offset = 0.5 * (low_offset + high_offset);
      double above = low, below = low;
      for (const glm::dvec3& position : mesh.positions) {
        const glm::dvec3 p = position - c;
        const double x = glm::dot(p, axis) - offset, depth = distance - glm::dot(p, backward);
        above = std::max(above, x / depth);
        below = std::max(below, -x / depth);
      }
      (above > below ? low_offset : high_offset) = offset;
    }
    return 0.5 * (low_offset + high_offset);
  };
  camera.eye = c + centred(camera.right(), right, left, tx) * camera.right() +
               centred(camera.up(), top, bottom, ty) * camera.up() + distance * backward;
  camera.near = std::max((distance - front) * 0.98, 1e-4 * size);
  camera.far = (distance + back) * 1.01;
  return camera;
}

Camera frame_mesh(const Mesh& mesh, std::string_view view, const ViewSettings& settings) {
  return frame_mesh(mesh, view_direction(view, settings.up), settings);
}

}  // namespace verdigris
