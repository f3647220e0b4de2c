#include "benchmarks/suction/suction_table.h"

#include <gtest/gtest.h>

namespace prehend::bench {
namespace {

SuctionResult result(double margin, HungAttitude attitude, bool adhesion, bool seal, bool strain) {
  SuctionResult made{"cup", attitude, margin, 2.0 * margin, {}};
  made.held[HeldReading::adhesion] = adhesion;
  made.held[HeldReading::seal] = seal;
  made.held[HeldReading::strain] = strain;
  return made;
}

TEST(SuctionTable, CountsWhereBothAgree) {
  const std::string text = suction_tables({
      result(2.0, HungAttitude::worst, true, true, true),
      result(1.0, HungAttitude::worst, true, false, false),
      result(0.9, HungAttitude::sideways, true, true, false),
      result(0.4, HungAttitude::sideways, false, false, false),
  });
  for (const char* row : {
           "| adhesion alone | 2 | 0 | 1 | 1 | **3 of 4** | 4 |",
           "| ... that ends where the lip lifts | 1 | 1 | 1 | 1 | **2 of 4** | 3 |",
           "| ... and tilts within the strain | 1 | 1 | 0 | 2 | **3 of 4** | 2 |",
           "| `cup` | 4 | 3 | 2 | 3 |",
           "| worst | 2 | 2 | 1 | 1 |",
           "| sideways | 2 | 1 | 1 | 2 |",
           "| away from the cups | 0 | 0 | 0 | 0 |",
           "| below 0.5 | 1 | 0 | 0 | 0 |",
           "| 0.8 to 1 | 1 | 1 | 1 | 0 |",
           "| 1 to 1.25 | 1 | 1 | 0 | 0 |",
           "| from 2.2 on | 0 | 0 | 0 | 0 |",
       }) {
    EXPECT_NE(text.find(row), std::string::npos) << row << "\n" << text;
  }
}

}  // namespace
}  // namespace prehend::bench
