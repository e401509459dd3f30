// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace syncline {
struct MonitorView;
}  // namespace syncline

namespace syncline::eni {

class FieldReader;
class FieldWriter;

/// Views of the monitor, beside Master and Slaves; nothing where there are none.
void write_views(FieldWriter& writer, const std::vector<MonitorView>& views);
void read_views(FieldReader& reader, std::vector<MonitorView>& views);

}  // namespace syncline::eni
