#include <patchgrip/verification/claims/stored_run.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/verification/claims/all_claims.h>
#include <patchgrip/verification/claims/comparison.h>
#include <patchgrip/verification/claims/two_solvers.h>

namespace patchgrip::verification {
namespace {

using ::testing::HasSubstr;

std::filesystem::path file_of(std::string_view name) {
  return std::filesystem::path(PATCHGRIP_DATA_DIR) / "fe" / (std::string(name) + ".json");
}

TEST(StoredRuns, LibraryIsAsClaimedAgainstEachOfThem) {
  for (const ClaimSet& set : all_claims()) {
    SCOPED_TRACE(set.name);
    const StoredRun run = read_stored_run(file_of(set.name));
    const auto quantities = set.quantities();
    EXPECT_EQ(run.name, set.name);
    ASSERT_EQ(run.quantities.size(), quantities.size());
    int judged = 0;
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      SCOPED_TRACE(quantities[q].name);
      const StoredQuantity& stored = run.quantities[q];
      ASSERT_EQ(stored.name, quantities[q].name);
      ASSERT_EQ(stored.fe.size(), quantities[q].library.size());
      ASSERT_EQ(stored.fe_error.size(), stored.fe.size());
      const Comparison c = compare(quantities[q], stored.fe, stored.fe_error, std::nan(""));
      EXPECT_TRUE(c.is_as_claimed()) << "difference " << c.difference << ", FE's own error " << c.relative_error;
      if (c.verdict != Verdict::cannot_judge) ++judged;
    }
    EXPECT_GT(judged, 0) << "nothing of this case can be judged";
  }
}

TEST(TwoSolvers, AgreeWithinTheirErrorsWhereBothSolveACase) {
  for (const SolverPair& pair : solver_pairs()) {
    SCOPED_TRACE(pair.second);
    const Agreement found =
        agreement(pair, read_stored_run(file_of(pair.first)), read_stored_run(file_of(pair.second)));
    EXPECT_TRUE(found.is_within_bound) << found.apart << " apart, bound " << found.bound;
  }
}

TEST(TwoSolvers, DisagreeWhereOneIsOffByMoreThanTheirErrors) {
  for (const SolverPair& pair : solver_pairs()) {
    SCOPED_TRACE(pair.second);
    const StoredRun first = read_stored_run(file_of(pair.first));
    StoredRun second = read_stored_run(file_of(pair.second));
    const Agreement before = agreement(pair, first, second);
    for (StoredQuantity& quantity : second.quantities) {
      for (double& value : quantity.fe) value *= 1 + 4 * before.bound;
    }
    EXPECT_FALSE(agreement(pair, first, second).is_within_bound);
    EXPECT_THROW(agreement(pair, second, first), std::out_of_range);
  }
}

TEST(TwoSolvers, DisagreeWhereAnyEntryIsNotANumber) {
  const SolverPair& pair = solver_pairs()[1];
  const StoredRun first = read_stored_run(file_of(pair.first));
  StoredRun second = read_stored_run(file_of(pair.second));
  second.quantities.at(1).fe.front() = std::nan("");
  EXPECT_FALSE(agreement(pair, first, second).is_within_bound);
}

TEST(StoredRuns, AreReadAsTheyWereWritten) {
  const auto file = file_of("sphere");
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  EXPECT_EQ(text_of(read_stored_run(file)), text.str());
}

TEST(StoredRuns, AlteredOnesAreRefused) {
  StoredRun run{"sphere", "ci", {{"getfem", "0"}}, {{10, 20, 1, {{1.5}}}}, {{"approach", {1.5}, {0.25}}}};
  std::string text = text_of(run);
  text.replace(text.find("0.25"), 4, "0.75");
  const auto file = std::filesystem::path(::testing::TempDir()) / "altered_run.json";
  std::ofstream(file) << text;
  try {
    read_stored_run(file);
    ADD_FAILURE() << "an altered run was read";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("altered_run.json: has been altered"));
  }
  std::filesystem::remove(file);
  EXPECT_THROW(read_stored_run(file), std::runtime_error);
}

TEST(Comparison, JudgesOnlyWhatFiniteElementsCanTell) {
  Quantity quantity{"x", "1", {1, 2}, 2, 0.01, "", Claim::agrees};
  EXPECT_EQ(compare(quantity, {1.01, 2}, {0.01, 0.01}, 1).verdict, Verdict::agrees);
  EXPECT_EQ(compare(quantity, {1.05, 2}, {0.01, 0.01}, 1).verdict, Verdict::differs);
  EXPECT_EQ(compare(quantity, {1.01, 2}, {0.05, 0.01}, 1).verdict, Verdict::cannot_judge);
  EXPECT_EQ(compare(quantity, {1.2, 2}, {0.05, 0.01}, 1).verdict, Verdict::differs);
  EXPECT_FALSE(compare(quantity, {1.2, 2}, {0.05, 0.01}, 1).is_as_claimed());
  quantity.claim = Claim::differs;
  EXPECT_EQ(compare(quantity, {1.2, 2}, {0.05, 0.01}, 1).verdict, Verdict::differs);
  EXPECT_TRUE(compare(quantity, {1.2, 2}, {0.05, 0.01}, 1).is_as_claimed());
  EXPECT_EQ(compare(quantity, {1.02, 2}, {0.05, 0.01}, 1).verdict, Verdict::cannot_judge);
  EXPECT_FALSE(compare(quantity, {1.02, 2}, {0.05, 0.01}, 1).is_as_claimed()) << "a difference has to be seen";
}

TEST(Comparison, RefusesWhatIsNotANumber) {
  const Quantity quantity{"x", "1", {1, 2}, 2, 0.01, "", Claim::agrees};
  EXPECT_THROW(compare(quantity, {std::nan(""), 2}, {0.01, 0.01}, 1), std::runtime_error);
  EXPECT_THROW(compare(quantity, {1, 2}, {0.01, std::nan("")}, 1), std::runtime_error);
  EXPECT_THROW(compare(quantity, {1}, {0.01}, 1), std::runtime_error);
}

TEST(Claims, UnknownNamesAreRefused) { EXPECT_THROW(claims_of("spheer"), std::out_of_range); }

}  // namespace
}  // namespace patchgrip::verification
