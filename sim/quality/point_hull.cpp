#include "sim/quality/point_hull.h"

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>

#include <libqhull_r/qhull_ra.h>

namespace prehend {
namespace {

// A stream that keeps qhull's messages in memory.
class MessageStream {
 public:
  MessageStream() : stream_(open_memstream(&text_, &size_)) {
    if (stream_ == nullptr) throw std::bad_alloc();
  }
  MessageStream(const MessageStream&) = delete;
  MessageStream& operator=(const MessageStream&) = delete;
  ~MessageStream() {
    std::fclose(stream_);
    std::free(text_);
  }

  std::FILE* stream() { return stream_; }

  // The first line that says something.
  std::string first_line() {
    std::fflush(stream_);
    const std::string all(text_, size_);
    const auto start = all.find_first_not_of(" \n");
    return start == std::string::npos ? "no message"
                                      : all.substr(start, all.find('\n', start) - start);
  }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* stream_ = nullptr;
};

// One qhull state, freed with everything it allocated. qhull reports an error by a longjmp to
// `errexit` while NOerrexit is false. That target is valid only within the function that has called
// setjmp, so NOerrexit is true at all other times.
class Qhull {
 public:
  explicit Qhull(std::FILE* messages) : state_(std::make_unique<qhT>()) {
    qh_zero(state_.get(), messages);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;
  ~Qhull() {
    state_->NOerrexit = True;
    qh_freeqhull(state_.get(), !qh_ALL);
    int still_used = 0;
    int total = 0;
    qh_memfreeshort(state_.get(), &still_used, &total);
  }

  qhT* get() { return state_.get(); }

 private:
  std::unique_ptr<qhT> state_;
};

// qh_getarea, which computes the volume, with qhull's errors (a longjmp) turned into its exit code.
// No object with a destructor may be created in this function: a longjmp past a destructor is
// undefined behaviour.
int measure(qhT* qhull) {
  const int code = setjmp(qhull->errexit);
  if (code == 0) {
    qhull->NOerrexit = False;
    qh_getarea(qhull, qhull->facet_list);
  }
  qhull->NOerrexit = True;
  return code;
}

// The list of facets ends with a sentinel that has no successor.
template <typename Use>
void each_facet(qhT& qhull, Use use) {
  for (facetT* facet = qhull.facet_list; facet != nullptr && facet->next != nullptr;
       facet = facet->next) {
    use(*facet);
  }
}

// A facet of qhull is normal . x + offset <= 0, where PointHull has normal . x <= offset: the sign
// of the offset changes.
void read_facets(qhT& qhull, PointHull& hull) {
  Eigen::Index count = 0;
  each_facet(qhull, [&](const facetT&) { ++count; });
  const Eigen::Index dimension = qhull.hull_dim;
  hull.normals.resize(dimension, count);
  hull.offsets.resize(count);
  hull.corners.resize(dimension, count);
  Eigen::Index column = 0;
  each_facet(qhull, [&](const facetT& facet) {
    hull.normals.col(column) = Eigen::Map<const Eigen::VectorXd>(facet.normal, dimension);
    hull.offsets[column] = -facet.offset;
    const setT* corners = facet.vertices;
    for (Eigen::Index i = 0; i < dimension; ++i) {
      const auto* vertex = static_cast<const vertexT*>(corners->e[i].p);
      hull.corners(i, column) = qh_pointid(&qhull, vertex->point);
    }
    ++column;
  });
}

}  // namespace

PointHull point_hull(const Eigen::MatrixXd& points, HullInput input) {
  PointHull hull;
  if (points.cols() <= points.rows()) return hull;
  // Equal points are flat as well, but qhull reports another error for them than for flat ones.
  if ((points.colwise() - points.col(0)).isZero(0.0)) return hull;
  // qhull takes the points one after the other, which is the layout of the columns. It may change
  // them, hence the copy. Option Qt divides facets with more corners than dimensions into
  // simplices. Facets of joggled points (QJ) are simplices already.
  Eigen::MatrixXd copy = points;
  std::string command = input == HullInput::joggled ? "qhull QJ" : "qhull Qt";
  MessageStream messages;
  Qhull qhull(messages.stream());
  int code = qh_new_qhull(qhull.get(), static_cast<int>(copy.rows()), static_cast<int>(copy.cols()),
                          copy.data(), False, command.data(), nullptr, messages.stream());
  // qhull's exit codes: none is success, singular a flat set of points; all others are failures.
  if (code == qh_ERRnone) code = measure(qhull.get());
  if (code == qh_ERRsingular) return hull;
  if (code == qh_ERRmem) throw std::bad_alloc();
  if (code != qh_ERRnone) {
    hull.status = PointHullStatus::failed;
    hull.message = messages.first_line() + " (exit " + std::to_string(code) + ")";
    return hull;
  }
  hull.status = PointHullStatus::solid;
  hull.volume = qhull.get()->totvol;
  hull.reach = points.colwise().norm().maxCoeff();
  // JOGGLEmax is a huge constant (REALmax) where the points were not joggled.
  hull.joggle = qhull.get()->JOGGLEmax < REALmax / 2 ? qhull.get()->JOGGLEmax : 0.0;
  read_facets(*qhull.get(), hull);
  return hull;
}

}  // namespace prehend
