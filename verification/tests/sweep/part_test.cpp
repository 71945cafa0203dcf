// SPDX-License-Identifier: Apache-2.0
// A part of a sweep is whole, or refused after truncation, damage, forging or a full disk.
// Processes share the parts of a sweep.
#include "sweep/part.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <chrono>
#include <cstdlib>
#include <future>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>

#include "sweep/parts_in_hand.hpp"
#include "sweep/small_sweep.hpp"

namespace tribo::sweep {
namespace {

const PartHeader header{"0.1.0", 1, "00ff", "FMA", {{"sweep.toml", "load = 20\n"}}, "7:8:9:10"};

// The content of chunk `number`; the sizes begin at 0.
Bytes content(std::uint64_t number) {
  std::mt19937_64 random(number);
  Bytes bytes(number * 37 % 200);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
  return bytes;
}

ChunksInMemory chunks_from(std::uint64_t first, std::uint64_t end) {
  ChunksInMemory chunks;
  for (std::uint64_t number = first; number < end; ++number) chunks[number] = content(number);
  return chunks;
}

std::string write(const std::string& path, const ChunksInMemory& chunks,
                  const PartHeader& its = header) {
  PartFile file(path);
  write_part(path, file, its, content_of(chunks), {.any = true, .only = {}});
  return path;
}

// The numbers of the chunks that a part has, each of which has to be as it was written.
ChunkList chunks_of(const Part& part) {
  ChunkList numbers;
  for (const Part::Record& record : part.records()) {
    EXPECT_EQ(part.read(record), content(record.chunk));
    numbers.push_back(record.chunk);
  }
  return numbers;
}
ChunkList first_numbers(std::uint64_t count) {
  ChunkList numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::uint64_t{0});
  return numbers;
}

TEST(Part, GivesBackHeaderAndChunks) {
  const TemporaryFolder folder;
  for (const std::uint64_t count : {0, 9}) {
    const Part part(write(folder.file("part"), chunks_from(0, count)));
    EXPECT_EQ(part.header(), header);
    EXPECT_EQ(chunks_of(part), first_numbers(count));
  }
  EXPECT_EQ(chunks_of(Part(header, chunks_from(0, 9))), first_numbers(9));
}

TEST(Part, HasTheSameBytesTwice) {
  const TemporaryFolder folder;
  const std::string first = content_of(write(folder.file("a"), chunks_from(3, 9)));
  EXPECT_GT(first.size(), 1000U);
  EXPECT_TRUE(first == content_of(write(folder.file("b"), chunks_from(3, 9))));
}

TEST(Part, IsRefusedCutOffAnywhere) {
  const TemporaryFolder folder;
  const std::string path = write(folder.file("part"), chunks_from(0, 6));
  const std::string whole = content_of(path);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    write_content(path, whole.substr(0, size));
    EXPECT_NE(error_of([&] { Part{path}; }), "none") << size;
  }
}

TEST(Part, IsRefusedWithOneFlippedBit) {
  const TemporaryFolder folder;
  const std::string path = write(folder.file("part"), chunks_from(0, 5));
  std::string content = content_of(path);
  for (std::size_t i = 0; i < content.size(); ++i) {
    char& byte = content[i];
    const char before = byte;
    byte = static_cast<char>(byte ^ (1 << (i % 8)));
    write_content(path, content);
    byte = before;
    EXPECT_NE(error_of([&] { Part{path}; }), "none") << i;
  }
}

TEST(Part, RefusesWhatIsNone) {
  const TemporaryFolder folder;
  const std::string path = folder.file("none");
  EXPECT_EQ(error_of([&] { Part{path}; }), "cannot read " + path + ": No such file or directory");
  write_content(path, std::string(3000, 'x'));
  EXPECT_EQ(error_of([&] { Part{path}; }).find(path + " is no whole part of tribocheck sweep"), 0U);
  write_content(path, "\x93TBSJ1\r\n" + std::string(3000, 'x'));
  EXPECT_EQ(error_of([&] { Part{path}; }).find(path + " is a shard or journal of an older"), 0U);
  EXPECT_EQ(content_of(path).size(), 3008U);
}

