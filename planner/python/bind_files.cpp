#include <cstring>
#include <pybind11/stl.h>
#include <utility>

#include "planner/python/arrays.h"
#include "planner/python/background.h"
#include "planner/python/results.h"
#include "planner/results/timings_file.h"
#include "planner/show/best_viewpoint.h"
#include "planner/show/exports/export_files.h"
#include "planner/show/exports/result_files.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/posed_grasp.h"
#include "planner/show/report/plan_report.h"
#include "planner/show/report/report_html.h"
#include "sim/base/input_error.h"

namespace prehend::python {
namespace {

using Pixels = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

Pixels pixels_of(const Image& image) {
  Pixels pixels({image.height, image.width, 3});
  std::memcpy(pixels.mutable_data(), image.rgb.data(), image.rgb.size());
  return pixels;
}

py::bytes png_in_python(const Pixels& pixels) {
  if (pixels.ndim() != 3 || pixels.shape(2) != 3) {
    throw std::invalid_argument("an array of another shape");
  }
  Image image;
  image.height = static_cast<int>(pixels.shape(0));
  image.width = static_cast<int>(pixels.shape(1));
  image.rgb.assign(pixels.data(), pixels.data() + pixels.size());
  return png_bytes(image);
}

std::string report_in_python(const PlanHandle& plan, const CallOptions& call) {
  std::string html;
  run_in_background(call, [&](const RunContext& context) {
    html = report_html(plan_report(*plan.scene, *plan.result, plan.record, kMostDetailed, context));
  });
  return html;
}

// Contents are bytes, because glTF files are binary.
std::vector<std::pair<std::string, py::bytes>> exports_in_python(const PlanHandle& plan,
                                                                 const std::string& format) {
  std::vector<ExportFile> files;
  {
    const py::gil_scoped_release no_gil;
    files = export_files(*plan.scene, *plan.result, format);
  }
  std::vector<std::pair<std::string, py::bytes>> named;
  for (const ExportFile& file : files) named.emplace_back(file.name, py::bytes(file.content));
  return named;
}

// `direction` empty: from the most telling side.
Pixels grasp_picture_in_python(const TrialHandle& trial, const std::string& title,
                               std::pair<int, int> size, const std::optional<Doubles>& direction) {
  // Arguments are converted while the GIL is held; without it no Python object may be touched.
  std::optional<Vector3> to_eye;
  if (direction) to_eye = vector_of(*direction);
  Image image;
  {
    const py::gil_scoped_release no_gil;
    const PosedGrasp posed = posed_grasp(*trial.scene, *trial.grasp, title);
    if (!to_eye) to_eye = best_viewpoint(*trial.scene, posed);
    image = grasp_picture(*trial.scene, posed, *to_eye, {size.first, size.second});
  }
  return pixels_of(image);
}

Pixels arm_picture_in_python(const TrialHandle& trial, const std::string& title,
                             std::pair<int, int> size) {
  const PosedGrasp posed = posed_grasp(*trial.scene, *trial.grasp, title);
  if (posed.arm_joints.empty()) throw InputError({.field = "grasp", .problem = "no arm holds it"});
  Image image;
  {
    const py::gil_scoped_release no_gil;
    image = arm_picture(*trial.scene, posed, {size.first, size.second});
  }
  return pixels_of(image);
}

}  // namespace

void bind_files(py::module_& core) {
  core.def("grasps_json", [](const PlanHandle& plan) {
    return py::bytes(grasps_json(*plan.scene, *plan.result, plan.record));
  });
  core.def("timings_json", [](const PlanHandle& plan, int threads) {
    return timings_json(plan.result->times, plan.result->trial_seconds, threads);
  });
  core.def("remove_earlier_results", [](const PlanHandle& plan, const std::string& folder,
                                        const std::vector<std::string>& written) {
    remove_earlier_results(folder, written, plan.scene->scene);
  });
  core.def("report_html", &report_in_python);
  core.def("export_formats", &export_names);
  core.def("export_files", &exports_in_python);
  core.def("grasp_picture", &grasp_picture_in_python);
  core.def("arm_picture", &arm_picture_in_python);
  core.def("png_bytes", &png_in_python);
  core.attr("most_detailed") = kMostDetailed;
}

}  // namespace prehend::python
