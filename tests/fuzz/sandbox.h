// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace syncline::fuzz {

/// A folder of its own for what a target reads and writes, in memory where there is such a place; gone at the end.
class Sandbox {
 public:
  Sandbox();
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  void put(const std::string& name, std::string_view content) const;
  [[nodiscard]] std::string text(const std::string& name) const;
  void clear() const;

 private:
  std::filesystem::path path_;
};

}  // namespace syncline::fuzz
