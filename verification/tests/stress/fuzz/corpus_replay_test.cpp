// SPDX-License-Identifier: Apache-2.0
// The fuzz targets' checks on each input of their corpora, in every build, without libFuzzer.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "stress/fuzz/checks.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/plan_reader.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::fuzz {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(TRIBOCHECK_SOURCE_DIR) / "verification/tests/stress/fuzz";

void replay(const std::string& corpus, Check check) {
  const std::string file = content_of(folder / "corpus" / (corpus + ".txt"));
  std::size_t inputs = 0;
  for (std::size_t at = file.find("\n-- "); at != std::string::npos; ++inputs) {
    const std::size_t begin = file.find('\n', at + 1) + 1;
    const std::size_t end = file.find("\n-- ", begin);
    const std::string name = file.substr(at + 1, begin - at - 2);
    const std::string text =
        file.substr(begin, (end == std::string::npos ? file.size() - 1 : end) - begin);
    EXPECT_LE(text.size(), 2048u) << name << ": the short run cuts its inputs there";
    EXPECT_EQ(broken_property(check, text), "") << name;
    at = end;
  }
  EXPECT_GE(inputs, 40u);
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

// The fuzzers get to valid scenes faster if they know the words of scenes.
TEST(FuzzCorpus, DictionaryHasEveryWordOfTheSchema) {
  const std::string dictionary = content_of(folder / "scene.dict");
  const auto hold = [&](std::string_view word) {
    EXPECT_NE(dictionary.find('"' + std::string(word) + '"'), std::string::npos)
        << "scene.dict lacks the word " << word;
  };
  for (const FieldInfo& field : scene_fields()) {
    hold(field.path.substr(field.path.rfind('.') + 1));
    for (const std::string_view word : field.choices) hold(word);
  }
  for (const OutputInfo& output : output_infos) hold(output.name);
  for (const sweep::SweepField& field : sweep::sweep_fields()) hold(field.name);
}

}  // namespace
}  // namespace tribo::fuzz
