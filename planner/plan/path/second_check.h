// Another engine's opinion of whether bodies collide (fcl_mesh.h).
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "sim/base/pose.h"
#include "sim/scene/ids.h"

namespace prehend {

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

  // Whether the surfaces of two bodies cross. X_BA and X_BC: their poses in the platform's base
  // frame. A body wholly inside another crosses it nowhere.
  bool links_cross(LinkId a, const Pose& X_BA, LinkId c, const Pose& X_BC) const;
  bool body_crosses(BodyId a, const Pose& X_BA, LinkId c, const Pose& X_BC) const;
  // The same of two bodies, of which the second is the object, where a hand has taken it.
  bool object_crosses(const Pose& X_BO, LinkId c, const Pose& X_BC) const;
  bool object_crosses(const Pose& X_BO, BodyId c, const Pose& X_BC) const;

 private:
  struct Models;
  const Models& models() const;

  const CompiledArm& arm_;
  mutable std::once_flag is_built_;
  mutable std::unique_ptr<const Models> models_;
};

}  // namespace prehend
