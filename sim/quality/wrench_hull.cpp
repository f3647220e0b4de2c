#include "sim/quality/wrench_hull.h"

#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include <libqhull_r/qhull_ra.h>

#include "sim/quality/start_simplex.h"

namespace prehend {
namespace {

// A stream that keeps qhull's messages in memory.
class MessageStream {
 public:
  MessageStream() : stream_(open_memstream(&text_, &size_)) {
    if (stream_ == nullptr) throw std::runtime_error("qhull: no memory for its messages");
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

// One qhull state, freed with everything it allocated.
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

// qh_getarea, with qhull's errors (a longjmp) turned into its exit code. Nothing with a destructor
// may live here.
int measure(qhT* qhull) {
  const int code = setjmp(qhull->errexit);
  if (code == 0) {
    qhull->NOerrexit = False;
    qh_getarea(qhull, qhull->facet_list);
  }
  qhull->NOerrexit = True;
  return code;
}

struct Attempt {
  int code = qh_ERRnone;
  std::string message;
  WrenchHull hull;
};

WrenchHull read(const qhT& qhull, double doubt) {
  WrenchHull hull;
  hull.status = HullStatus::solid;
  hull.volume = qhull.totvol;
  hull.min_offset = std::numeric_limits<double>::infinity();
  hull.doubt = doubt;
  // The list ends with a sentinel that has no successor. qhull's offsets are negative inside.
  for (const facetT* facet = qhull.facet_list; facet != nullptr && facet->next != nullptr;
       facet = facet->next) {
    if (-facet->offset >= hull.min_offset) continue;
    hull.min_offset = -facet->offset;
    hull.weakest = Eigen::Map<const Wrench>(facet->normal);
  }
  hull.weakest *= -hull.min_offset;
  return hull;
}

Attempt attempt(Wrenches wrenches, std::string command, double doubt) {
  MessageStream messages;
  Qhull qhull(messages.stream());
  Attempt result;
  result.code = qh_new_qhull(qhull.get(), 6, static_cast<int>(wrenches.cols()), wrenches.data(),
                             False, command.data(), nullptr, messages.stream());
  if (result.code == qh_ERRnone) result.code = measure(qhull.get());
  if (result.code == qh_ERRnone) {
    // With QJ every coordinate moved by at most JOGGLEmax; without, that is a huge constant.
    const double joggle = qhull.get()->JOGGLEmax < REALmax / 2 ? qhull.get()->JOGGLEmax : 0.0;
    result.hull = read(*qhull.get(), doubt + std::sqrt(6.0) * joggle);
  } else {
    result.message = messages.first_line();
  }
  return result;
}

}  // namespace

WrenchHull wrench_hull(const Wrenches& wrenches) {
  if (wrenches.cols() == 0) return {};
  const StartSimplex start = start_simplex(ColumnSupport(wrenches), false);
  if (start.flat) return {};
  const double doubt = kFlatness * start.scale;
  Attempt result = attempt(wrenches, "qhull Qt", doubt);
  if (result.code == qh_ERRsingular) return {};
  if (result.code != qh_ERRnone) result = attempt(wrenches, "qhull QJ", doubt);
  if (result.code != qh_ERRnone) {
    throw std::runtime_error("qhull: " + result.message + " (exit " + std::to_string(result.code) +
                             ")");
  }
  return result.hull;
}

}  // namespace prehend
