// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "check/network_view.h"
#include "config/network_config.h"
#include "config/process_image.h"
#include "config/slave_config.h"
#include "protocol/coe_data_type.h"

namespace syncline::checker {
namespace {

Range bits_of(const Variable& variable) {
  return {variable.bit_offset, std::uint64_t{variable.bit_offset} + variable.bit_size};
}
Range bits_of(const ImageRange& range) { return {range.bit_start, std::uint64_t{range.bit_start} + range.bit_length}; }

class VariableCheck {
 public:
  /// `slaves`: image bits of the slaves' process data. What lies elsewhere in a frame image is TwinCAT's diagnosis.
  VariableCheck(PlaceKind kind, const std::vector<Variable>& variables, std::uint32_t image_bytes, bool frame_image,
                std::vector<Range> slaves, Findings& findings)
      : kind_(kind),
        variables_(variables),
        image_{0, std::uint64_t{image_bytes} * 8},
        frame_image_(frame_image),
        slaves_(merged(std::move(slaves))),
        findings_(findings) {}

  void run() {
    check_places();
    check_names();
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      const Variable& variable = variables_[i];
      const auto* type = coe::find_data_type(variable.data_type);
      if (type != nullptr && type->bits != 0 && type->bits != variable.bit_size) {
        add("ENI-IMG-07", i, fig::text<"variable">(variable.name), fig::text<"type">(variable.data_type),
            fig::count<"bits">(variable.bit_size), fig::count<"has">(type->bits));
      }
    }
  }

 private:
  template <FigureName... kNames>
  void add(Sentence<kNames...> code, std::size_t variable, Named<kNames>... figures) {
    findings_.add<kNames...>(code, {kind_, variable}, std::move(figures)...);
  }

  void check_places() {
    std::vector<OwnedRange> ranges;
    Diagnosis behind;
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      const Range bits = bits_of(variables_[i]);
      ranges.push_back({bits, i});
      if (image_.contains(bits)) continue;
      // ByteSize is that of the frames: TwinCAT puts more of its diagnosis behind them.
      if (frame_image_ && bits.begin >= image_.end) {
        behind.take(i);
      } else {
        add("ENI-IMG-01", i, fig::text<"variable">(variables_[i].name), fig::number<"first">(bits.begin),
            fig::number<"last">(std::max<std::uint64_t>(bits.end, 1) - 1), fig::number<"image">(image_.end));
      }
    }
    Diagnosis shared;
    for (const auto& [first, second] : overlaps(ranges)) {
      if (is_diagnosis(second)) {
        shared.take(second);
      } else {
        add("ENI-IMG-03", second, fig::text<"variable">(variables_[second].name),
            fig::text<"other">(variables_[first].name));
      }
    }
    report("ENI-IMG-02", behind);
    report("ENI-IMG-12", shared);
  }

  struct Diagnosis {
    std::size_t count = 0, first = 0;
    void take(std::size_t variable) {
      if (count++ == 0) first = variable;
    }
  };
  void report(Sentence<counted(FigureName("count")), "variable"> code, const Diagnosis& found) {
    if (found.count > 0) {
      add<counted(FigureName("count")), "variable">(code, found.first, fig::count<"count">(found.count),
                                                    fig::text<"variable">(variables_[found.first].name));
    }
  }
  [[nodiscard]] bool is_diagnosis(std::size_t variable) const {
    return frame_image_ && !covered(bits_of(variables_[variable]), slaves_);
  }

  void check_names() {
    std::unordered_map<std::string_view, std::size_t> first;
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      if (variables_[i].name.empty()) continue;
      if (!first.emplace(variables_[i].name, i).second) {
        add("ENI-IMG-06", i, fig::text<"variable">(variables_[i].name));
      }
    }
  }

  PlaceKind kind_;
  const std::vector<Variable>& variables_;
  Range image_;
  bool frame_image_;
  std::vector<Range> slaves_;
  Findings& findings_;
};

/// Send or Recv of all slaves: inside the image, no bit twice.
void check_slave_ranges(const NetworkView& view, std::optional<ImageRange> SlaveConfig::*member, const char* name,
                        std::uint32_t image_bytes, Findings& findings) {
  const Range image{0, std::uint64_t{image_bytes} * 8};
  std::vector<OwnedRange> ranges;
  for (std::size_t i = 0; i < view.config.slaves.size(); ++i) {
    const auto& range = view.config.slaves[i].*member;
    if (!range) continue;
    ranges.push_back({bits_of(*range), i});
    if (!image.contains(bits_of(*range))) {
      findings.add("ENI-IMG-04", {PlaceKind::kSlave, i}, fig::text<"element">(name),
                   fig::count<"bits">(range->bit_length), fig::number<"first">(range->bit_start),
                   fig::number<"image">(image.end));
    }
  }
  for (const auto& [first, second] : overlaps(ranges)) {
    findings.add("ENI-IMG-05", {PlaceKind::kSlave, ranges[second].owner}, fig::text<"element">(name),
                 view.slave<"slave">(ranges[first].owner));
  }
}

}  // namespace

void check_image(const NetworkView& view, Findings& findings) {
  const ProcessImage& image = view.config.image;
  const bool frames = image.command_data_offset != 0;
  std::vector<Range> sent, received;
  for (const SlaveConfig& slave : view.config.slaves) {
    if (slave.send) sent.push_back(bits_of(*slave.send));
    if (slave.receive) received.push_back(bits_of(*slave.receive));
  }
  VariableCheck(PlaceKind::kInput, image.inputs, image.input_bytes, frames, std::move(received), findings).run();
  VariableCheck(PlaceKind::kOutput, image.outputs, image.output_bytes, frames, std::move(sent), findings).run();
  check_slave_ranges(view, &SlaveConfig::send, "Send", image.output_bytes, findings);
  check_slave_ranges(view, &SlaveConfig::receive, "Recv", image.input_bytes, findings);
}

}  // namespace syncline::checker
