#include "verdigris/exposure/mask_expression.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace verdigris {

namespace {

using Code = MaskExpression::Code;
constexpr std::size_t lanes = 512;  // slots at a time: the stack stays in the first cache

template <typename Operation>
void each(float* a, std::size_t count, Operation&& operation) {
  for (std::size_t k = 0; k < count; ++k) a[k] = operation(k);
}

float smooth(float low, float high, float x) {
  // Without a ramp it is a step.
  const float t = high != low ? std::clamp((x - low) / (high - low), 0.0f, 1.0f) : x < low ? 0.0f : 1.0f;
  return t * t * (3.0f - 2.0f * t);
}

// Applies an operation to the last values of the stack; returns how many there are then.
std::size_t apply(Code code, float* stack, std::size_t top, std::size_t count) {
  float* a = stack + (top - 1) * lanes;
  switch (code) {
    case Code::negate:
      each(a, count, [&](std::size_t k) { return -a[k]; });
      return top;
    case Code::absolute:
      each(a, count, [&](std::size_t k) { return std::abs(a[k]); });
      return top;
    case Code::root:
      each(a, count, [&](std::size_t k) { return std::sqrt(a[k]); });
      return top;
    case Code::exponential:
      each(a, count, [&](std::size_t k) { return std::exp(a[k]); });
      return top;
    case Code::logarithm:
      each(a, count, [&](std::size_t k) { return std::log(a[k]); });
      return top;
    case Code::sine:
      each(a, count, [&](std::size_t k) { return std::sin(a[k]); });
      return top;
    case Code::cosine:
      each(a, count, [&](std::size_t k) { return std::cos(a[k]); });
      return top;
    case Code::floor:
      each(a, count, [&](std::size_t k) { return std::floor(a[k]); });
      return top;
    default:
      break;
  }
  const float* c = a;
  a -= lanes;
  if (code == Code::clamp || code == Code::smoothstep || code == Code::mix) {
    const float* b = a;
    a -= lanes;
    if (code == Code::clamp)
      each(a, count, [&](std::size_t k) { return std::min(std::max(a[k], b[k]), c[k]); });
    else if (code == Code::smoothstep)
      each(a, count, [&](std::size_t k) { return smooth(a[k], b[k], c[k]); });
    else
      each(a, count, [&](std::size_t k) { return a[k] + c[k] * (b[k] - a[k]); });
    return top - 2;
  }
  switch (code) {
    case Code::add:
      each(a, count, [&](std::size_t k) { return a[k] + c[k]; });
      break;
    case Code::subtract:
      each(a, count, [&](std::size_t k) { return a[k] - c[k]; });
      break;
    case Code::multiply:
      each(a, count, [&](std::size_t k) { return a[k] * c[k]; });
      break;
    case Code::divide:
      each(a, count, [&](std::size_t k) { return a[k] / c[k]; });
      break;
    case Code::power:
      each(a, count, [&](std::size_t k) { return std::pow(a[k], c[k]); });
      break;
    case Code::least:
      each(a, count, [&](std::size_t k) { return std::min(a[k], c[k]); });
      break;
    case Code::greatest:
      each(a, count, [&](std::size_t k) { return std::max(a[k], c[k]); });
      break;
    default:  // step
      each(a, count, [&](std::size_t k) { return c[k] < a[k] ? 0.0f : 1.0f; });
      break;
  }
  return top - 1;
}

}  // namespace

Field<float> MaskExpression::evaluate(std::span<const Field<float>* const> masks, std::size_t slots) const {
  Field<float> field(slots);
  const std::size_t blocks = (slots + lanes - 1) / lanes;
  constexpr std::size_t blocks_a_task = 64;
  tbb::parallel_for(std::size_t{0}, (blocks + blocks_a_task - 1) / blocks_a_task, [&](std::size_t task) {
    std::vector<float> stack(deepest_ * lanes);
    const std::size_t last = std::min(slots, (task + 1) * blocks_a_task * lanes);
    for (std::size_t begin = task * blocks_a_task * lanes; begin < last; begin += lanes) {
      const std::size_t count = std::min(lanes, last - begin);
      std::size_t top = 0;
      for (const Step& step : steps_) {
        if (step.code == Code::number)
          std::fill_n(stack.data() + top++ * lanes, count, step.number);
        else if (step.code == Code::mask)
          std::copy_n(masks[step.mask]->data() + begin, count, stack.data() + top++ * lanes);
        else
          top = apply(step.code, stack.data(), top, count);
      }
      for (std::size_t k = 0; k < count; ++k) field[begin + k] = std::isfinite(stack[k]) ? stack[k] : 0.0f;
    }
  });
  return field;
}

}  // namespace verdigris
