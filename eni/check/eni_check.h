// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "findings/finding.h"
#include "findings/finding_list.h"
#include "support/result.h"

namespace syncline::eni {

struct EniCheck {
  /// By line; their places have slave, line and path. Where there are more than a FindingList takes, the last one says
  /// how many.
  std::vector<Finding> findings;
  SeverityCounts not_listed;
  /// False when a value or the XML itself kept the file from being read: only its structure was checked then.
  bool understood = true;
  std::vector<std::string> slaves;  // names, as far as the file was understood
  /// "" where the finding is about none, or the file was not understood.
  [[nodiscard]] std::string slave_name(const Finding& finding) const;
  /// Of what was found, whether it is listed or not.
  [[nodiscard]] std::size_t count(Severity severity) const;
};

/// Checks structure and meaning by the rules of check_rules(). An error only where there is no ENI to check:
/// kFileNotFound, kFileNotReadable, kNotThatKindOfFile, and whatever limit the reader sets to its input. Broken XML is
/// a finding.
[[nodiscard]] Result<EniCheck> check_eni(const std::string& path);
[[nodiscard]] Result<EniCheck> check_eni_text(std::string_view text, const std::string& file_name);

/// The findings about an ENI that our writer made of a project, with the settings of the project that cure them.
[[nodiscard]] std::vector<Finding> findings_of_export(const EniCheck& check);
/// What another master would refuse in it: the errors among them.
[[nodiscard]] std::vector<Finding> errors_of_export(const EniCheck& check);
[[nodiscard]] std::vector<Finding> errors_of_export(std::string_view text);

}  // namespace syncline::eni
