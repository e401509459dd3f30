// SPDX-License-Identifier: Apache-2.0
#include "support/standard_streams.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace syncline {
namespace {

/// Else what is printed would go into the file that is opened first: a table, a capture, a memory shared by all
/// programs.
TEST(StandardStreams, OfAProgramThatHasNoneNobodyElseGetsTheirNumbers) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int stream : {0, 1, 2}) ::close(stream);
    take_closed_streams();
    const int file = ::open("/dev/null", O_RDWR);
    if (file <= 2) ::_exit(1);
    const char word = 'x';
    for (const int stream : {1, 2}) {
      if (::write(stream, &word, 1) != -1 || errno != EBADF) ::_exit(2);
    }
    char read = 0;
    ::_exit(::read(0, &read, 1) == -1 ? 0 : 3);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  const int before = ::fcntl(STDERR_FILENO, F_GETFL);
  take_closed_streams();
  EXPECT_EQ(::fcntl(STDERR_FILENO, F_GETFL), before) << "those that are open stay";
}

}  // namespace
}  // namespace syncline
