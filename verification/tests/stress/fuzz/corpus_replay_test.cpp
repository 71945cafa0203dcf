// SPDX-License-Identifier: Apache-2.0
// The fuzz targets' checks on each file of their corpora, in every build, without libFuzzer.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "stress/fuzz/checks.hpp"
#include "sweep/plan_reader.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::fuzz {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(TRIBOCHECK_SOURCE_DIR) / "verification/tests/stress/fuzz";

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void replay(const char* corpus, void (*check)(std::string_view)) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "corpus" / corpus))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  EXPECT_GE(files.size(), 20u);
  for (const std::filesystem::path& path : files) {
    const std::string text = text_of(path);
    EXPECT_LE(text.size(), 2048u) << path << ": the short run cuts its inputs there";
    EXPECT_EQ(broken_property(check, text), "") << path;
  }
}

TEST(FuzzCorpus, TomlScenesHoldTheirProperties) { replay("toml", check_toml_scene); }
TEST(FuzzCorpus, TomlSweepsHoldTheirProperties) { replay("toml", check_sweep); }
TEST(FuzzCorpus, JsonScenesHoldTheirProperties) { replay("json", check_json_scene); }
TEST(FuzzCorpus, JsonScenesAreReadAlikeByBothReaders) { replay("json", check_ordinary_scene); }
TEST(FuzzCorpus, StreamsHoldTheirProperties) { replay("stream", check_stream); }

TEST(FuzzCorpus, EmptyAndRepeatedInputsHoldTheProperties) {
  for (const auto check :
       {check_toml_scene, check_json_scene, check_ordinary_scene, check_stream, check_sweep})
    for (const char sign : {'\n', '\r', ' ', '{', '[', '"', '#', '=', 'a', '0', '\0', '\xff'})
      for (const std::size_t size : {0u, 1u, 2u, 999u, 1000u, 1001u, 1002u, 5000u})
        EXPECT_EQ(broken_property(check, std::string(size, sign)), "") << size << " × " << sign;
}

// The fuzzers get on faster with the words of the language they write.
TEST(FuzzCorpus, DictionaryHasEveryWordOfTheSchema) {
  const std::string dictionary = text_of(folder / "scene.dict");
  const auto has = [&](std::string_view word) {
    return dictionary.find('"' + std::string(word) + '"') != std::string::npos;
  };
  for (const FieldInfo& field : scene_fields()) {
    const std::string_view name = field.path.substr(field.path.rfind('.') + 1);
    EXPECT_EQ(has(name), true) << name;
    for (const std::string_view word : field.choices) EXPECT_EQ(has(word), true) << word;
  }
  for (const OutputInfo& output : output_infos) EXPECT_EQ(has(output.name), true) << output.name;
  for (const sweep::SweepField& field : sweep::sweep_fields())
    EXPECT_EQ(has(field.name), true) << field.name;
}

}  // namespace
}  // namespace tribo::fuzz
