#include "benchmarks/report/catalogue_page.h"

#include <gtest/gtest.h>

namespace prehend::bench {
namespace {

TEST(CataloguePage, SaysHowEachHandWasReadAndWhatItHolds) {
  const CatalogueHand jaw{.name = "jaw",
                          .source = "maker/jaw.urdf",
                          .joints = 2,
                          .drives = 1,
                          .preshapes = 3,
                          .notes = 4,
                          .aperture = 0.085,
                          .seconds = 0.25,
                          .picture = "hands/jaw.png",
                          .grasps = {{"can", 0.2, 0.5}, {"sofa", 0.0, 0.0}}};
  const CatalogueHand claw{.name = "claw", .source = "maker/claw.xml", .refusal = "no joint moves"};
  const std::string page = catalogue_page({claw, jaw}, 300);
  EXPECT_NE(page.find("| hand: source | read as | opens | can | sofa |"), std::string::npos)
      << page;
  EXPECT_NE(
      page.find("| jaw: maker/jaw.urdf | joints: 2, drives: 1, preshapes: 3, notes: 4, 0.2 s | "
                "85 mm | 0.200, 50 % | – |"),
      std::string::npos)
      << page;
  EXPECT_NE(page.find("| claw: maker/claw.xml | refused: no joint moves |  |  |  |"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("![jaw](hands/jaw.png)"), std::string::npos) << page;
  EXPECT_NE(page.find("300 trials"), std::string::npos);
}

}  // namespace
}  // namespace prehend::bench
