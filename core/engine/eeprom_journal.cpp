// SPDX-License-Identifier: Apache-2.0
#include "engine/eeprom_journal.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <ctime>
#include <filesystem>
#include <string_view>

#include "support/paths_in.h"
#include "support/state_folder.h"
#include "support/whole_file.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTitle = "syncline eeprom journal 1";
constexpr std::string_view kExtension = ".journal";

/// FNV-1a: one file a slave, whatever characters its link has.
std::string file_of(const std::string& link, std::uint16_t position) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const char c : link + fmt::format("#{}", position)) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3;
  return (fs::path(eeprom_journal_folder()) / fmt::format("{:016x}{}", hash, kExtension)).string();
}

std::string hex_of(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const auto byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

std::optional<std::vector<std::uint8_t>> bytes_from(std::string_view text) {
  if (text.size() % 2 != 0) return std::nullopt;
  std::vector<std::uint8_t> bytes(text.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const char* digits = text.data() + 2 * i;
    const auto [end, error] = std::from_chars(digits, digits + 2, bytes[i], 16);
    if (error != std::errc{} || end != digits + 2) return std::nullopt;
  }
  return bytes;
}

/// The rest of the line that begins with `key` and a blank.
std::string_view value_of(std::string_view text, std::string_view key) {
  while (!text.empty()) {
    const auto line = text.substr(0, text.find('\n'));
    if (line.starts_with(key) && line.size() > key.size() && line[key.size()] == ' ')
      return line.substr(key.size() + 1);
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return {};
}

std::optional<EepromJournal> read_journal(const std::string& file) {
  constexpr std::size_t kLargest = 1U << 20;
  const auto text = read_whole_file(file, kLargest);
  if (!text || !text->starts_with(kTitle)) return std::nullopt;
  EepromJournal journal;
  journal.link = value_of(*text, "link");
  journal.begun = value_of(*text, "begun");
  const auto position = value_of(*text, "position");
  const auto before = bytes_from(value_of(*text, "before")), after = bytes_from(value_of(*text, "after"));
  const auto [end, error] = std::from_chars(position.data(), position.data() + position.size(), journal.position);
  if (error != std::errc{} || !before || !after || before->empty() || before->size() != after->size())
    return std::nullopt;
  journal.before = *before;
  journal.after = *after;
  return journal;
}

}  // namespace

std::string eeprom_journal_folder() { return state_folder("eeprom"); }

Status keep_journal(const EepromJournal& journal) {
  std::error_code error;
  fs::create_directories(eeprom_journal_folder(), error);
  auto file = journal;
  if (file.begun.empty()) file.begun = fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::gmtime(std::time(nullptr)));
  return write_whole_file(file_of(file.link, file.position),
                          fmt::format("{}\nlink {}\nposition {}\nbegun {}\nbefore {}\nafter {}\n", kTitle, file.link,
                                      file.position, file.begun, hex_of(file.before), hex_of(file.after)));
}

void drop_journal(const std::string& link, std::uint16_t position) {
  std::error_code ignored;
  fs::remove(file_of(link, position), ignored);
}

std::optional<EepromJournal> find_journal(const std::string& link, std::uint16_t position) {
  return read_journal(file_of(link, position));
}

std::vector<EepromJournal> pending_journals() {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& path : paths_in(eeprom_journal_folder(), error)) {
    if (path.extension() == kExtension) files.push_back(path.string());
  }
  std::ranges::sort(files);
  std::vector<EepromJournal> journals;
  for (const auto& file : files) {
    if (auto journal = read_journal(file)) journals.push_back(std::move(*journal));
  }
  return journals;
}

}  // namespace syncline
