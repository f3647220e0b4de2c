#include <cmath>
#include <variant>

#include "planner/results/contacts_file.h"
#include "sim/base/json/json_field.h"
#include "sim/quality/contact_map.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

void check_contact_list(const std::vector<Contact>& contacts) {
  for (const Contact& contact : contacts) {
    promised(contact.position.allFinite(), "the position of a contact is finite");
    promised(std::abs(contact.normal.norm() - 1.0) < 1e-3, "the normal of a contact is unit");
    promised(contact.friction >= 0.0 && std::isfinite(contact.friction), "friction is finite");
    promised(contact.torsion >= 0.0 && std::isfinite(contact.torsion), "torsion is finite");
  }
}

// What a task may be.
struct CheckTask {
  void operator()(const TaskWrenches& task) const {
    for (const Wrench& wrench : task.wrenches) {
      promised(wrench.allFinite(), "the wrenches of a task are finite");
    }
  }
  void operator()(const TaskEllipsoid& task) const {
    promised(task.axes.allFinite(), "the axes of a task are finite");
  }
  void operator()(const TaskGravity& task) const {
    promised(task.direction.allFinite() && std::isfinite(task.weight), "gravity is finite");
  }
};

void check_torques(const HandTorques& hand, std::size_t contacts) {
  const auto rows = static_cast<Eigen::Index>(contacts);
  promised(hand.limits.allFinite() && hand.jacobian.allFinite() && hand.spin.allFinite(),
           "the numbers of the hand are finite");
  promised(hand.jacobian.rows() == 3 * rows && hand.jacobian.cols() == hand.limits.size(),
           "the Jacobian has the size of contacts and joints");
}

}  // namespace

void read_contacts_file(std::string_view name, const std::string& bytes) {
  const ContactsFile file = read_contacts(JsonFile(pretended_path(name, "json"), bytes));
  check_contact_list(file.contacts);
  check_contact_list(file.surface);
  check_contacts(file.contacts, file.frame);
  if (file.task) std::visit(CheckTask{}, *file.task);
  if (file.hand) check_torques(*file.hand, file.contacts.size());
  promised(!file.external || file.external->allFinite(), "the external wrench is finite");
}

}  // namespace prehend::fuzz