// The index is changed, and the file gets the right checksum again.
TEST(Part, RefusesAForgedIndex) {
  const TemporaryFolder folder;
  const std::string path = folder.file("part"), whole = content_of(write(path, chunks_from(0, 4)));
  const auto refused_with = [&](std::size_t at, std::uint64_t value) {
    write_content(path, whole.substr(0, whole.size() - 24));
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t index = H5Dopen2(file, "index", H5P_DEFAULT);
    std::vector<std::uint64_t> numbers(12);
    H5Dread(index, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    numbers[at] = value;
    H5Dwrite(index, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    H5Dclose(index);
    H5Fclose(file);
    seal(open_file(path, O_RDWR, path));
    return error_of([&] {
      const Part part(path);
      for (const Part::Record& record : part.records()) part.read(record);
    });
  };
  EXPECT_EQ(refused_with(0, 0), "none");
  const std::string damaged = path + " is no part of a sweep: its index is damaged";
  EXPECT_EQ(refused_with(0, 1), damaged);                       // a number twice
  EXPECT_EQ(refused_with(4, std::uint64_t{1} << 63), damaged);  // an end far behind
  EXPECT_EQ(refused_with(10, 3), damaged);                      // an end below the end before it
  EXPECT_EQ(refused_with(5, 1), path + " has changed since it was looked at: chunk 1 is damaged");
}

TEST(Part, TellsAChunkThatHasChangedSince) {
  const TemporaryFolder folder;
  const std::string path = write(folder.file("part"), chunks_from(0, 4));
  const Part part(path);
  std::string changed = content_of(path);
  char& byte = changed[part.records()[2].offset + 5];
  byte = static_cast<char>(byte ^ 1);
  write_content(path, changed);
  EXPECT_EQ(part.read(part.records()[1]), content(1));
  EXPECT_EQ(error_of([&] { part.read(part.records()[2]); }),
            path + " has changed since it was looked at: chunk 2 is damaged");
}

TEST(Part, IsWrittenByManyThreadsAtOnce) {
  const TemporaryFolder folder;
  std::vector<std::thread> threads;
  for (std::uint64_t t = 0; t < 8; ++t)
    threads.emplace_back([&, t] {
      for (std::uint64_t i = 0; i < 5; ++i)
        write(folder.file(std::to_string(5 * t + i)), chunks_from(t, t + 20));
    });
  for (std::thread& thread : threads) thread.join();
  for (std::uint64_t i = 0; i < 40; ++i)
    EXPECT_EQ(chunks_of(Part(folder.file(std::to_string(i)))).size(), 20U);
}

TEST(Part, IsNotThereWhenItCouldNotBeWrittenWhole) {
  const TemporaryFolder folder;
  const std::string path = folder.file("part");
  const std::uint64_t size = content_of(write(path, chunks_from(0, 9))).size();
  std::filesystem::remove(path);
  for (const std::uint64_t room : {std::uint64_t{0}, std::uint64_t{100}, size / 2, size - 30})
    expect_whole_or_nothing(
        folder, room, "cannot write .*part: ", [&] { write(path, chunks_from(0, 9)); },
        [&] { return chunks_of(Part(path)).size() == 9; });
}

PartSet set_of(const std::vector<std::string>& paths, std::uint64_t chunks, bool any = false) {
  std::vector<Part> parts;
  for (const std::string& path : paths) parts.emplace_back(path);
  return {std::move(parts), chunks, any};
}

TEST(PartSet, HasEachChunkOnceAndSaysWhichAreMissing) {
  const TemporaryFolder folder;
  const PartSet set = set_of(
      {write(folder.file("a"), chunks_from(0, 4)), write(folder.file("b"), chunks_from(2, 6))}, 7);
  EXPECT_EQ(set.count(), 6U);
  for (std::uint64_t i = 0; i < 6; ++i) EXPECT_EQ(set.read(i), content(i));
  EXPECT_FALSE(set.has(6));
  EXPECT_EQ(error_of([&] { set.read(6); }), "chunk 6 is in no part");
}

TEST(PartSet, SaysWhatDoesNotGoTogether) {
  const TemporaryFolder folder;
  const std::string a = write(folder.file("a"), {}), b = folder.file("b");
  const auto error_with = [&](const PartHeader& other) {
    write(b, {}, other);
    return error_of([&] { set_of({a, b}, 3); });
  };
  PartHeader other = header;
  other.version = "0.2.0";  // with the same version of numbers
  EXPECT_EQ(error_with(other), "none");
  other.digest = "00fe";
  EXPECT_EQ(error_with(other), b + " is of another sweep than " + a + " (digest 00fe, not 00ff)");
  other.numbers = 2;
  EXPECT_EQ(error_with(other),
            b + " was computed by tribocheck 0.2.0, " + a + " by 0.1.0, and their numbers differ");
  other = header;
  other.arithmetic = "no FMA";
  EXPECT_EQ(error_with(other), b + " was computed with no FMA, " + a + " with FMA");
  EXPECT_NO_THROW(set_of({a, b}, 3, true));
  write(b, chunks_from(0, 4));
  EXPECT_EQ(error_of([&] { set_of({b}, 3); }), b + " has chunk 3 of a sweep that has 3 chunks");
}

TEST(PartSet, NamesEachArithmeticOnceOfThoseThatComputedAChunk) {
  const TemporaryFolder folder;
  std::vector<std::string> paths;
  const auto add = [&](const std::string& set, std::uint64_t first, std::uint64_t end) {
    PartHeader other = header;
    other.arithmetic = set;
    paths.push_back(
        write(folder.file(std::to_string(paths.size())), chunks_from(first, end), other));
  };
  add("SSE4", 0, 2);
  EXPECT_EQ(set_of(paths, 9, true).arithmetics(), "SSE4");
  add("AVX2", 2, 3);
  add("NEON", 0, 0);
  EXPECT_EQ(set_of(paths, 9, true).arithmetics(), "AVX2; SSE4");
  add("AVX2; AVX3", 3, 4);
  EXPECT_EQ(set_of(paths, 9, true).arithmetics(), "AVX2; AVX3; SSE4");
}

// --- How processes share parts.

// Chunks of one point each whose films are solved: half a second each.
SweepPlan slow_plan(std::uint64_t chunks) {
  SweepPlan plan = small_plan();
  plan.scenes.resize(1);
  SceneSweep& scene = plan.scenes[0];
  scene.solves_film = true;
  scene.scene.speeds.list = {0.1};
  scene.groups = scene.chunks = chunks;
  scene.chunk_groups = 1;
  return plan;
}

// Chunks of some ten thousand numbers each, which take no time to compute.
SweepPlan wide_plan(std::uint64_t chunks) {
  SweepPlan plan = slow_plan(chunks);
  SceneSweep& scene = plan.scenes[0];
  scene.solves_film = false;
  scene.keep_points = true;
  scene.chunk_groups = 1 << 11;
  scene.groups = chunks * scene.chunk_groups;
  return plan;
}

// A part has at most a twentieth of the chunks plus `few`, which is a little more than the chunks
// of 2 s or of 2²¹ numbers: 4 of slow_plan() and 73 of wide_plan().
void expect_parts_of(const SweepPlan& plan, std::uint64_t chunks, std::uint64_t few) {
  const std::vector<ChunkList> parts = cut_in_parts(plan, first_numbers(chunks));
  ChunkList all;
  for (const ChunkList& part : parts) all.insert(all.end(), part.begin(), part.end());
  EXPECT_EQ(all, first_numbers(chunks));
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    EXPECT_GE(parts[i].size(), 3U);
    EXPECT_LE(parts[i].size(), chunks / 20 + few);
  }
  EXPECT_LE(static_cast<double>(parts.front().size()), most_chunks_of_part(plan));
  EXPECT_LE(most_chunks_of_part(plan), static_cast<double>(parts.front().size()) + 1);
  EXPECT_LE(parts.size(), 4096U);
}

TEST(Parts, HaveEachChunkOnceAndTakeSomeSeconds) {
  for (const std::uint64_t chunks : {1, 3, 100, 100000, 1000000}) {
    SCOPED_TRACE(chunks);
    expect_parts_of(slow_plan(chunks), chunks, 5);
    expect_parts_of(wide_plan(chunks), chunks, 80);
  }
  SweepPlan quick = slow_plan(1000);
  quick.scenes[0].solves_film = false;
  EXPECT_EQ(cut_in_parts(quick, first_numbers(1000)).size(), 1U);
  EXPECT_EQ(cut_in_parts(quick, {}).size(), 0U);
}

TEST(Parts, HaveAsManyChunksAsTheEnvironmentAsksFor) {
  for (const std::size_t asked : {1, 2, 7}) {
    ASSERT_EQ(setenv("TRIBOCHECK_PART_CHUNKS", std::to_string(asked).c_str(), 1), 0);
    for (const SweepPlan& plan : {slow_plan(14), wide_plan(14)}) {
      const std::vector<ChunkList> parts = cut_in_parts(plan, first_numbers(14));
      EXPECT_EQ(parts.size(), 14 / asked);
      for (const ChunkList& part : parts) EXPECT_EQ(part.size(), asked);
      EXPECT_EQ(most_chunks_of_part(plan), static_cast<double>(asked));
    }
  }
  unsetenv("TRIBOCHECK_PART_CHUNKS");
}

// Parts and shards from different cuts of a sweep never have the same path.
TEST(Parts, OfDifferentChunksHaveDifferentNames) {
  std::map<std::string, ChunkList> by_name;
  constexpr std::uint64_t chunks = 24;
  for (std::uint64_t step = 1; step <= chunks; ++step)
    for (std::uint64_t first = 0; first < chunks; ++first) {
      ChunkList list;
      for (std::uint64_t chunk = first; chunk < chunks; chunk += step) {
        list.push_back(chunk);
        const auto place = by_name.emplace(path_of_part("out.h5", list), list).first;
        EXPECT_EQ(place->second, list) << place->first;
      }
    }
  const TemporaryFolder folder;
  for (const auto& [name, list] : by_name) write_content(folder.file(name), "");
  EXPECT_EQ(parts_of(folder.file("out.h5")).size(), by_name.size());
}

const std::vector<ChunkList> four_parts{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9}};

