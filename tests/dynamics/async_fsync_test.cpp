// Files that reach the disk beside what goes on: what cannot is said by the one who waits for it, once.
#include "output/async_fsync.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <system_error>

namespace gearfilm {
namespace {

class DiskFlushTest : public testing::Test {
protected:
  DiskFlushTest() : file_(std::filesystem::path(testing::TempDir()) / ("gearfilm_flush_" + std::to_string(getpid()))) {
    std::ofstream(file_) << "text";
  }
  ~DiskFlushTest() override { std::filesystem::remove(file_); }

  std::filesystem::path file_;
};

TEST_F(DiskFlushTest, TakesFilesFoldersAndWhatIsGone) {
  AsyncFsync flush;
  EXPECT_NO_THROW(flush.finish());
  flush.begin({file_, file_.parent_path(), file_.parent_path() / "gearfilm_never_there"});
  EXPECT_NO_THROW(flush.finish());
}

TEST_F(DiskFlushTest, SaysOnceWhatCannotBeFlushed) {
  AsyncFsync flush;
  flush.begin({file_ / "in_a_file"});
  try {
    flush.finish();
    FAIL() << "a path through a file was flushed";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::not_a_directory);
  }
  EXPECT_NO_THROW(flush.finish());
}

}  // namespace
}  // namespace gearfilm
