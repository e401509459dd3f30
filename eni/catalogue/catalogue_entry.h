// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/identity.h"

/// What a catalogue of ESI files answers with.
namespace syncline::eni {

/// A device that an ESI file describes.
struct CatalogueEntry {
  std::int64_t id = 0;  // of the index, until it is updated
  Identity identity;
  std::string vendor_name, type, name, group_type, group_name, physics;
  std::string revision_rule;  // Type@CheckRevisionNo, "" = none given
  bool hidden = false;        // Device@Invisible, or a newer device hides it (HideType)
  std::string file;
  int line = 0;
  int place = 0;              // of its Device element among all of the file
  std::uint64_t content = 0;  // equal where two files say the same; 0 unless its identity occurs twice
  bool operator==(const CatalogueEntry&) const = default;
};

struct CatalogueSearch {
  std::string words{};  // all of them, as beginnings of words; "" = everything
  std::optional<std::uint32_t> vendor_id{};
  std::optional<std::uint32_t> product_code{};
  std::string group_type{};    // exactly this group, "" = any
  bool all_revisions = false;  // otherwise the newest revision of each type
  bool with_hidden = false;
  std::size_t limit = 50;
};

/// The same identity more than once: harmless where the content is the same, else the first file wins.
struct DuplicateDevice {
  Identity identity;
  bool conflict = false;                  // the contents differ
  std::vector<CatalogueEntry> entries{};  // in the order in which they win
};

struct IndexProgress {
  std::size_t files_done = 0, files = 0;
  std::string file;  // read next
};
/// Called before each file that must be read. False cancels; what was read so far is kept.
using IndexCallback = std::function<bool(const IndexProgress&)>;

/// What bringing a folder's index up to date took.
struct IndexReport {
  std::size_t files = 0;    // ESI files in the folder
  std::size_t read = 0;     // new or with other content than before
  std::size_t touched = 0;  // another time stamp, the same content
  std::size_t removed = 0;  // gone since the last time
  bool cancelled = false;
  std::vector<std::string> unreadable{};  // folders below it that nobody may look into
};

}  // namespace syncline::eni
