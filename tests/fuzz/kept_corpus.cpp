// SPDX-License-Identifier: Apache-2.0
#include "fuzz/kept_corpus.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>

#include "support/byte_order.h"
#include "tests/support/source_dir.h"

namespace syncline::fuzz {
namespace {

constexpr std::size_t kLength = 4;

std::filesystem::path place_of(const std::string& target) {
  return std::filesystem::path(test::source_dir()) / "tests/fuzz/corpus" / target;
}

Bytes bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::vector<Bytes> kept_corpus(const std::string& target) {
  const auto bytes = bytes_of(place_of(target));
  std::vector<Bytes> inputs;
  for (std::span<const std::uint8_t> rest(bytes); !rest.empty();) {
    if (rest.size() < kLength) return {};
    const std::size_t length = load_le<std::uint32_t>(rest);
    rest = rest.subspan(kLength);
    if (rest.size() < length) return {};
    inputs.emplace_back(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(length));
    rest = rest.subspan(length);
  }
  return inputs;
}

bool keep_corpus(const std::string& target, const std::filesystem::path& folder) {
  std::vector<Bytes> inputs;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file()) inputs.push_back(bytes_of(entry.path()));
  }
  std::ranges::sort(inputs, [](const Bytes& a, const Bytes& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;  // the same file for the same folder
  });
  Bytes kept;
  for (const auto& input : inputs) {
    if (kept.size() + kLength + input.size() > kMostKept) break;
    ByteWriter(kept).u32(static_cast<std::uint32_t>(input.size())).bytes(input);
  }
  if (kept.empty()) return true;  // all of them are too large
  std::filesystem::create_directories(place_of(target).parent_path());
  std::ofstream out(place_of(target), std::ios::binary);
  out.write(reinterpret_cast<const char*>(kept.data()), static_cast<std::streamsize>(kept.size()));
  return out.good();
}

}  // namespace syncline::fuzz
