// SPDX-License-Identifier: Apache-2.0
#include "app/composition/link_files.h"

#include "app/composition/link_text.h"
#include "app/composition/load_scenario.h"
#include "config/sim_config.h"
#include "support/input_file.h"

namespace syncline {

Result<std::vector<std::string>> link_files(std::string_view text) {
  const auto link = parse_link_text(text);
  if (!link || link->kind == LinkKind::kAdapter) return std::vector<std::string>{};
  std::vector<std::string> files{link->target};
  // What comes over a pipe comes once, for whoever opens the link.
  if (link->kind == LinkKind::kReplay || is_stream(link->target)) return files;
  const auto config = load_network(link->target, link->network, link->seed);
  if (config) files.insert(files.end(), config->files.begin(), config->files.end());
  if (!config && config.error().code == ErrorCode::kCancelled) return tl::unexpected(config.error());
  return files;
}

}  // namespace syncline
