// SPDX-License-Identifier: Apache-2.0
#include "tests/support/own_devices.h"

#include "eni/esi/esi_reader.h"
#include "tests/support/source_dir.h"

namespace syncline::sample {

DeviceDescription own(const std::string& type) {
  const auto file = eni::read_esi(test::source_dir() + "/resources/esi/" + type + ".xml");
  return file && !file->devices.empty() ? file->devices.front() : DeviceDescription{};
}

}  // namespace syncline::sample
