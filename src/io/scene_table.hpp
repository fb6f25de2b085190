#pragma once
// Tables of a scene file, with errors that say where.

#include <fmt/format.h>

#include <toml++/toml.h>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>

#include "verdigris/base/error.hpp"
#include "verdigris/base/parameters.hpp"

namespace verdigris::io {

/// One table of a scene file, read key by key; what was not asked for is an error.
class Table {
 public:
  /// Table `key` of `parent`, which is `name` in messages. Without one it is false, and has no keys.
  Table(const std::filesystem::path& file, const toml::table& parent, std::string_view key,
        std::string name = "")
      : file_(file), name_(name.empty() ? std::string(key) : std::move(name)) {
    if (const toml::node* node = parent.get(key)) {
      table_ = node->as_table();
      if (table_ == nullptr)
        fail(*node, fmt::format("'{}' is not a table", name_), fmt::format("write [{}]", name_));
    }
  }

  /// A table that stands in a list, `name` in messages.
  Table(const std::filesystem::path& file, const toml::node& node, std::string name)
      : file_(file), name_(std::move(name)), table_(node.as_table()) {
    if (table_ == nullptr)
      fail(node, fmt::format("{} holds something that is no table", name_), "write { ... }");
  }

  explicit operator bool() const { return table_ != nullptr; }
  const toml::table& raw() const { return *table_; }

  const toml::node* find(const char* key) const { return table_ == nullptr ? nullptr : table_->get(key); }

  void text(const char* key, std::string& value) const {
    if (const toml::node* node = find(key)) {
      if (!node->is_string())
        fail(*node, fmt::format("{}.{} is not a string", name_, key), "put it in quotes");
      value = node->as_string()->get();
    }
  }
  void flag(const char* key, bool& value) const {
    if (const toml::node* node = find(key)) {
      if (!node->is_boolean())
        fail(*node, fmt::format("{}.{} is not true or false", name_, key), "write true or false");
      value = node->as_boolean()->get();
    }
  }
  void number(const char* key, double& value, double least, double greatest) const {
    if (const toml::node* node = find(key)) value = number_of(*node, key, least, greatest);
  }
  double number_of(const toml::node& node, std::string_view key, double least, double greatest) const {
    const auto value = node.value<double>();
    if (!value || node.is_boolean() || node.is_string() || !(*value >= least && *value <= greatest))
      fail(node, fmt::format("{}.{} is not a number from {} to {}", name_, key, least, greatest),
           "correct the value");
    return *value;
  }
  ParameterValue value_of(const toml::node& node, std::string_view key) const {
    if (node.is_string()) return node.as_string()->get();
    return number_of(node, key, -std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::infinity());
  }
  template <typename Integer>
  void whole(const char* key, Integer& value, std::int64_t least, std::int64_t greatest) const {
    if (const toml::node* node = find(key))
      value = static_cast<Integer>(whole_of(*node, key, least, greatest));
  }
  std::int64_t whole_of(const toml::node& node, std::string_view key, std::int64_t least,
                        std::int64_t greatest) const {
    if (!node.is_integer() || node.as_integer()->get() < least || node.as_integer()->get() > greatest)
      fail(node, fmt::format("{}.{} is not a whole number from {} to {}", name_, key, least, greatest),
           "correct the value");
    return node.as_integer()->get();
  }
  const toml::array* array(const char* key) const {
    const toml::node* node = find(key);
    if (node == nullptr) return nullptr;
    if (!node->is_array()) fail(*node, fmt::format("{}.{} is not an array", name_, key), "write [ ... ]");
    return node->as_array();
  }

  void only(std::initializer_list<std::string_view> keys) const {
    if (table_ == nullptr) return;
    for (const auto& [key, node] : *table_) {
      std::string known;
      bool found = false;
      for (const std::string_view k : keys) {
        found = found || k == key.str();
        if (!known.empty()) known += ", ";
        known += k;
      }
      if (!found) fail(node, fmt::format("[{}] has no key '{}'", name_, key.str()), "the keys are: " + known);
    }
  }

  [[noreturn]] void fail(const toml::node& node, const std::string& what, const std::string& remedy) const {
    throw InputError(fmt::format("{}:{}", file_.string(), node.source().begin.line), what, remedy);
  }

 private:
  const std::filesystem::path& file_;
  std::string name_;
  const toml::table* table_ = nullptr;
};

}  // namespace verdigris::io
