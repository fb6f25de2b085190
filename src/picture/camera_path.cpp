#include "verdigris/picture/camera_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

constexpr double full = 2.0 * std::numbers::pi;

// A monotone cubic through values at times, two of them at least: Fritsch and Carlson 1980, with the harmonic
// means of Fritsch and Butland 1984 as slopes.
double between(const std::vector<double>& times, const std::vector<double>& values, double t) {
  const std::size_t n = times.size();
  if (n == 1 || t <= times.front()) return values.front();
  if (t >= times.back()) return values.back();
  const auto rise = [&](std::size_t k) { return (values[k + 1] - values[k]) / (times[k + 1] - times[k]); };
  // At rest at both ends of the way.
  const auto slope = [&](std::size_t k) {
    if (k == 0 || k + 1 == n) return 0.0;
    const double a = rise(k - 1), b = rise(k);
    return a * b > 0.0 ? 2.0 * a * b / (a + b) : 0.0;
  };
  const auto k =
      static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin()) - 1;
  const double h = times[k + 1] - times[k], s = (t - times[k]) / h, r = 1.0 - s;
  return (1.0 + 2.0 * s) * r * r * values[k] + s * r * r * h * slope(k) +
         s * s * (3.0 - 2.0 * s) * values[k + 1] - s * s * r * h * slope(k + 1);
}

}  // namespace

CameraPath::CameraPath(const Mesh& mesh, std::vector<CameraKey> keys, double turn,
                       const ViewSettings& settings)
    : turn_(turn * std::numbers::pi / 180.0), settings_(settings) {
  if (keys.empty()) throw InputError("camera", "there is no view", "give one");
  const Bounds bounds = mesh_bounds(mesh);
  middle_ = 0.5 * (bounds.lower + bounds.upper);
  for (const CameraKey& key : keys) {
    if (!times_.empty() && !(key.at > times_.back()))
      throw InputError(
          "camera", fmt::format("the view at {:g} does not come after that at {:g}", key.at, times_.back()),
          "let `at` ascend");
    if (!(key.zoom > 0.0) || !std::isfinite(key.zoom))
      throw InputError("camera", fmt::format("{:g} is no zoom", key.zoom), "give a positive number");
    // Axes of z up are turned into those of y up, and back in direction_of.
    const glm::dvec3 d = glm::normalize(key.direction);
    const glm::dvec3 v = settings.up == UpAxis::y ? d : glm::dvec3(d.x, d.z, -d.y);
    Pose pose{std::atan2(v.x, v.z), std::asin(std::clamp(v.y, -1.0, 1.0)), std::log(key.zoom),
              key.target.value_or(middle_)};
    if (!poses_.empty()) {
      const double back = std::remainder(pose.heading - poses_.back().heading, full);
      pose.heading = poses_.back().heading + back;
    }
    times_.push_back(key.at);
    poses_.push_back(pose);
  }
  radius_ = 0.5 * glm::distance(bounds.lower, bounds.upper);
  still_ = frame_mesh(mesh, keys[0].direction, settings);
  framed_ = !moves() && keys[0].zoom == 1.0 && !keys[0].target;
  if (framed_) return;
  // The farthest that any view on the way needs for the whole model around its middle.
  const double inner = 1.0 - 2.0 * std::clamp(settings.margin, 0.0, 0.45);
  const double ty = still_.tangent * inner, tx = ty * settings.width / settings.height;
  for (const glm::dvec3& direction : directions_on_the_way()) {
    const Camera camera = turned_to(direction);
    for (const glm::dvec3& position : mesh.positions) {
      const glm::dvec3 p = position - middle_;
      const double z = glm::dot(p, camera.backward());
      distance_ = std::max({distance_, z + std::abs(glm::dot(p, camera.right())) / tx,
                            z + std::abs(glm::dot(p, camera.up())) / ty});
    }
  }
}

// So many that nothing is missed between two of them.
std::vector<glm::dvec3> CameraPath::directions_on_the_way() const {
  constexpr int samples = 96;
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) times.push_back(static_cast<double>(i) / samples);
  for (std::size_t k = 1; k < times_.size(); ++k)
    for (int i = 0; i < samples; ++i)
      times.push_back(times_[k - 1] + (times_[k] - times_[k - 1]) * i / samples);
  // More than once round: at each height from all sides.
  const bool all_round = std::abs(turn_) > full;
  const std::size_t stride = !all_round ? 1 : times_.size() == 1 ? times.size() : 8;
  std::vector<glm::dvec3> directions;
  for (std::size_t k = 0; k < times.size(); k += stride)
    for (int i = 0; i < (all_round ? samples : 1); ++i) {
      Pose pose = pose_at(times[k]);
      pose.heading += full * i / samples;
      directions.push_back(direction_of(pose));
    }
  return directions;
}

CameraPath::Pose CameraPath::pose_at(double share) const {
  const auto value = [&](const auto& of) {
    std::vector<double> values;
    for (const Pose& pose : poses_) values.push_back(of(pose));
    return between(times_, values, share);
  };
  return {value([](const Pose& p) { return p.heading; }) + turn_ * share,
          value([](const Pose& p) { return p.elevation; }),
          value([](const Pose& p) { return p.nearness; }),
          {value([](const Pose& p) { return p.target.x; }), value([](const Pose& p) { return p.target.y; }),
           value([](const Pose& p) { return p.target.z; })}};
}

glm::dvec3 CameraPath::direction_of(const Pose& pose) const {
  // Straight from above there is no heading: a little beside it, it can still be seen to turn.
  const double most = 0.5 * std::numbers::pi - 1e-4;
  const double elevation = std::clamp(pose.elevation, -most, most);
  const glm::dvec3 v(std::cos(elevation) * std::sin(pose.heading), std::sin(elevation),
                     std::cos(elevation) * std::cos(pose.heading));
  return settings_.up == UpAxis::y ? v : glm::dvec3(v.x, -v.z, v.y);
}

Camera CameraPath::turned_to(glm::dvec3 direction) const {
  Camera camera(direction, settings_.up == UpAxis::y ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1));
  camera.width = still_.width;
  camera.height = still_.height;
  camera.tangent = still_.tangent;
  return camera;
}

Camera CameraPath::at(double share) const {
  if (framed_) return still_;
  const Pose pose = pose_at(std::clamp(share, 0.0, 1.0));
  Camera camera = turned_to(direction_of(pose));
  camera.eye = pose.target + distance_ * std::exp(-pose.nearness) * camera.backward();
  const double depth = glm::dot(camera.eye - middle_, camera.backward());
  camera.near = std::max(depth - 1.02 * radius_, 1e-3 * radius_);
  camera.far = std::max(depth + 1.02 * radius_, 2.0 * camera.near);
  return camera;
}

}  // namespace verdigris
