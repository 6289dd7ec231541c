// SPDX-License-Identifier: GPL-3.0-or-later
// Files that fuzzing has found: each is read, or refused with one line. scripts/fuzz.sh goes on from here.
#include "fuzz/corpus.h"
#include "fuzz/curve_reader_target.h"
#include "fuzz/mesh_reader_target.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_fuzz_corpora {

TEST(FuzzCorpora, MeshFilesAreReadOrRefused)
{
  std::size_t read = 0, number = 0;
  for(const std::vector<std::uint8_t>& input : fuzz::read_corpus(CONSTRICTIONS_FUZZ_CORPUS_DIR "/mesh_readers.hex"))
  {
    EXPECT_NO_THROW(read += fuzz::run_mesh_reader_target(input.data(), input.size())) << "input " << number;
    ++number;
  }
  EXPECT_GT(read, 0u);
  EXPECT_GT(number, read);
}

TEST(FuzzCorpora, FilesOfCurvesLoopsAndLabelsAreReadOrRefused)
{
  fuzz::Tally tally;
  fuzz::Curve_reader_target target(tally);
  std::size_t read = 0, number = 0;
  for(const std::vector<std::uint8_t>& input : fuzz::read_corpus(CONSTRICTIONS_FUZZ_CORPUS_DIR "/curve_readers.hex"))
  {
    EXPECT_NO_THROW(read += target.run(input.data(), input.size())) << "input " << number;
    ++number;
  }
  EXPECT_GT(read, 0u);
  EXPECT_GT(number, read);
  EXPECT_GT(tally.certified, 0u);
  EXPECT_GT(tally.refused, 0u);
}

} // namespace test_fuzz_corpora
