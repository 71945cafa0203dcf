// SPDX-License-Identifier: Apache-2.0
// Scenes as files: which files are read, and which are refused before they are read.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "scene/scene_text.hpp"
#include "support/temporary_folder.hpp"

namespace tribo::scene_test {
namespace {

class SceneFile : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.file(name); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  static void expect_refused(const std::string& file, std::string_view part) {
    const SceneReading reading = read_scene(file, SceneUse::speeds);
    ASSERT_EQ(reading.errors.size(), 1u) << file << '\n' << lines_of(reading.errors);
    const std::string line = reading.errors[0].line();
    EXPECT_TRUE(line.starts_with(file + ':')) << line;
    EXPECT_NE(line.find(part), std::string::npos) << line << "\nwanted: " << part;
  }

  TemporaryFolder folder_;
};

// Makes an open file the standard input while this object lives, and closes `descriptor`.
class StandardInput {
 public:
  explicit StandardInput(int descriptor) : kept_(::dup(STDIN_FILENO)) {
    EXPECT_GE(descriptor, 0);
    ::dup2(descriptor, STDIN_FILENO);
    ::close(descriptor);
  }
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;
  ~StandardInput() {
    ::dup2(kept_, STDIN_FILENO);
    ::close(kept_);
  }

 private:
  int kept_;
};

const std::string nameless_toml = SceneText::good().remove("id").toml();
const std::string nameless_json = SceneText::good().remove("id").json();

std::string id_of(const std::string& file) {
  const SceneReading reading = read_scene(file, SceneUse::speeds);
  EXPECT_TRUE(reading.scene) << lines_of(reading.errors);
  return reading.scene ? reading.scene->id : "";
}

TEST_F(SceneFile, GetsItsStemAsIdUnlessItHasOne) {
  EXPECT_EQ(id_of(write("smooth.toml", nameless_toml)), "smooth");
  EXPECT_EQ(id_of(write("smooth.v2.json", nameless_json)), "smooth.v2");
  EXPECT_EQ(id_of(write("plain", nameless_toml)), "plain");
  EXPECT_EQ(id_of(write(".hidden", nameless_toml)), ".hidden");
  EXPECT_EQ(id_of(write("other.toml", SceneText::good().toml())), "rough");
  EXPECT_EQ(id_of(write("empty.toml", "id = \"\"\n" + nameless_toml)), "");
  EXPECT_EQ(id_of(write("odd\xff.toml", nameless_toml)), "odd\\xff");
}

TEST_F(SceneFile, IsJsonByNameOrByItsFirstSign) {
  EXPECT_EQ(id_of(write("a.json", nameless_json)), "a");
  EXPECT_EQ(id_of(write("b.toml", " \n" + nameless_json)), "b");
  EXPECT_EQ(id_of(write("c", "\xEF\xBB\xBF" + nameless_json)), "c");
  expect_refused(write("d.json", "x = 1"), "not JSON");
}

TEST_F(SceneFile, IsRefusedIfItIsNeitherAFileNorAPipe) {
  expect_refused(folder_.path().string(), "is a directory");
  expect_refused("/dev/null", "is neither a file nor a pipe");
  expect_refused("/dev/zero", "is neither a file nor a pipe");
}

TEST_F(SceneFile, MayBeANamedPipe) {
  ASSERT_EQ(::mkfifo(path("fifo.toml").c_str(), 0600), 0);
  std::thread writer([name = path("fifo.toml")] {
    const int end = ::open(name.c_str(), O_WRONLY);
    EXPECT_EQ(::write(end, nameless_toml.data(), nameless_toml.size()),
              static_cast<ssize_t>(nameless_toml.size()));
    ::close(end);
  });
  EXPECT_EQ(id_of(path("fifo.toml")), "fifo");
  writer.join();
}

TEST_F(SceneFile, IsRefusedIfItCannotBeRead) {
  expect_refused(path("missing.toml"), "No such file or directory");
  expect_refused(path("missing/missing.toml"), "No such file or directory");
  EXPECT_EQ(read_scene("", SceneUse::speeds).errors.size(), 1u);
  EXPECT_EQ(read_scene(std::string(10'000, 'x'), SceneUse::speeds).errors.size(), 1u);
  if (::geteuid() == 0) return;  // root may read every file
  std::filesystem::permissions(write("closed.toml", "x"), std::filesystem::perms::none);
  expect_refused(path("closed.toml"), "Permission denied");
}

TEST_F(SceneFile, IsRefusedIfItIsEmptyOrTooLarge) {
  expect_refused(write("a.toml", ""), "is empty");
  expect_refused(write("b.json", " \n\t\r\n"), "is empty");
  expect_refused(write("c.toml", std::string(max_scene_bytes + 1, ' ')), "too large");
  EXPECT_EQ(id_of(write("d.toml",
                        nameless_toml + std::string(max_scene_bytes - nameless_toml.size(), '\n'))),
            "d");
}

TEST_F(SceneFile, MayBeStandardInput) {
  const StandardInput redirected(::open(write("scene", nameless_toml).c_str(), O_RDONLY));
  EXPECT_EQ(id_of("-"), "");
}

TEST_F(SceneFile, OfStandardInputIsNotReadBeyondTheLimit) {
  const StandardInput redirected(::open("/dev/zero", O_RDONLY));
  expect_refused("-", "too large");
}

TEST_F(SceneFile, OfADirectoryAsStandardInputIsRefused) {
  const StandardInput redirected(::open(folder_.path().c_str(), O_RDONLY));
  expect_refused("-", "Is a directory");
}

TEST_F(SceneFile, OfAPipeIsReadInPieces) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  std::thread writer([write_end = ends[1]] {
    for (std::size_t at = 0; at < nameless_json.size(); at += 100) {
      const std::string_view piece = std::string_view(nameless_json).substr(at, 100);
      EXPECT_EQ(::write(write_end, piece.data(), piece.size()), static_cast<ssize_t>(piece.size()));
    }
    ::close(write_end);
  });
  const StandardInput redirected(ends[0]);
  EXPECT_EQ(id_of("-"), "");
  writer.join();
}

}  // namespace
}  // namespace tribo::scene_test
