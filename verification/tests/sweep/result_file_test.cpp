// SPDX-License-Identifier: Apache-2.0
// A result gives back what was written to it, and does not depend on time and place of writing.
#include "sweep/result_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <stdexcept>

#include "sweep/result_seal.hpp"
#include "sweep/small_sweep.hpp"

namespace tribo::sweep {
namespace {

std::string small_result(const TemporaryFolder& folder, const std::string& name) {
  const SweepPlan plan = small_plan();
  write_result(folder.file(name), plan, chunks_of(plan), nullptr);
  return folder.file(name);
}

Descriptor opened(const std::string& path) { return open_file(path, O_RDONLY, path); }

// NaN is equal to itself here.
void expect_same(const Bounded& a, const Bounded& b) {
  EXPECT_EQ(bits_of({{a.value, a.low, a.high}}), bits_of({{b.value, b.low, b.high}}));
}

// The summary of one value of a column, from all cases at once and not merged from chunks.
ValueSummary summary_of(const SceneSweep& scene, std::size_t column, std::size_t value) {
  const std::vector<double> all = small_cases(scene).columns[column];
  std::vector<double> values;
  for (std::size_t i = value; i < all.size(); i += scene.columns[column].width)
    values.push_back(all[i]);
  ValueSummary summary;
  summary.add(values);
  return summary;
}

TEST(ResultFile, HasTheSameBytesTwice) {
  const TemporaryFolder folder;
  const std::string first = content_of(small_result(folder, "a.h5"));
  EXPECT_GT(first.size(), 10000U);
  EXPECT_TRUE(first == content_of(small_result(folder, "b.h5")));
}

TEST(ResultFile, TellsOfEachChunkAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  const SweepPlan plan = small_plan();
  std::vector<std::uint64_t> told;
  write_result(folder.file("result.h5"), plan, chunks_of(plan),
               [&](std::uint64_t chunks) { told.push_back(chunks); });
  EXPECT_EQ(told, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_FALSE(std::filesystem::exists(folder.file("result.h5.part")));
}

TEST(ResultFile, GivesBackEachCaseToTheBit) {
  const TemporaryFolder folder;
  const std::string path = small_result(folder, "result.h5");
  const SweepPlan plan = small_plan();
  for (const SceneSweep& scene : plan.scenes) {
    if (!scene.keep_points) continue;
    const SmallCases cases = small_cases(scene);
    for (std::size_t v = 0; v < scene.variables.size(); ++v)
      EXPECT_EQ(bits_of(ResultFile(path).input(scene.scene.id, scene.variables[v].path)),
                bits_of(cases.inputs[v]));
    for (std::size_t c = 0; c < scene.columns.size(); ++c)
      EXPECT_EQ(bits_of(ResultFile(path).column(scene.scene.id, scene.columns[c].name)),
                bits_of(cases.columns[c]));
  }
}

TEST(ResultFile, GivesBackTheTextsOfScenes) {
  const TemporaryFolder folder;
  const SweepResult result = ResultFile(small_result(folder, "result.h5")).read();
  const SweepPlan plan = small_plan();
  EXPECT_EQ(result.identity.version, plan.version);
  EXPECT_EQ(result.identity.digest, plan.digest);
  EXPECT_EQ(result.identity.arithmetic, "AVX2");
  ASSERT_EQ(result.scenes.size(), plan.scenes.size());
  for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
    const SceneSweep& scene = plan.scenes[i];
    const SceneResult& read = result.scenes[i];
    EXPECT_EQ(read.id, scene.scene.id);
    EXPECT_EQ(read.file, scene.file);
    EXPECT_EQ(read.text, scene.text);
    EXPECT_EQ(read.design, name(scene.design));
    EXPECT_EQ(read.seed, scene.seed);
    EXPECT_EQ(read.draws, scene.draws);
    EXPECT_EQ(read.cases, scene.cases());
    EXPECT_EQ(read.points, scene.points());
    EXPECT_EQ(read.speeds, scene.scene.speeds.list);
    EXPECT_EQ(read.has_points, scene.keep_points);
    ASSERT_EQ(read.inputs.size(), scene.variables.size());
    for (std::size_t v = 0; v < scene.variables.size(); ++v) {
      EXPECT_EQ(read.inputs[v].path, scene.variables[v].path);
      EXPECT_EQ(read.inputs[v].unit, scene.variables[v].unit);
      EXPECT_EQ(read.inputs[v].meaning, scene.variables[v].meaning);
      EXPECT_EQ(read.inputs[v].varies, scene.variables[v].text);
      EXPECT_EQ(read.inputs[v].words, scene.variables[v].words);
    }
    ASSERT_EQ(read.columns.size(), scene.columns.size());
    for (std::size_t c = 0; c < scene.columns.size(); ++c) {
      EXPECT_EQ(read.columns[c].name, scene.columns[c].name);
      EXPECT_EQ(read.columns[c].unit, scene.columns[c].unit);
      EXPECT_EQ(read.columns[c].words, scene.columns[c].words);
      EXPECT_EQ(read.columns[c].values.size(), scene.columns[c].width);
      EXPECT_EQ(read.column(scene.columns[c].name), &read.columns[c]);
    }
    EXPECT_EQ(read.column("none"), nullptr);
  }
}

TEST(ResultFile, GivesBackTheSummariesOfAllCases) {
  const TemporaryFolder folder;
  const SweepResult result = ResultFile(small_result(folder, "result.h5")).read();
  const SweepPlan plan = small_plan();
  for (std::size_t i = 0; i < plan.scenes.size(); ++i)
    for (std::size_t c = 0; c < plan.scenes[i].columns.size(); ++c)
      for (std::size_t s = 0; s < plan.scenes[i].columns[c].width; ++s) {
        const ValueSummary whole = summary_of(plan.scenes[i], c, s);
        const ColumnResult::Value& read = result.scenes[i].columns[c].values[s];
        EXPECT_EQ(read.count, whole.moments.count);
        EXPECT_EQ(read.undefined, whole.undefined);
        const std::vector<QuantileSketch::Bin> bins = histogram_of(whole.sketch, histogram_bins);
        ASSERT_EQ(read.histogram.size(), bins.size());
        for (std::size_t b = 0; b < bins.size(); ++b) {
          EXPECT_EQ(read.histogram[b].low, bins[b].low);
          EXPECT_EQ(read.histogram[b].high, bins[b].high);
          EXPECT_EQ(read.histogram[b].count, bins[b].count);
        }
        for (std::size_t q = 0; q < quantile_levels.size(); ++q)
          expect_same(read.quantiles[q], quantile_of(whole, quantile_levels[q]));
        if (read.count == 0) {
          for (const double number : {read.mean, read.sd, read.least, read.greatest})
            EXPECT_PRED1([](double value) { return std::isnan(value); }, number);
          continue;
        }
        EXPECT_EQ(read.least, whole.moments.least);
        EXPECT_EQ(read.greatest, whole.moments.greatest);
        // The file's sums are merged from those of the chunks, so that their rounding differs.
        EXPECT_NEAR(read.mean, whole.moments.mean, 1e-14 * std::abs(whole.moments.mean));
        EXPECT_NEAR(read.sd, whole.moments.sd(), 1e-14 * whole.moments.sd());
      }
}

TEST(ResultFile, GivesBackSensitivities) {
  const TemporaryFolder folder;
  const SweepResult result = ResultFile(small_result(folder, "result.h5")).read();
  const SweepPlan plan = small_plan();
  EXPECT_TRUE(result.scenes[0].sensitivity_variables.empty());
  EXPECT_EQ(result.scenes[1].sensitivity_variables,
            std::vector<std::string>{"lubricant.viscosity"});
  const SceneSweep& scene = plan.scenes[1];
  for (std::size_t c = 0; c < scene.columns.size(); ++c)
    for (std::size_t s = 0; s < scene.columns[c].width; ++s) {
      SensitivityBlocks blocks;
      for (std::uint64_t number = 0; number < scene.chunks; ++number) {
        const Chunk chunk = small_chunk(scene, number, number);
        for (const auto& [block, sums] : chunk.sensitivities[c][s]) blocks[block].merge(sums);
      }
      const SobolIndices indices = sobol_indices(blocks);
      const SobolIndices& read = result.scenes[1].columns[c].values[s].sensitivity;
      EXPECT_EQ(read.groups, indices.groups);
      ASSERT_EQ(read.total.size(), 1U);
      ASSERT_EQ(read.first_order.size(), 1U);
      if (indices.groups == 0) continue;
      expect_same(read.total[0], indices.total[0]);
      expect_same(read.first_order[0], indices.first_order[0]);
    }
}

TEST(ResultFile, SaysWhatItDoesNotHave) {
  const TemporaryFolder folder;
  const std::string path = small_result(folder, "result.h5");
  EXPECT_EQ(error_of([&] { ResultFile(path).column("other", "film"); }),
            path + " has no scene other");
  EXPECT_EQ(error_of([&] { ResultFile(path).column("plain", "onset.film_departure.speed"); }),
            path + " has no onset.film_departure.speed among the outputs of scene plain");
  EXPECT_EQ(error_of([&] { ResultFile(path).input("plain", "load"); }),
            path + " has no load among the inputs of scene plain");
  EXPECT_EQ(error_of([&] { ResultFile(path).column("summaries", "film"); }),
            path + " keeps no points of scene summaries, only summaries");
}

TEST(ResultFile, IsToldFromOtherFiles) {
  const TemporaryFolder folder;
  const std::string path = folder.file("other.h5");
  EXPECT_EQ(error_of([&] { ResultFile(path).identity(); }),
            path + " cannot be read: No such file or directory");
  const auto expect_refused = [&](const std::string& why) {
    const std::string said = error_of([&] { ResultFile(path).identity(); });
    EXPECT_EQ(said.rfind(path + ' ' + why, 0), 0U) << said;
  };
  write_content(path, "speed film\n");
  expect_refused("is no whole result of tribocheck sweep");
  H5Fclose(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  expect_refused("is no whole result of tribocheck sweep");
  seal(open_file(path, O_RDWR, path));
  expect_refused("is an HDF5 file, but no result of tribocheck sweep");
}

TEST(ResultFile, IsRefusedWhereOneByteIsAnother) {
  const TemporaryFolder folder;
  const std::string whole = content_of(small_result(folder, "result.h5"));
  const std::string changed = folder.file("changed.h5");
  for (std::size_t at = 0; at < whole.size(); at += 499) {
    std::string content = whole;
    content[at] = static_cast<char>(content[at] ^ 0x10);
    write_content(changed, content);
    EXPECT_NE(broken_seal(opened(changed), changed, "result"), "") << at;
    EXPECT_THROW(ResultFile(changed).read(), std::runtime_error) << at;
  }
  for (std::size_t from_end = 1; from_end <= 24; ++from_end) {
    std::string content = whole;
    content[whole.size() - from_end] ^= 1;
    write_content(changed, content);
    EXPECT_NE(broken_seal(opened(changed), changed, "result"), "") << from_end;
  }
  write_content(changed, whole);
  EXPECT_EQ(broken_seal(opened(changed), changed, "result"), "");
}

TEST(ResultFile, HasChecksumsInEachDataset) {
  const TemporaryFolder folder;
  const std::string path = small_result(folder, "result.h5");
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  int datasets = 0;
  const auto look = [](hid_t object, const char* name, const H5O_info_t* info, void* count) {
    if (info->type != H5O_TYPE_DATASET) return 0;
    const hid_t dataset = H5Dopen2(object, name, H5P_DEFAULT);
    const hid_t creation = H5Dget_create_plist(dataset);
    const int filters = H5Pget_nfilters(creation);
    unsigned flags = 0;
    std::size_t values = 0;
    EXPECT_GT(filters, 0) << name;
    EXPECT_EQ(H5Pget_filter2(creation, static_cast<unsigned>(filters - 1), &flags, &values, nullptr,
                             0, nullptr, nullptr),
              H5Z_FILTER_FLETCHER32)
        << name;
    H5Pclose(creation);
    H5Dclose(dataset);
    ++*static_cast<int*>(count);
    return 0;
  };
  EXPECT_EQ(H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, look, &datasets), 0);
  EXPECT_GT(datasets, 100);
  H5Fclose(file);
}

TEST(ResultFile, NeedsAllChunks) {
  const TemporaryFolder folder;
  const SweepPlan plan = small_plan();
  const std::string path = folder.file("result.h5");
  const PartSet none({}, plan.chunks(), false);
  EXPECT_EQ(error_of([&] { write_result(path, plan, none, nullptr); }),
            "cannot write " + path + ": 0 of 9 chunks are there");
}

TEST(ResultFile, HoldsThePointsOfOneShortChunk) {
  const TemporaryFolder folder;
  SweepPlan plan = small_plan();
  plan.scenes.resize(1);
  plan.scenes[0].groups = 5;
  plan.scenes[0].chunks = 1;
  const std::string path = folder.file("result.h5");
  write_result(path, plan, chunks_of(plan), nullptr);
  EXPECT_EQ(bits_of(ResultFile(path).column("plain", "film")),
            bits_of(small_cases(plan.scenes[0]).columns[0]));
}

TEST(ResultFile, IsNotThereWhenItCouldNotBeWrittenWhole) {
  const TemporaryFolder folder;
  const SweepPlan plan = small_plan();
  const PartSet chunks = chunks_of(plan);
  const std::string path = folder.file("result.h5");
  for (const std::uint64_t room : {0, 100, 5000, 30000, 100000})
    expect_whole_or_nothing(
        folder, room, "cannot write .*: File too large",
        [&] { write_result(path, plan, chunks, nullptr); },
        [&] { return ResultFile(path).identity().digest == plan.digest; });
}

}  // namespace
}  // namespace tribo::sweep
