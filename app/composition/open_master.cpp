// SPDX-License-Identifier: Apache-2.0
#include "app/composition/open_master.h"

#include <utility>

#include "app/composition/open_link.h"
#include "channels/background_master.h"
#include "config/project.h"
#include "engine/background_master.h"
#include "engine/opened_link.h"

namespace syncline {

Result<std::unique_ptr<BackgroundMaster>> open_master(std::string_view link) {
  auto opened = open_link(link);
  if (!opened) return tl::unexpected(opened.error());
  return make_background_master(std::move(*opened));
}

Result<std::unique_ptr<BackgroundMaster>> open_master(const Project& machine) {
  auto opened = open_simulated(machine);
  if (!opened) return tl::unexpected(opened.error());
  return make_background_master(std::move(*opened));
}

}  // namespace syncline
