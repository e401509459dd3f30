// SPDX-License-Identifier: Apache-2.0
#include "settings/settings_doc.h"

#include <fmt/format.h>

#include "settings/settings_table.h"

namespace syncline::settings {

std::string settings_table_text() {
  std::string text =
      "| key | name | type | values | default | goes to | in the ENI | expert | meaning "
      "|\n|---|---|---|---|---|---|---|---|---|\n";
  for (const Setting& setting : table()) {
    const auto& words = setting.words;
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} | {} |\n", setting.key, words.label,
                        type_text(setting), range_text(setting), preset_text(setting), words.object, eni_text(words),
                        words.expert ? "yes" : "", words.help);
  }
  return text;
}

}  // namespace syncline::settings
