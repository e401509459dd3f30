// SPDX-License-Identifier: Apache-2.0
#include "ui/session/comparison.h"

#include <algorithm>
#include <utility>

#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "ui/session/file_kind.h"
#include "ui/session/post.h"

namespace syncline::ui {
namespace {

/// A side, as far as it is known; an ENI is no project.
struct SideContent {
  std::optional<Project> project;
  NetworkConfig config;
};

Result<SideContent> compiledSide(const Project& project) {
  auto compiled = compile(project);
  if (!compiled) return tl::unexpected(compiled.error());
  return SideContent{project, std::move(compiled->config)};
}

/// Of a file with several networks the one that `project` is: by its name.
Result<SideContent> loadedSide(const QString& path, const Project& project) {
  if (fileKind(path) == FileKind::kEni) {
    auto config = eni::read_eni(path.toStdString());
    if (!config) return tl::unexpected(config.error());
    return SideContent{std::nullopt, std::move(*config)};
  }
  const auto machine = eni::load_machine(path.toStdString());
  if (!machine) return tl::unexpected(machine.error());
  const auto network = eni::find_network(*machine, machine->networks.size() > 1 ? project.name : std::string());
  return network ? compiledSide(machine->networks[*network]) : tl::unexpected(network.error());
}

Result<SideContent> contentOf(const ComparedSide& side, const Project& project, const Project& running) {
  if (side.kind == ComparedSide::Kind::kFile) return loadedSide(side.path, project);
  return compiledSide(side.kind == ComparedSide::Kind::kRunning ? running : project);
}

Result<Compared> comparedSides(const SideContent& left, const Result<SideContent>& right) {
  if (!right) return tl::unexpected(right.error());
  Compared out;
  out.network = compare_configs(left.config, right->config);
  if (!left.project || !right->project) return out;
  out.settings = compare_settings(*left.project, *right->project);
  for (const auto& slave : left.project->slaves) out.names.push_back(slave.name);
  return out;
}

}  // namespace

int changesOf(const std::vector<SettingDifference>& settings, const std::vector<ConfigDifference>& network) {
  const auto slaves = std::ranges::count_if(network, [](const ConfigDifference& one) {
    return one.group == DifferenceGroup::kSlaves && one.left_slave != one.right_slave;
  });
  return static_cast<int>(std::ranges::count(settings, true, &SettingDifference::matters) + slaves);
}

Comparison::Comparison(BusComparer compare_bus, QObject* parent)
    : QObject(parent), compare_bus_(std::move(compare_bus)) {}

Comparison::~Comparison() {
  cancelled_ = true;
  if (worker_.joinable()) worker_.join();
}

void Comparison::start(const ComparedSide& left, const ComparedSide& right, const Project& project,
                       const Project& running) {
  Request request{left, right, project, running};
  if (!running_) return work(std::move(request));
  next_ = std::move(request);
  cancelled_ = true;
}

void Comparison::work(Request request) {
  cancelled_ = false;
  running_ = true;
  worker_ = std::thread([this, request = std::move(request)] {
    auto outcome = std::make_shared<Result<Compared>>();
    const auto ours = contentOf(request.left, request.project, request.running);
    if (!ours) {
      *outcome = tl::unexpected(ours.error());
    } else if (request.right.kind != ComparedSide::Kind::kBus) {
      *outcome = comparedSides(*ours, contentOf(request.right, request.project, request.running));
    } else if (auto bus = compare_bus_(ours->config, request.right.path, cancelled_); bus) {
      *outcome = Compared{std::move(bus->differences), {}, {}, std::move(bus->findings)};
    } else {
      *outcome = tl::unexpected(bus.error());
    }
    post(*this, [this, outcome] { deliver(std::move(*outcome)); });
  });
}

void Comparison::deliver(Result<Compared> outcome) {
  worker_.join();  // it has said its last word
  if (next_) return work(*std::exchange(next_, std::nullopt));
  running_ = false;
  result_.reset();
  failure_.reset();
  if (outcome) {
    result_ = std::move(*outcome);
  } else {
    failure_ = outcome.error();
  }
  Q_EMIT finished();
}

}  // namespace syncline::ui
