// SPDX-License-Identifier: Apache-2.0
#include "sim/scenario/scenario_table.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "support/whole_file.h"

namespace syncline::sim {

Result<toml::table> parse_toml(const std::string& path) {
  constexpr std::size_t kLargest = 16U << 20;
  const auto text = read_whole_file(path, kLargest);
  if (!text) return tl::unexpected(text.error());
  return parse_toml_text(*text, path);
}

Result<toml::table> parse_toml_text(std::string_view text, const std::string& path) {
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    return fail(Error{ErrorCode::kTomlMalformed,
                      {},
                      Reason::verbatim(std::string(error.description())),
                      path,
                      static_cast<int>(error.source().begin.line)});
  }
}

const toml::node* Table::ask(std::string_view key) {
  asked_.emplace(key);
  return table_.get(key);
}

std::string Table::text(std::string_view key, std::string fallback) {
  const auto* node = ask(key);
  if (node == nullptr) return fallback;
  if (auto value = node->value_exact<std::string>()) return *std::move(value);
  fail_at(key, "must be a text in quotation marks");
  return fallback;
}

bool Table::flag(std::string_view key, bool fallback) {
  const auto* node = ask(key);
  if (node == nullptr) return fallback;
  if (const auto value = node->value_exact<bool>()) return *value;
  fail_at(key, "must be true or false");
  return fallback;
}

std::int64_t Table::integer(std::string_view key, std::int64_t fallback, std::int64_t low, std::int64_t high) {
  const auto* node = ask(key);
  if (node == nullptr) return fallback;
  const auto value = node->value_exact<std::int64_t>();
  if (value && *value >= low && *value <= high) return *value;
  if (high < INT64_MAX) {
    fail_at(key, "must be a whole number from {low} to {high}", low, high);
  } else if (low > INT64_MIN) {
    fail_at(key, "must be a whole number from {low} on", low);
  } else {
    fail_at(key, "must be a whole number");
  }
  return fallback;
}

double Table::number(std::string_view key, double fallback, double low, double high) {
  const auto* node = ask(key);
  if (node == nullptr) return fallback;
  const auto value = node->value<double>();
  if (value && node->is_number() && *value >= low && *value <= high) return *value;  // false for what is no number, too
  fail_at(key, "must be a number from {low} to {high}", low, high);
  return fallback;
}

Nanoseconds Table::time_ms(std::string_view key, double fallback) {
  constexpr double kMostMs = 30 * 86'400'000.0;
  return static_cast<Nanoseconds>(std::llround(number(key, fallback, 0, kMostMs) * 1e6));
}

const toml::table* Table::table(std::string_view key) {
  const auto* node = ask(key);
  if (node != nullptr && !node->is_table()) fail_at(key, "must be written as [{key}]", key);
  return node == nullptr ? nullptr : node->as_table();
}

const toml::array* Table::tables(std::string_view key) {
  const auto* node = ask(key);
  if (node == nullptr) return nullptr;
  if (!node->is_array_of_tables()) {
    fail_at(key, "must be written as [[{key}]]", key);
    return nullptr;
  }
  return node->as_array();
}

const toml::array* Table::array(std::string_view key) {
  const auto* node = ask(key);
  if (node != nullptr && !node->is_array()) fail_at(key, "must be a list in brackets");
  return node == nullptr ? nullptr : node->as_array();
}

int Table::line_of(std::string_view key) const {
  const auto* node = table_.get(key);
  return node != nullptr ? static_cast<int>(node->source().begin.line) : line();
}

void Table::set_error(std::string_view key, Reason detail) {
  error_ = Error{ErrorCode::kScenarioKey, std::string(key), std::move(detail), file_, line_of(key)};
}

void Table::fail_with_file(std::string_view key, Error error) {
  if (error_) return;
  const bool unread = error.code == ErrorCode::kFileNotReadable || error.code == ErrorCode::kFileLimit;
  if (error.code == ErrorCode::kFileNotFound) {
    set_error(key, because("there is no file {file}", error.file));
  } else if (unread && error.line == 0) {
    set_error(key, because("the file {file} cannot be read: {reason}", error.file, std::move(error.detail)));
  } else if (error.file.empty()) {
    error.file = file_;
    error.line = line_of(key);
    error_ = std::move(error);
  } else {
    error_ = std::move(error);
  }
}

void Table::reject_unknown_keys(ReasonRow<0> where) {
  for (const auto& [key, node] : table_) {
    if (!asked_.contains(key.str())) fail_at(key.str(), "is not a key that {reason} has here", because(where));
  }
}

}  // namespace syncline::sim
