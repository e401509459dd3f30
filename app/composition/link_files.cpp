// SPDX-License-Identifier: Apache-2.0
#include "app/composition/link_files.h"

#include "app/composition/link_text.h"
#include "app/composition/load_scenario.h"

namespace syncline {

std::vector<std::string> link_files(std::string_view text) {
  const auto link = parse_link_text(text);
  if (!link || link->kind == LinkKind::kAdapter) return {};
  std::vector<std::string> files{link->target};
  if (link->kind == LinkKind::kReplay) return files;
  if (auto config = load_network(link->target, link->network, link->seed)) {
    files.insert(files.end(), config->files.begin(), config->files.end());
  }
  return files;
}

}  // namespace syncline
