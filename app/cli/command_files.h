// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/distinct_files.h"

namespace syncline::cli {

/// The files of one call of a command, each with the option or the argument that names it. Every command that writes
/// asks check() before it opens the first file for writing, so that no file that it reads is lost. What is "" is none.
class CommandFiles {
 public:
  CommandFiles& reads(std::string_view option, const std::string& path);
  /// With the log that belongs to it when it was cut short.
  CommandFiles& reads_recording(std::string_view option, const std::string& path);
  /// A LINK: its scenario with what that names, or its capture.
  CommandFiles& reads_link(std::string_view option, const std::string& link);
  /// The ESI files of a folder and of those below it.
  CommandFiles& reads_esi(std::string_view option, const std::string& folder);
  CommandFiles& writes(std::string_view option, const std::string& path);
  /// A recording or a catalogue of ESI files, with what SQLite keeps beside it meanwhile.
  CommandFiles& writes_database(std::string_view option, const std::string& path);

  /// kBadValue with both options and what to do, see check_distinct().
  [[nodiscard]] Status check() const;

 private:
  std::vector<NamedFile> read_, links_, folders_, written_;
};

}  // namespace syncline::cli