// A process that shares four parts of an output.
struct Process {
  explicit Process(const TemporaryFolder& folder, std::size_t begin = 0,
                   std::function<bool()> over = {})
      : parts({folder.file("out"), header, begin, false, std::move(over)}, four_parts,
              std::vector<bool>(4)) {}
  // Takes and keeps at most `most` chunks; gives their numbers.
  ChunkList compute(int most) {
    ChunkList numbers;
    for (int i = 0; i < most; ++i) {
      const auto chunk = parts.next();
      if (!chunk) break;
      parts.keep(*chunk, content(*chunk));
      numbers.push_back(*chunk);
    }
    return numbers;
  }
  PartsInHand parts;
};

TEST(PartsInHand, OfTwoProcessesEachTakesPartsThatTheOtherHasNot) {
  const TemporaryFolder folder;
  Process first(folder), second(folder);
  EXPECT_EQ(first.compute(2), (ChunkList{0, 1}));
  EXPECT_EQ(first.parts.chunks_there(), 2U);  // of a part that is not whole yet
  EXPECT_EQ(second.compute(4), (ChunkList{3, 4, 5, 6}));
  EXPECT_EQ(first.compute(9), (ChunkList{2, 9}));
  EXPECT_FALSE(first.parts.is_done());  // the other process holds one part
  EXPECT_FALSE(first.parts.has_work());
  EXPECT_EQ(second.compute(9), (ChunkList{7, 8}));
  EXPECT_TRUE(first.parts.is_done());
  EXPECT_EQ(first.parts.chunks_there(), 10U);
  const std::vector<std::string> paths = parts_of(folder.file("out"));
  EXPECT_EQ(paths.size(), 4U);
  EXPECT_EQ(set_of(paths, 10).count(), 10U);
  EXPECT_EQ(files_of_parts(folder.file("out")).size(), 4U);  // no claim is left
}

