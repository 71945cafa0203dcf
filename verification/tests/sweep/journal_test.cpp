// SPDX-License-Identifier: Apache-2.0
// The records that a journal keeps through truncation, damage, a full disk and two writers.
#include "sweep/journal.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <random>
#include <stdexcept>
#include <thread>

#include "sweep/small_sweep.hpp"

namespace tribo::sweep {
namespace {

const JournalHeader header{"0.1.0", "00ff", "AVX2", {{"sweep.toml", "load = 20\n"}}};

// The content of chunk `number`; sizes from nothing on.
Bytes content(std::uint64_t number) {
  std::mt19937_64 random(number);
  Bytes bytes(number * 37 % 200);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
  return bytes;
}

void append(Journal& journal, std::uint64_t first, std::uint64_t end) {
  for (std::uint64_t number = first; number < end; ++number)
    journal.append(number, content(number));
}

std::string small_journal(const TemporaryFolder& folder, std::uint64_t chunks) {
  const std::string path = folder.file("journal");
  Journal journal = Journal::create(path, header);
  append(journal, 0, chunks);
  journal.sync();
  return path;
}

// The numbers of the chunks that a journal has, each of which has to be as it was written.
std::vector<std::uint64_t> chunks_of(const JournalReader& reader) {
  std::vector<std::uint64_t> numbers;
  for (const JournalReader::Record& record : reader.records()) {
    EXPECT_EQ(reader.read(record), content(record.chunk));
    numbers.push_back(record.chunk);
  }
  return numbers;
}
std::vector<std::uint64_t> first_numbers(std::uint64_t count) {
  std::vector<std::uint64_t> numbers(count);
  for (std::uint64_t i = 0; i < count; ++i) numbers[i] = i;
  return numbers;
}

TEST(Journal, GivesBackHeaderAndChunks) {
  const TemporaryFolder folder;
  const JournalReader reader(small_journal(folder, 9));
  EXPECT_EQ(reader.header(), header);
  EXPECT_EQ(chunks_of(reader), first_numbers(9));
  EXPECT_EQ(reader.lost_bytes(), 0U);
}

TEST(Journal, LosesByTruncationOnlyTheRecordThatIsCut) {
  const TemporaryFolder folder;
  const std::string path = small_journal(folder, 6);
  const std::string whole = content_of(path);
  const JournalReader reader(path);
  const std::uint64_t one_header = (reader.records().front().offset - 32) / 2;
  const std::string cut = folder.file("cut");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    write_content(cut, whole.substr(0, size));
    if (size < one_header) {
      EXPECT_THROW(JournalReader{cut}, std::runtime_error) << size;
      continue;
    }
    std::uint64_t whole_chunks = 0, end = size < 2 * one_header ? one_header : 2 * one_header;
    for (const JournalReader::Record& record : reader.records())
      if (record.offset + record.size <= size) {
        ++whole_chunks;
        end = record.offset + record.size;
      }
    const JournalReader of_cut(cut);
    EXPECT_EQ(chunks_of(of_cut), first_numbers(whole_chunks)) << size;
    EXPECT_EQ(of_cut.lost_bytes(), size - end) << size;
  }
}

TEST(Journal, GoesOnAfterTruncationAnywhere) {
  const TemporaryFolder folder;
  const std::string whole = content_of(small_journal(folder, 5));
  const std::string cut = folder.file("cut");
  for (std::size_t size = whole.size() / 3; size < whole.size(); size += 3) {
    write_content(cut, whole.substr(0, size));
    const std::uint64_t had = JournalReader(cut).records().size();
    {
      Journal journal = Journal::resume(cut);
      append(journal, had, 8);
    }
    const JournalReader reader(cut);
    EXPECT_EQ(chunks_of(reader), first_numbers(8)) << size;
    EXPECT_EQ(reader.lost_bytes(), 0U) << size;
  }
}

TEST(Journal, LosesByOneFlippedBitOneChunkAtMost) {
  const TemporaryFolder folder;
  const std::string path = small_journal(folder, 5);
  std::string content = content_of(path);
  const std::uint64_t first = JournalReader(path).records().front().offset - 32;
  for (std::size_t bit = 0; bit < 8 * content.size(); ++bit) {
    char& byte = content[bit / 8];
    byte = static_cast<char>(byte ^ (1 << (bit % 8)));
    write_content(path, content);
    byte = static_cast<char>(byte ^ (1 << (bit % 8)));
    const JournalReader reader(path);
    EXPECT_EQ(reader.header(), header) << bit;
    EXPECT_EQ(chunks_of(reader).size(), bit / 8 < first ? 5U : 4U) << bit;
    EXPECT_GT(reader.lost_bytes(), 0U) << bit;
  }
}

TEST(Journal, KeepsWhatLiesBehindDamageWhenItGoesOn) {
  const TemporaryFolder folder;
  const std::string path = small_journal(folder, 6);
  std::string content = content_of(path);
  const std::uint64_t second = JournalReader(path).records()[2].offset;
  for (std::size_t i = 0; i < 20; ++i) content[second + i] = '\0';
  write_content(path, content);
  {
    Journal journal = Journal::resume(path);
    append(journal, 2, 3);
  }
  EXPECT_EQ(chunks_of(JournalReader(path)), (std::vector<std::uint64_t>{0, 1, 3, 4, 5, 2}));
}

TEST(Journal, TakesNoRecordOfAnotherSweep) {
  const TemporaryFolder folder;
  const std::string path = small_journal(folder, 3);
  const std::string content = content_of(path);
  JournalHeader other = header;
  other.digest = "00fe";
  const std::string of_other = folder.file("other");
  Journal::create(of_other, other);
  const std::uint64_t first = JournalReader(path).records().front().offset - 32;
  write_content(of_other, content_of(of_other) + content.substr(first));
  EXPECT_EQ(JournalReader(of_other).records().size(), 0U);
}

TEST(Journal, IsNotMadeWhereAFileIs) {
  const TemporaryFolder folder;
  const std::string path = small_journal(folder, 2);
  EXPECT_EQ(error_of([&] { Journal::create(path, header); }),
            "cannot create " + path + ": File exists");
  EXPECT_EQ(JournalReader(path).records().size(), 2U);
}

TEST(Journal, RefusesWhatIsNone) {
  const TemporaryFolder folder;
  const std::string path = folder.file("none");
  EXPECT_EQ(error_of([&] { JournalReader{path}; }),
            "cannot read " + path + ": No such file or directory");
  write_content(path, std::string(3000, 'x'));
  EXPECT_EQ(error_of([&] { JournalReader{path}; }),
            path + " is no journal of a sweep, or its head is lost");
  EXPECT_EQ(error_of([&] { Journal::resume(path); }),
            path + " is no journal of a sweep, or its head is lost");
  EXPECT_EQ(content_of(path), std::string(3000, 'x'));
}

TEST(Journal, HasOneWriterAtATime) {
  const TemporaryFolder folder;
  const std::string path = small_journal(folder, 2);
  {
    const Journal first = Journal::resume(path);
    EXPECT_EQ(error_of([&] { Journal::resume(path); }),
              path + " is being written by another process");
  }
  EXPECT_NO_THROW(Journal::resume(path));
}

TEST(Journal, TakesChunksOfManyThreads) {
  const TemporaryFolder folder;
  const std::string path = folder.file("journal");
  {
    Journal journal = Journal::create(path, header);
    std::vector<std::thread> threads;
    for (std::uint64_t t = 0; t < 4; ++t)
      threads.emplace_back([&journal, t] { append(journal, 100 * t, 100 * (t + 1)); });
    for (std::thread& thread : threads) thread.join();
  }
  std::vector<std::uint64_t> numbers = chunks_of(JournalReader(path));
  std::sort(numbers.begin(), numbers.end());
  EXPECT_EQ(numbers, first_numbers(400));
}

// As on a full disk: writes end short, then fail.
TEST(Journal, TakesBackARecordThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string path = small_journal(folder, 3);
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const std::uint64_t end = content_of(path).size();
  for (const std::uint64_t room : {0, 5, 32, 40}) {
    Journal journal = Journal::resume(path);
    rlimit limited = before;
    limited.rlim_cur = end + room;
    setrlimit(RLIMIT_FSIZE, &limited);
    const std::string error = error_of([&] { journal.append(3, content(3)); });
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(error, "cannot write " + path + ": File too large");
    EXPECT_EQ(content_of(path).size(), end);
    EXPECT_EQ(chunks_of(JournalReader(path)), first_numbers(3));
  }
  std::signal(SIGXFSZ, old_handler);
  Journal journal = Journal::resume(path);
  append(journal, 3, 5);
  EXPECT_EQ(chunks_of(JournalReader(path)), first_numbers(5));
}

JournalSet set_of(const std::vector<std::string>& paths, std::uint64_t chunks, bool any = false) {
  std::vector<JournalReader> readers;
  for (const std::string& path : paths) readers.emplace_back(path);
  return {std::move(readers), chunks, any};
}

TEST(JournalSet, HasEachChunkOnceAndSaysWhichAreMissing) {
  const TemporaryFolder folder;
  const std::string a = folder.file("a"), b = folder.file("b");
  {
    Journal first = Journal::create(a, header), second = Journal::create(b, header);
    append(first, 0, 4);
    append(second, 2, 6);
  }
  const JournalSet set = set_of({a, b}, 7);
  EXPECT_EQ(set.count(), 6U);
  for (std::uint64_t i = 0; i < 6; ++i) EXPECT_EQ(set.read(i), content(i));
  EXPECT_FALSE(set.has(6));
  EXPECT_EQ(error_of([&] { set.read(6); }), "chunk 6 is in no journal");
}

TEST(JournalSet, SaysWhatDoesNotGoTogether) {
  const TemporaryFolder folder;
  const std::string a = folder.file("a"), b = folder.file("b");
  { Journal::create(a, header); }
  const auto error_with = [&](const JournalHeader& other) {
    std::filesystem::remove(b);
    Journal::create(b, other);
    return error_of([&] { set_of({a, b}, 3); });
  };
  JournalHeader other = header;
  other.digest = "00fe";
  EXPECT_EQ(error_with(other), b + " is of another sweep than " + a + " (digest 00fe, not 00ff)");
  other.version = "0.2.0";
  EXPECT_EQ(error_with(other), b + " was computed by tribocheck 0.2.0, " + a + " by 0.1.0");
  other = header;
  other.arithmetic = "AVX3_ZEN4";
  EXPECT_EQ(error_with(other), b + " was computed with AVX3_ZEN4, " + a + " with AVX2");
  EXPECT_NO_THROW(set_of({a, b}, 3, true));
  EXPECT_EQ(error_of([&] { set_of({}, 3); }), "no journal is given");
}

TEST(JournalSet, NamesEachArithmeticOnceOfThoseThatComputedAChunk) {
  const TemporaryFolder folder;
  std::vector<std::string> paths;
  const auto add = [&](const std::string& set, std::uint64_t first, std::uint64_t end) {
    JournalHeader other = header;
    other.arithmetic = set;
    paths.push_back(folder.file(std::to_string(paths.size())));
    Journal journal = Journal::create(paths.back(), other);
    append(journal, first, end);
  };
  add("SSE4", 0, 2);
  EXPECT_EQ(set_of(paths, 9, true).arithmetics(), "SSE4");
  add("AVX2", 2, 3);
  add("NEON", 0, 0);
  EXPECT_EQ(set_of(paths, 9, true).arithmetics(), "AVX2; SSE4");
  add("AVX2; AVX3", 3, 4);
  EXPECT_EQ(set_of(paths, 9, true).arithmetics(), "AVX2; AVX3; SSE4");
}

TEST(JournalSet, RefusesAChunkThatTheSweepDoesNotHave) {
  const TemporaryFolder folder;
  const std::string path = small_journal(folder, 4);
  EXPECT_EQ(error_of([&] { set_of({path}, 3); }),
            path + " has chunk 3 of a sweep that has 3 chunks");
}

}  // namespace
}  // namespace tribo::sweep
