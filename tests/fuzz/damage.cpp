// SPDX-License-Identifier: Apache-2.0
#include "fuzz/damage.h"

#include <array>
#include <string>

#include "fuzz/xml_damage.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"

namespace syncline::fuzz {
namespace {

constexpr std::size_t kLongestText = 256 * 1024;

struct Line {
  std::size_t from = 0, to = 0;  // with its line feed
};

Line some_line(std::string_view text, Random& random) {
  const auto at = pick(random, text.size());
  const auto before = text.rfind('\n', at == 0 ? 0 : at - 1);
  const auto after = text.find('\n', at);
  return {before == std::string_view::npos || at == 0 ? 0 : before + 1,
          after == std::string_view::npos ? text.size() : after + 1};
}

/// What stands behind a separator, up to the next one or the line's end.
Line some_value(std::string_view text, Random& random) {
  constexpr std::string_view kSeparators = "=,;[";
  const auto from = text.find_first_of(kSeparators, pick(random, text.size()));
  if (from == std::string_view::npos) return {};
  const auto to = text.find_first_of("\n,;]", from + 1);
  return {from + 1, to == std::string_view::npos ? text.size() : to};
}

void damage_line(std::string& text, Random& random) {
  const auto value = some_value(text, random);
  const auto line = some_line(text, random);
  const auto copy = text.substr(line.from, line.to - line.from);
  switch (random.next() % 8) {
    case 0:
    case 1:
    case 2:
      text.replace(value.from, value.to - value.from, nasty_value(random));
      break;
    case 3: {
      const auto other = some_value(text, random);
      text.replace(value.from, value.to - value.from, std::string(text, other.from, other.to - other.from));
      break;
    }
    case 4:
      text.erase(line.from, copy.size());
      break;
    case 5:
    case 6:
      text.insert(some_line(text, random).from, copy);
      break;
    default:
      if (!text.empty()) text[pick(random, text.size())] = static_cast<char>(random.next());
  }
}

struct Part {
  DatagramHeader header;
  Bytes data;
  std::uint16_t wkc = 0;
};

std::uint16_t nasty_word(Random& random) {
  static constexpr std::array<std::uint16_t, 12> kWords{0,      1,    2,      0xFFFF, 0xFFFE, 0x7FFF,
                                                        0x8000, 1001, 0x0010, 0x0502, 0x0508, 0x0900};
  return random.next() % 3 == 0 ? static_cast<std::uint16_t>(random.next()) : kWords[pick(random, kWords.size())];
}

void damage_part(Part& part, Random& random) {
  switch (random.next() % 6) {
    case 0:
      part.header.command = static_cast<Command>(random.next() % 16);
      break;
    case 1:
      part.header.address = device_address(nasty_word(random), part.header.ado());
      break;
    case 2:
      part.header.address = device_address(part.header.adp(), nasty_word(random));
      break;
    case 3:
      part.data.resize(random.next() % 20);
      break;
    case 4:
      if (!part.data.empty()) part.data[pick(random, part.data.size())] = static_cast<std::uint8_t>(random.next());
      break;
    default:
      part.wkc = nasty_word(random);
  }
}

std::vector<Part> parts_of(Bytes frame) {
  std::vector<Part> parts;
  FrameReader reader(frame, FrameReader::LengthField::kIgnored);
  while (const auto datagram = reader.next())
    parts.push_back({datagram->header, {datagram->data.begin(), datagram->data.end()}, datagram->wkc()});
  return parts;
}

Bytes frame_of(const std::vector<Part>& parts, const Bytes& like) {
  FrameBuilder builder;
  for (const auto& part : parts)
    (void)builder.add(part.header.command, part.header.index, part.header.address, part.data);
  const auto built = builder.finish();
  Bytes frame(built.begin(), built.end());
  for (std::size_t i = 6; i < 12 && i < like.size(); ++i) frame[i] = like[i];
  FrameReader reader(frame);
  for (const auto& part : parts) {
    if (auto datagram = reader.next()) datagram->set_wkc(part.wkc);
  }
  return frame;
}

}  // namespace

std::size_t pick(Random& random, std::size_t count) {
  return count == 0 ? 0 : static_cast<std::size_t>(random.next() % count);
}

std::string_view nasty_value(Random& random) {
  static constexpr std::array<std::string_view, 26> kValues{"",
                                                            "0",
                                                            "-1",
                                                            "1",
                                                            "65535",
                                                            "65536",
                                                            "4294967295",
                                                            "4294967296",
                                                            "#xffff",
                                                            "#x10000",
                                                            "#xffffffff",
                                                            "0x7fffffff",
                                                            "2147483648",
                                                            "-2147483648",
                                                            "9223372036854775807",
                                                            "-9223372036854775808",
                                                            "99999999999999999999",
                                                            "#x",
                                                            "ff",
                                                            "0f1",
                                                            "true",
                                                            "nonsense",
                                                            "&#0;",
                                                            "&#x1F600;",
                                                            "1e308",
                                                            "nan"};
  return kValues[pick(random, kValues.size())];
}

Bytes damage_bytes(const Bytes& good, Random& random) {
  auto bytes = good;
  for (auto changes = random.next() % 4 + 1; changes > 0 && !bytes.empty(); --changes) {
    auto& byte = bytes[pick(random, bytes.size())];
    byte = random.next() % 3 == 0 ? std::uint8_t{0xFF} : static_cast<std::uint8_t>(random.next());
  }
  if (random.next() % 3 == 0) bytes.resize(pick(random, bytes.size() + 1));
  if (random.next() % 5 == 0) bytes.insert(bytes.end(), good.begin(), good.end());
  return bytes;
}

Bytes damage_xml_bytes(const Bytes& good, Random& random) {
  if (random.next() % 8 == 0) return damage_bytes(good, random);
  const auto text = damage_xml({reinterpret_cast<const char*>(good.data()), good.size()}, random);
  return {text.begin(), text.end()};
}

Bytes damage_lines(const Bytes& good, Random& random) {
  if (random.next() % 8 == 0) return damage_bytes(good, random);
  std::string text(good.begin(), good.end());
  for (auto changes = random.next() % 4 + 1; changes > 0; --changes) damage_line(text, random);
  if (text.size() > kLongestText) text.resize(kLongestText);
  return {text.begin(), text.end()};
}

Bytes damage_frame(const Bytes& good, Random& random) {
  if (random.next() % 8 == 0) return damage_bytes(good, random);
  auto parts = parts_of(good);
  if (parts.empty()) return damage_bytes(good, random);
  for (auto changes = random.next() % 4 + 1; changes > 0 && !parts.empty(); --changes) {
    const auto place = pick(random, parts.size());
    switch (random.next() % 8) {
      case 0:
        parts.push_back(parts[place]);
        break;
      case 1:
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(place));
        break;
      default:
        damage_part(parts[place], random);
    }
  }
  return frame_of(parts, good);
}

Bytes damage_database(const Bytes& good, Random& random) {
  constexpr std::size_t kHeader = 100;
  auto bytes = good;
  if (bytes.size() <= kHeader || random.next() % 16 == 0) return damage_bytes(good, random);
  for (auto changes = random.next() % 12 + 1; changes > 0; --changes) {
    const auto from = random.next() % 32 == 0 ? std::size_t{16} : kHeader;
    auto& byte = bytes[from + pick(random, bytes.size() - from)];
    byte = random.next() % 2 == 0 ? static_cast<std::uint8_t>(byte + random.next() % 5 - 2)
                                  : static_cast<std::uint8_t>(random.next());
  }
  if (random.next() % 8 == 0) bytes.resize(pick(random, bytes.size()));
  return bytes;
}

}  // namespace syncline::fuzz
