// Another engine's opinion of whether bodies collide (fcl_mesh.h).
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "sim/scene/ids.h"

namespace prehend {

class FclMesh;
struct CompiledArm;

// All bodies of an arm's scene in trees of FCL, which are built when they are first needed. Threads
// may share it.
class SecondCheck {
 public:
  // `arm` must outlive it.
  explicit SecondCheck(const CompiledArm& arm);
  ~SecondCheck();
  SecondCheck(const SecondCheck&) = delete;
  SecondCheck& operator=(const SecondCheck&) = delete;

  const FclMesh& link(LinkId link) const;
  const FclMesh& body(BodyId body) const;  // the object too

 private:
  struct Models;
  const Models& models() const;

  const CompiledArm& arm_;
  mutable std::once_flag is_built_;
  mutable std::unique_ptr<const Models> models_;
};

}  // namespace prehend
