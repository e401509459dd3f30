// SPDX-License-Identifier: Apache-2.0
#include "eni/project/view_fields.h"

#include "eni/project/project_fields.h"

namespace syncline::eni {
namespace {

// In all of these `x` is a FieldWriter with a const value or a FieldReader with a mutable one.

constexpr auto signal_fields = [](auto& x, auto& signal) {
  x.attribute("Of", signal.of);
  x.attribute("Key", signal.key);
  if (signal.of == ViewSignal::Of::kSlave) x.attribute("Slave", signal.station_address);
  x.attribute_if_set("Output", signal.output);
  x.attribute_if_set("Rate", signal.rate);
  x.attribute_if_set("Right", signal.right);
};

constexpr auto plot_fields = [](auto& x, auto& plot) {
  x.attribute("Title", plot.title);
  x.attribute("Scale", plot.scale);
  x.attribute("Left", plot.left);
  x.attribute("Right", plot.right);
  x.attribute_if_set("OwnTime", plot.own_time);
  x.attribute("Height", plot.height);
  x.list("Signals", "Signal", plot.signals, signal_fields);
};

constexpr auto view_fields = [](auto& x, auto& view) {
  x.attribute("Name", view.name);
  x.list("Plots", "Plot", view.plots, plot_fields);
};

}  // namespace

void write_views(FieldWriter& writer, const std::vector<MonitorView>& views) {
  writer.optional_list("Views", "View", views, view_fields);
}

void read_views(FieldReader& reader, std::vector<MonitorView>& views) {
  reader.optional_list("Views", "View", views, view_fields);
}

}  // namespace syncline::eni
