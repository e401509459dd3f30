// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/content_hash.h"

#include <bit>
#include <cstring>

#include "eni/xml/xml_text.h"

namespace syncline::eni {
namespace {

// Odd constants with their bits spread evenly (fractions of square roots), as multiplicative hashing wants them.
constexpr std::uint64_t kMix = 0x9E3779B97F4A7C15, kSeed = 0x6A09E667F3BCC909;

std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * kMix;
  return hash ^ (hash >> 29);
}

std::uint64_t add(std::uint64_t hash, std::string_view bytes) {
  hash = mix(hash, bytes.size());
  while (bytes.size() >= sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), sizeof word);
    hash = mix(hash, word);
    bytes.remove_prefix(sizeof word);
  }
  std::uint64_t rest = 0;
  std::memcpy(&rest, bytes.data(), bytes.size());
  return mix(hash, rest);
}

std::uint64_t add(std::uint64_t hash, const tinyxml2::XMLElement& element) {
  hash = add(hash, element.Name());
  for (const auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
    hash = add(add(hash, attribute->Name()), attribute->Value());
  }
  for (const auto* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (const auto* child = node->ToElement()) {
      hash = add(hash, *child);
    } else if (const auto* text = node->ToText()) {
      hash = add(hash, trim(text->Value()));
    }
  }
  return mix(hash, kSeed);  // the end: <a><b/></a><c/> is not <a><b/><c/></a>
}

std::uint64_t finish(std::uint64_t hash) { return mix(mix(hash, kSeed), std::rotl(hash, 32)); }

}  // namespace

std::uint64_t content_hash(std::string_view bytes) { return finish(add(kSeed, bytes)); }

std::uint64_t content_hash(const tinyxml2::XMLElement& element) { return finish(add(kSeed, element)); }

}  // namespace syncline::eni
