// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "config/network_config.h"
#include "record/recording_writer.h"
#include "tests/core/record/made_samples.h"

namespace syncline::bench {

constexpr std::size_t kCycles = 10'000'000, kBatch = 1'000;
constexpr double kMiB = 1024 * 1024;

inline NetworkConfig three_slaves() {
  NetworkConfig config;
  config.slaves.resize(3);
  return config;
}

/// A recording that meets everything.
inline Status write_recording(const std::string& path, std::size_t cycles = kCycles) {
  auto writer = RecordingWriter::create(path, about_run(three_slaves()));
  if (!writer) return tl::unexpected(writer.error());
  test::MadeSamples made(1);
  for (std::size_t done = 0; done < cycles; done += kBatch) {
    RecordingBatch batch;
    batch.samples = made.next(kBatch);
    if (auto status = writer->write(batch); !status) return status;
  }
  return writer->finish("end of the run", {});
}

inline void read_bytes(const std::string& path) {
  std::vector<char> buffer(1U << 20);
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  while (::read(file, buffer.data(), buffer.size()) > 0) {
  }
  ::close(file);
}

}  // namespace syncline::bench
