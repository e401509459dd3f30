// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tests/support/source_dir.h"

/// Files of other tools and vendors, kept outside the source tree: $SYNCLINE_SAMPLES, or ../shared/samples beside it.
namespace syncline::test {

inline std::optional<std::filesystem::path> sample_folder() {
  const char* chosen = std::getenv("SYNCLINE_SAMPLES");
  const std::filesystem::path folder =
      chosen ? std::filesystem::path(chosen) : std::filesystem::path(test::source_dir()) / "../shared/samples";
  return std::filesystem::is_directory(folder) ? std::optional(folder) : std::nullopt;
}

/// Small samples of our own: `kind` is a folder of tests/samples (eni, esi, pcap, schema, sii, spoilt_esi).
inline std::filesystem::path own_samples(const std::string& kind) {
  return std::filesystem::path(test::source_dir()) / "tests/samples" / kind;
}

/// Where samples lie: ours always, those of others when they are here.
struct SampleRoot {
  bool own = true;
  std::filesystem::path folder;
};
inline std::vector<SampleRoot> sample_roots() {
  std::vector<SampleRoot> roots{{true, own_samples("")}};
  if (const auto others = sample_folder()) roots.push_back({false, *others});
  return roots;
}
inline void PrintTo(const SampleRoot& root, std::ostream* out) { *out << root.folder; }
/// Of a test that runs once for each of sample_roots().
struct SampleRootName {
  template <class Info>
  std::string operator()(const Info& info) const {
    return info.param.own ? "Ours" : "OfOthers";
  }
};

/// `ours`, and `of_others` behind them where those samples are here.
template <class Case>
std::vector<Case> with_others(std::vector<Case> ours, const std::vector<Case>& of_others) {
  if (sample_folder()) ours.insert(ours.end(), of_others.begin(), of_others.end());
  return ours;
}

/// Path of a sample of ours, or of others, which must be here.
inline std::string sample_path(bool own, const std::string& relative) {
  return ((own ? own_samples("") : sample_folder().value()) / relative).string();
}

/// Samples of a kind with that extension, ours and those of others as far as they are here, in the order of their
/// names.
inline std::vector<std::filesystem::path> all_samples(const std::string& kind, const std::string& extension) {
  std::vector<std::filesystem::path> folders{own_samples(kind)}, files;
  if (const auto others = sample_folder()) folders.push_back(*others / kind);
  for (const auto& folder : folders) {
    std::vector<std::filesystem::path> found;
    std::error_code none;
    for (std::filesystem::directory_iterator it(folder, none), end; it != end; it.increment(none)) {
      if (it->path().extension() == extension) found.push_back(it->path());
    }
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

/// Path of a sample file, nothing when it is not there.
inline std::optional<std::string> sample_file(const std::string& relative) {
  const auto folder = sample_folder();
  if (!folder || !std::filesystem::exists(*folder / relative)) {
    return std::nullopt;
  }
  return (*folder / relative).string();
}

}  // namespace syncline::test

/// Declares `name` as the path of a sample, or skips the test.
#define SYNCLINE_SAMPLE(name, relative)                                 \
  const auto name##_found = ::syncline::test::sample_file(relative);    \
  if (!name##_found) GTEST_SKIP() << "sample not here: " << (relative); \
  const std::string name = *name##_found