// Too long a name is refused at the beginning, wherever its part stands.
TEST(PartsInHand, AreRefusedWhereTheNameOfAnyPartIsTooLong) {
  const TemporaryFolder folder;
  const auto is_refused = [&](std::size_t length, const std::vector<ChunkList>& parts) {
    try {
      PartsInHand({folder.file(std::string(length, 'o')), header, 0, false, {}}, parts,
                  std::vector<bool>(parts.size()));
      return false;
    } catch (const std::exception&) {
      return true;
    }
  };
  std::size_t told_apart = 0;
  for (std::size_t length = 200; length <= 255; ++length) {
    const bool is_long = is_refused(length, {{1000}});
    told_apart += is_long && !is_refused(length, {{0}}) ? 1 : 0;
    EXPECT_EQ(is_refused(length, {{0}, {1000}}), is_long) << length;
    EXPECT_EQ(is_refused(length, {{1000}, {0}}), is_long) << length;
  }
  EXPECT_GT(told_apart, 0U);
}

TEST(PartsInHand, TakesWhatAProcessThatEndedHasClaimed) {
  const TemporaryFolder folder;
  std::optional<Process> first(folder);
  EXPECT_EQ(first->compute(2), (ChunkList{0, 1}));
  Process second(folder, 1);
  EXPECT_EQ(second.compute(10), (ChunkList{3, 4, 5, 6, 7, 8, 9}));
  EXPECT_FALSE(second.parts.is_done());
  first.reset();
  write_content(folder.file("out.part-0-2.lock"), "");  // as a killed process leaves it
  EXPECT_EQ(second.compute(10), (ChunkList{0, 1, 2}));
  EXPECT_TRUE(second.parts.is_done());
}

TEST(PartsInHand, BeginsNothingOnceTheSweepIsOver) {
  const TemporaryFolder folder;
  bool is_over = false;
  Process process(folder, 2, [&] { return is_over; });
  EXPECT_EQ(process.compute(3), (ChunkList{6, 7, 8}));
  std::filesystem::remove(folder.file("out.part-6-8"));  // by the owner, which has the result
  is_over = true;
  EXPECT_EQ(process.compute(3), ChunkList());
  EXPECT_TRUE(process.parts.is_done());
}

