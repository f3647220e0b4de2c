#include "planner/main/bulk/requested_batch.h"

#include "sim/base/json/json_field.h"

namespace prehend {

AskedBatch::AskedBatch(const std::filesystem::path& file, const std::filesystem::path& out)
    : batch(read_batch(JsonFile(file))),
      folder(out.empty() ? std::filesystem::path("out") / batch.name : out, batch),
      inputs(batch) {}

}  // namespace prehend
