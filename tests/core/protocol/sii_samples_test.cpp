// SPDX-License-Identifier: Apache-2.0
// Real EEPROM images, read from the samples folder where there is one.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "byte_helpers.h"
#include "protocol/sii.h"
#include "tests/support/source_dir.h"

namespace syncline::sii {
namespace {

namespace fs = std::filesystem;
using test::Bytes;

fs::path samples_folder() {
  const char* named = std::getenv("SYNCLINE_SAMPLES");
  return (named != nullptr ? fs::path(named) : fs::path(test::source_dir()) / ".." / "shared" / "samples") / "sii";
}

Bytes read_binary(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_hex_text(const Bytes& bytes) { return !bytes.empty() && bytes.front() == ':'; }

/// Value behind "key=" in the note column, nothing when it is not there.
std::optional<std::string> note_value(const std::string& note, const std::string& key) {
  const auto at = note.find(key + "=");
  if (at == std::string::npos) return std::nullopt;
  return note.substr(at + key.size() + 1, note.find(' ', at) - at - key.size() - 1);
}

struct Sample {
  std::string file;
  std::string note;
};

std::vector<Sample> read_index(const fs::path& folder) {
  std::vector<Sample> samples;
  std::ifstream in(folder / "INDEX.tsv");
  std::string line;
  std::getline(in, line);  // header
  while (std::getline(in, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    samples.push_back({line.substr(0, line.find('\t')), line.substr(line.rfind('\t') + 1)});
  }
  return samples;
}

/// Number of images that were compared.
std::size_t compare_all(const fs::path& folder) {
  std::size_t compared = 0;
  for (const auto& sample : read_index(folder)) {
    SCOPED_TRACE(sample.file);
    const auto bytes = read_binary(folder / sample.file);
    if (is_hex_text(bytes)) continue;  // Intel HEX, a copy of the .bin beside it
    const auto vendor = note_value(sample.note, "vendor");
    const auto image = decode(bytes);
    if (!vendor) continue;
    if (!image) {
      ADD_FAILURE() << image.error().detail.text();
      continue;
    }
    const auto number = [&sample](const char* key) {
      return static_cast<std::uint32_t>(std::stoul(note_value(sample.note, key).value_or("0"), nullptr, 0));
    };
    EXPECT_EQ(image->vendor_id, number("vendor"));
    EXPECT_EQ(image->product_code, number("product"));
    EXPECT_EQ(image->revision_no, number("rev"));
    EXPECT_EQ(image->checksum_ok, note_value(sample.note, "crc") == "ok");
    EXPECT_EQ(image->size_bytes, 128 * number("size_kbit"));
    // What was understood survives our own encoder.
    auto again = *image;
    again.checksum_ok = true;
    const auto second = decode(encode(again));
    if (!second) {
      ADD_FAILURE() << second.error().detail.text();
      continue;
    }
    again.size_bytes = second->size_bytes;  // may have grown
    EXPECT_EQ(*second, again);
    ++compared;
  }
  return compared;
}

TEST(SiiSamples, EveryImageDecodesToTheIdentityOfTheIndex) {
  EXPECT_GE(compare_all(fs::path(test::source_dir()) / "tests/samples/sii"), 6U);
  if (fs::exists(samples_folder() / "INDEX.tsv")) {
    EXPECT_GE(compare_all(samples_folder()), 20U);
  }
}

}  // namespace
}  // namespace syncline::sii
