// Reading batch files: what becomes of patterns and names, and what is refused.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "planner/bulk/batch.h"
#include "sim/base/json/json_field.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

class BatchFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("batch_file_") + test->name());
    fs::remove_all(folder_);
    for (const char* name :
         {"meshes/b.obj", "meshes/a.STL", "meshes/deep/a.obj", "meshes/notes.txt",
          "ycb/can/model.ply", "ycb/cup/model.ply", "single.obj"}) {
      fs::create_directories((folder_ / name).parent_path());
      std::ofstream(folder_ / name) << "not opened";
    }
  }

  Batch read(const std::string& text) const {
    return read_batch(JsonFile(folder_ / "kitchen.json", text));
  }
  std::vector<std::string> names(const std::string& objects) const {
    std::vector<std::string> names;
    for (const BatchObject& object :
         read(R"({"hands": ["barrett"], "objects": )" + objects + "}").objects) {
      names.push_back(object.name);
    }
    return names;
  }
  InputError refusal(const std::string& text) const {
    return test::refusal_of([&] { read(text); });
  }

  fs::path folder_;
};

using Names = std::vector<std::string>;

TEST_F(BatchFile, FoldersPatternsAndFilesBecomeObjects) {
  EXPECT_EQ(names(R"(["meshes/"])"), (Names{"a", "b", "deep/a"}));
  EXPECT_EQ(names(R"(["meshes"])"), (Names{"a", "b", "deep/a"}));
  EXPECT_EQ(names(R"(["meshes/*.obj"])"), (Names{"b"}));
  EXPECT_EQ(names(R"(["ycb/*/model.ply"])"), (Names{"can/model", "cup/model"}));
  EXPECT_EQ(names(R"(["single.obj", {"mesh": "meshes/b.obj", "name": "cup"}])"),
            (Names{"cup", "single"}));
  EXPECT_EQ(names(R"([{"generate": ["mug", "bowl"], "triangles": [100, 200]}])"),
            (Names{"bowl_100", "bowl_200", "mug_100", "mug_200"}));
  EXPECT_EQ(names(R"([{"generate": "mug"}])"), (Names{"mug"}));
}

TEST_F(BatchFile, DataSetsNameMeshesAsSeenFromTheFile) {
  const Batch batch = read(R"({"hands": ["barrett"], "objects": ["ycb/*/model.ply"]})");
  EXPECT_EQ(batch.objects[0].file, "ycb/can/model.ply");
  const auto& source = std::get<MeshFileSource>(batch.objects[0].source);
  EXPECT_EQ(source.path, (folder_ / "ycb/can/model.ply").string());
}

TEST_F(BatchFile, WhatIsLeftOutHasItsDefault) {
  const Batch batch = read(R"({"hands": ["barrett"], "objects": ["single.obj"]})");
  EXPECT_EQ(batch.name, "kitchen");
  EXPECT_EQ(batch.scales, std::vector<double>{1.0});
  ASSERT_EQ(batch.frictions.size(), 1U);
  EXPECT_FALSE(batch.frictions[0]);
  ASSERT_EQ(batch.settings.size(), 1U);
  EXPECT_EQ(batch.settings[0].name, "standard");
  EXPECT_EQ(batch.seeds, std::vector<std::uint64_t>{1});
}

TEST_F(BatchFile, SettingsAreAnAccuracyOrSayMore) {
  const Batch batch = read(R"({"hands": ["barrett"], "objects": ["single.obj"], "settings":
    ["draft", {"name": "many", "trials": 2000, "contacts": "hard", "enough": 5}]})");
  ASSERT_EQ(batch.settings.size(), 2U);
  EXPECT_EQ(batch.settings[0].name, "draft");
  EXPECT_EQ(batch.settings[1].name, "many");
  EXPECT_EQ(batch.settings[1].options.search.trials, 2000);
  EXPECT_EQ(batch.settings[1].options.search.enough, 5);
  EXPECT_EQ(batch.settings[1].options.trial.contacts, ContactKind::hard);
}

TEST_F(BatchFile, NamesTheFieldThatIsRefused) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"("objects": ["single.obj"], "wands": 1)", "wands"},
      {R"("objects": [])", "objects"},
      {R"("objects": ["none.obj"])", "objects[0]"},
      {R"("objects": ["meshes/*.off"])", "objects[0]"},
      {R"("objects": ["meshes/notes.txt"])", "objects[0]"},
      {R"("objects": ["single.obj", "single.obj"])", "objects"},
      {R"("objects": [{"mesh": "meshes", "name": "one"}])", "objects[0].mesh"},
      {R"("objects": [{"mesh": "single.obj", "unit": "ell"}])", "objects[0].unit"},
      {R"("objects": [{"mesh": "single.obj", "name": "../up"}])", "objects"},
      {R"("objects": [{"generate": "dragon"}])", "objects[0].generate"},
      {R"("objects": [{"generate": "mug", "triangles": 0}])", "objects[0].triangles"},
      {R"("objects": ["single.obj"], "scales": [0])", "scales[0]"},
      {R"("objects": ["single.obj"], "scales": [1, 1.0])", "scales[1]"},
      {R"("objects": ["single.obj"], "frictions": [-0.1])", "frictions[0]"},
      {R"("objects": ["single.obj"], "frictions": [0.5, 1e9])", "frictions[1]"},
      {R"("objects": ["single.obj"], "frictions": [])", "frictions"},
      {R"("objects": ["single.obj"], "seeds": [-1])", "seeds[0]"},
      {R"("objects": ["single.obj"], "settings": ["coarse"])", "settings[0]"},
      {R"("objects": ["single.obj"], "settings": [{"trials": 0}])", "settings[0].trials"},
      {R"("objects": ["single.obj"], "settings": ["draft", "draft"])", "settings"},
      {R"("objects": ["single.obj"], "scenes": ["nowhere"])", "scenes[0]"},
      {R"("objects": ["single.obj"], "density": 0)", "density"},
      {R"("objects": ["single.obj"], "material": "cheese")", "material"},
      {R"("objects": ["single.obj"], "format": "prehend batch 9")", "format"},
  };
  for (const auto& [fields, field] : cases) {
    const InputError error = refusal(R"({"hands": ["barrett"], )" + fields + "}");
    EXPECT_EQ(error.field(), field) << fields << ": " << error.what();
    EXPECT_EQ(error.file(), (folder_ / "kitchen.json").string()) << fields;
  }
  EXPECT_EQ(refusal(R"({"objects": ["single.obj"], "hands": ["tentacle"]})").field(), "hands[0]");
  EXPECT_EQ(refusal(R"({"objects": ["single.obj"]})").field(), "hands");
}

TEST_F(BatchFile, TooManyPartsAreRefusedWithoutOverflow) {
  std::string many;
  for (int i = 1; i <= 3000; ++i) many += (i > 1 ? "," : "") + std::to_string(i);
  const InputError error =
      refusal(R"({"hands": ["barrett", "franka_hand"], "objects": ["single.obj"], "scales": [)" +
              many + R"(], "frictions": [)" + many + R"(], "seeds": [)" + many + "]}");
  EXPECT_NE(std::string(error.what()).find("parts"), std::string::npos);
}

}  // namespace
}  // namespace prehend
