// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "check/check_rule.h"
#include "support/result.h"

namespace syncline::eni {

/// A finding in an ENI file. Why it matters and how to mend it stand in the rule (find_check_rule()).
struct EniFinding {
  std::string_view code;
  CheckSeverity severity = CheckSeverity::kNote;
  int line = 0;      // in the file, from 1; 0 = the file as a whole
  std::string path;  // "/EtherCATConfig/Config/Slave[2]/InitCmds/InitCmd[5]"
  int slave = -1;    // position, -1 = none
  std::string slave_name;
  std::string what;  // the facts, in words
  bool operator==(const EniFinding&) const = default;
};

struct EniCheck {
  std::vector<EniFinding> findings;  // by line
  /// False when a value or the XML itself kept the file from being read: only its structure was checked then.
  bool understood = true;
  std::size_t slaves = 0;
};

/// Checks structure and meaning by the rules of check_rules(). An error only where there is no ENI to check:
/// kFileNotFound, kFileNotReadable, kNotThatKindOfFile, and whatever limit the reader sets to its input. Broken XML is
/// a finding.
[[nodiscard]] Result<EniCheck> check_eni(const std::string& path);
[[nodiscard]] Result<EniCheck> check_eni_text(std::string_view text, const std::string& file_name);

}  // namespace syncline::eni
