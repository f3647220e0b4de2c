// Names of results: they change with everything that the results depend on, and with nothing else.
#include "planner/bulk/content_key.h"

#include <filesystem>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "planner/bulk/batch_inputs.h"
#include "planner/bulk/part_worker.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

fs::path own_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(testing::TempDir()) / (std::string("key_") + test->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

TEST(ContentKey, KeepsContentsApart) {
  EXPECT_EQ(ContentKey().add("a").add("bc").name(), ContentKey().add("a").add("bc").name());
  EXPECT_NE(ContentKey().add("ab").add("c").name(), ContentKey().add("a").add("bc").name());
  EXPECT_NE(ContentKey().add(0.0).name(), ContentKey().add(-0.0).name());
  EXPECT_EQ(ContentKey().name().size(), 32U);
  // Of no content: the value that the xxHash specification gives.
  EXPECT_EQ(ContentKey().name(), "99aa06d3014798d86001c324468d497f");
}

const char* const kTetrahedron =
    "v 0 0 0\nv 0.05 0 0\nv 0 0.05 0\nv 0 0 0.05\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

struct Given {
  Batch batch;
  BatchInputs inputs;
  explicit Given(const fs::path& folder, const std::string& fields = "")
      : batch(read_batch(
            JsonFile(folder / "batch.json",
                     R"({"hands": ["franka_hand"], "objects": ["a.obj"])" + fields + "}"))),
        inputs(batch) {}
  std::string key() const { return PartWorker().key(batch, inputs, {}); }
};

TEST(PartKey, ChangesWithEveryInput) {
  const fs::path folder = own_folder();
  write_file(folder / "a.obj", kTetrahedron);
  std::set<std::string> keys = {Given(folder).key()};
  for (const char* fields :
       {R"(, "scales": [2])", R"(, "frictions": [0.5])", R"(, "seeds": [2])",
        R"(, "settings": ["draft"])", R"(, "settings": [{"name": "standard", "trials": 7}])",
        R"(, "density": 100)", R"(, "material": "metal")", R"(, "unit": "mm")",
        R"(, "repair": false)", R"(, "scenes": ["mug_on_table"])"}) {
    EXPECT_TRUE(keys.insert(Given(folder, fields).key()).second) << fields;
  }
  write_file(folder / "a.obj", std::string(kTetrahedron) + "# another\n");
  EXPECT_TRUE(keys.insert(Given(folder).key()).second);
}

TEST(PartKey, IsTheSameForTheSameContentElsewhere) {
  const fs::path one = own_folder() / "one";
  const fs::path two = own_folder() / "two";
  for (const fs::path& folder : {one, two}) {
    make_folder(folder);
    write_file(folder / "a.obj", kTetrahedron);
  }
  EXPECT_EQ(Given(one).key(), Given(two).key());
}

TEST(MeshFileKey, OfGltfIncludesItsBuffers) {
  const fs::path folder = own_folder();
  write_file(folder / "a.gltf", R"({"buffers": [{"uri": "a.bin"}, {"uri": 3}, 4]})");
  write_file(folder / "a.bin", "one");
  const std::string before = mesh_file_key(folder / "a.gltf");
  write_file(folder / "a.bin", "two");
  EXPECT_NE(mesh_file_key(folder / "a.gltf"), before);
}

}  // namespace
}  // namespace prehend
