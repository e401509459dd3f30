// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compile/compile.h"
#include "eni/format/eni_sections.h"
#include "findings/finding.h"

namespace syncline::ui {

/// The text of an ENI, with its lines and sections, which point into it.
struct EniLines {
  std::string text;
  std::vector<std::string_view> lines;
  std::vector<eni::EniSection> sections;

  [[nodiscard]] static std::shared_ptr<const EniLines> of(std::string text);
};

enum class EniRowKind : std::uint8_t {
  kSame,
  kAdded,
  kAltered,  // as it is now
  kBefore,   // the altered line below as it was
  kRemoved,
};

/// A line as it is shown: of the text, or for kBefore and kRemoved of the one before.
struct EniRow {
  std::uint32_t line = 0;
  EniRowKind kind = EniRowKind::kSame;
  [[nodiscard]] bool ghost() const { return kind == EniRowKind::kBefore || kind == EniRowKind::kRemoved; }
  bool operator==(const EniRow&) const = default;
};

/// Another value of a setting that was tried, to see which lines depend on it.
struct EniTrial {
  std::string key;     // "slave.3.alias"
  std::string value;   // the one that was tried, with its unit
  bool tried = false;  // false: no other value could be tried
};

/// An ENI and what became other in it since another one: both texts in one list of rows.
struct EniView {
  EniDialect dialect = EniDialect::kEcEngineer;
  std::shared_ptr<const EniLines> text;    // never null
  std::shared_ptr<const EniLines> before;  // null: nothing to compare with
  std::vector<EniRow> rows;
  std::vector<std::uint32_t> changes;  // first row of each stretch of changed ones
  std::size_t added = 0, removed = 0, altered = 0;
  std::size_t widest = 0;         // characters of the longest line
  std::vector<Finding> findings;  // of the compiler
  /// `before` is the ENI as it would be with that value; empty: as it was.
  std::optional<EniTrial> trial{};

  [[nodiscard]] static std::shared_ptr<EniView> of(std::shared_ptr<const EniLines> text,
                                                   std::shared_ptr<const EniLines> before);
  [[nodiscard]] std::string_view line(const EniRow& row) const {
    return (row.ghost() ? *before : *text).lines[row.line];
  }
  /// Row of a line of the text, from 0.
  [[nodiscard]] std::size_t row_of(std::size_t line) const;
  /// Line of the text that a row shows, or, for a ghost, the next one.
  [[nodiscard]] std::size_t line_at(std::size_t row) const;
};

}  // namespace syncline::ui