TEST(PartsInHand, OfSeveralThreadsGivesEachChunkOnceAndWaitsForNoPart) {
  const TemporaryFolder folder;
  Process process(folder);
  // Two threads hold chunks of the first part, while the other threads go on with the second part.
  ChunkList taken;
  for (int i = 0; i < 5; ++i) taken.push_back(*process.parts.next());
  EXPECT_EQ(taken, first_numbers(5));
  for (const std::uint64_t chunk : {4, 2, 0, 3, 1}) process.parts.keep(chunk, content(chunk));
  EXPECT_EQ(parts_of(folder.file("out")).size(), 1U);
  EXPECT_EQ(process.compute(9), (ChunkList{5, 6, 7, 8, 9}));
  EXPECT_EQ(set_of(parts_of(folder.file("out")), 10).count(), 10U);
}

// While one thread waits for a slow folder, the others can still hand over their chunks.
TEST(PartsInHand, KeepsChunksWhileAThreadLooksForParts) {
  const TemporaryFolder folder;
  std::promise<void> looks, kept;
  std::future<void> is_looking = looks.get_future(), is_kept = kept.get_future();
  int asked = 0;
  bool waited_in_vain = false;
  Process process(folder, 0, [&] {
    if (++asked == 2) {
      looks.set_value();
      waited_in_vain = is_kept.wait_for(std::chrono::seconds(20)) == std::future_status::timeout;
    }
    return false;
  });
  for (int i = 0; i < 3; ++i) process.parts.next();
  std::jthread looking([&] { EXPECT_EQ(process.parts.next(), 3U); });
  is_looking.wait();
  for (const std::uint64_t chunk : {0, 1, 2}) process.parts.keep(chunk, content(chunk));
  kept.set_value();
  looking.join();
  EXPECT_FALSE(waited_in_vain);
  EXPECT_EQ(parts_of(folder.file("out")).size(), 1U);
}

// A file that a killed process has not renamed is removed. A file of a part that is being computed
// is kept, and so is a file of another program.
TEST(PartsInHand, LeavesWhatIsInUseWhereBegunFilesAreRemoved) {
  const TemporaryFolder folder;
  Process process(folder);
  EXPECT_EQ(process.compute(1), ChunkList{0});
  write_content(folder.file(".out.part-0-2.77-0"), "");  // as a part that is being written
  write_content(folder.file(".out.part-3-5.77-0"), "");
  write_content(folder.file(".out.77-0"), "");
  write_content(folder.file(".out.77-1"), "of somebody");
  remove_begun(folder.file("out"));
  EXPECT_TRUE(std::filesystem::exists(folder.file(".out.part-0-2.77-0")));
  EXPECT_FALSE(std::filesystem::exists(folder.file(".out.part-3-5.77-0")));
  EXPECT_FALSE(std::filesystem::exists(folder.file(".out.77-0")));
  EXPECT_EQ(content_of(folder.file(".out.77-1")), "of somebody");
  EXPECT_EQ(process.compute(9), (ChunkList{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

// Sixteen threads each get a chunk, though no thread has finished one.
TEST(PartsInHand, GivesWorkToSixteenThreadsOfASweepOfTwentySeconds) {
  const TemporaryFolder folder;
  SweepPlan plan = small_plan();
  plan.scenes.resize(1);
  SceneSweep& scene = plan.scenes[0];
  scene.solves_film = true;
  scene.scene.speeds.list = {0.1};
  scene.variables = {scene.variables[1]};
  scene.outputs = {};
  scene.criteria = {};
  scene.draws = 40;  // of half a second each
  lay_out(scene);
  const auto parts = cut_in_parts(plan, first_numbers(plan.chunks()));
  PartsInHand in_hand({folder.file("out"), header, 0, false, {}}, parts,
                      std::vector<bool>(parts.size()));
  std::set<std::uint64_t> given;
  for (int thread = 0; thread < 16; ++thread)
    if (const auto chunk = in_hand.next()) given.insert(*chunk);
  EXPECT_EQ(given.size(), 16U);
}

// A short sweep writes no parts.
TEST(PartsInHand, KeepsAllInMemoryWhereItIsAsked) {
  const TemporaryFolder folder;
  PartsInHand parts({folder.file("out"), header, 0, true, {}}, {{0, 1, 2}}, {false});
  while (const auto chunk = parts.next()) parts.keep(*chunk, content(*chunk));
  EXPECT_TRUE(parts.is_done());
  EXPECT_EQ(parts.take_memory(), chunks_from(0, 3));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace tribo::sweep
