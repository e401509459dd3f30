// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "eni/project/project_fields.h"

namespace syncline::eni {

/// Views of the monitor, beside Master and Slaves; nothing where there are none.
void write_views(FieldWriter& writer, const std::vector<MonitorView>& views);
void read_views(FieldReader& reader, std::vector<MonitorView>& views);

}  // namespace syncline::eni
