#include <filesystem>
#include <memory>
#include <optional>
#include <pybind11/stl.h>

#include "planner/plan/learn/ordered_proposals.h"
#include "planner/plan/learn/tree_model_file.h"
#include "planner/python/options_class.h"

namespace prehend::python {
namespace {

// A model as Python holds it: pybind11 has no shared pointer to what is constant.
struct ModelHandle {
  std::shared_ptr<const TreeModel> model;
};

void bind_model(py::module_& core) {
  py::class_<ModelHandle>(core, "TreeModel", "What was learnt from earlier trials.")
      .def_property_readonly(
          "name", [](const ModelHandle& self) { return self.model->name; }, "That of its file.")
      .def_property_readonly(
          "hands", [](const ModelHandle& self) { return self.model->hands; },
          "Hands whose trials it was trained on.")
      .def_property_readonly(
          "any_hand", [](const ModelHandle& self) { return self.model->any_hand; },
          "Whether it may be used for other hands as well.")
      .def_property_readonly(
          "objects", [](const ModelHandle& self) { return self.model->objects; },
          "Objects in the training data.")
      .def_property_readonly(
          "trials", [](const ModelHandle& self) { return self.model->trials; },
          "Trials in the training data.");
  core.def("read_tree_model", [](const std::string& file) {
    return ModelHandle{std::make_shared<const TreeModel>(read_tree_model(file))};
  });
}

}  // namespace

void bind_learned_order(py::module_& core) {
  bind_model(core);
  py::class_<LearnedOrder> type = settings_class<LearnedOrder>(core);
  type.def_property(
      "model",
      [](const LearnedOrder& self) -> std::optional<ModelHandle> {
        if (!self.model) return std::nullopt;
        return ModelHandle{self.model};
      },
      [](LearnedOrder& self, const std::optional<ModelHandle>& model) {
        self.model = model ? model->model : nullptr;
      },
      "TreeModel, that of planning.load_model().");
  add_field(type, "model", "Optional[TreeModel]");
}

}  // namespace prehend::python
