#include "sim/robot/files/srdf_file.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "sim/base/index.h"
#include "sim/robot/files/hand_split.h"

namespace prehend {
namespace {

constexpr std::size_t kMostGroups = 1000;

class SrdfReader {
 public:
  SrdfReader(const XmlFile& file, JointTree& tree) : root_(file.root()), tree_(tree) {
    if (root_.name() != "robot") root_.fail("the outermost element must be <robot>");
    for (std::size_t l = 0; l < tree.links.size(); ++l) {
      link_of_.emplace(tree.links[l].name, static_cast<int>(l));
    }
    carried_by_.assign(tree.links.size(), -1);
    for (std::size_t j = 0; j < tree.joints.size(); ++j) {
      joint_of_.emplace(tree.joints[j].name, static_cast<int>(j));
      carried_by_[index(tree.joints[j].child)] = static_cast<int>(j);
    }
    for (const XmlElement& group : root_.children("group")) {
      groups_.emplace(group.text("name"), group);
    }
  }

  std::optional<int> read();

 private:
  void read_exempt_pairs();
  std::optional<int> read_end_effector();
  void read_states(const std::string& hand_group);
  bool start_from(const XmlElement& state);
  void gather(const std::string& group, const XmlElement& asked, std::set<std::string>& seen,
              std::vector<int>& links);
  void add_chain(const XmlElement& chain, std::vector<int>& links);
  std::optional<int> link_called(const std::string& name);

  XmlElement root_;
  JointTree& tree_;
  std::map<std::string, int> link_of_;
  std::map<std::string, int> joint_of_;
  std::vector<int> carried_by_;
  std::map<std::string, XmlElement> groups_;
  std::set<std::string> missing_;
};

std::optional<int> SrdfReader::link_called(const std::string& name) {
  const auto found = link_of_.find(name);
  if (found != link_of_.end()) return found->second;
  missing_.insert(name);
  return std::nullopt;
}

void SrdfReader::read_exempt_pairs() {
  for (const XmlElement& pair : root_.children("disable_collisions")) {
    const std::optional<int> a = link_called(pair.text("link1"));
    const std::optional<int> b = link_called(pair.text("link2"));
    if (a && b && *a != *b) tree_.exempt_pairs.emplace_back(*a, *b);
  }
}

// The links from the tip up to the base, without the base.
void SrdfReader::add_chain(const XmlElement& chain, std::vector<int>& links) {
  const std::optional<int> base = link_called(chain.text("base_link"));
  const std::optional<int> tip = link_called(chain.text("tip_link"));
  if (!base || !tip) return;
  for (int link = *tip; link != *base;) {
    links.push_back(link);
    const int joint = carried_by_[index(link)];
    if (joint < 0) chain.fail("does not lead from its base to its tip", chain.text("tip_link"));
    link = tree_.joints[index(joint)].parent;
  }
}

void SrdfReader::gather(const std::string& group, const XmlElement& asked,
                        std::set<std::string>& seen, std::vector<int>& links) {
  const auto found = groups_.find(group);
  if (found == groups_.end()) asked.fail("no group of this name", group);
  if (!seen.insert(group).second) return;
  if (seen.size() > kMostGroups) asked.fail("more groups inside each other than 1000", group);
  for (const XmlElement& part : found->second.children()) {
    if (part.name() == "group") gather(part.text("name"), part, seen, links);
    if (part.name() == "chain") add_chain(part, links);
    if (part.name() == "link") {
      if (const auto link = link_called(part.text("name"))) links.push_back(*link);
    }
    if (part.name() == "joint") {
      const auto joint = joint_of_.find(part.text("name"));
      if (joint == joint_of_.end()) {
        missing_.insert(part.text("name"));
      } else {
        links.push_back(tree_.joints[index(joint->second)].child);
      }
    }
  }
}

std::optional<int> SrdfReader::read_end_effector() {
  const std::vector<XmlElement> effectors = root_.children("end_effector");
  if (effectors.empty()) return std::nullopt;
  if (effectors.size() > 1) {
    tree_.notes.push_back("the SRDF file names several end effectors: none is taken as the hand");
    return std::nullopt;
  }
  std::set<std::string> seen;
  std::vector<int> links;
  gather(effectors.front().text("group"), effectors.front(), seen, links);
  if (links.empty()) return std::nullopt;
  return carrier_of_all(tree_, links);
}

bool SrdfReader::start_from(const XmlElement& state) {
  for (const XmlElement& value : state.children("joint")) {
    const auto joint = joint_of_.find(value.text("name"));
    if (joint == joint_of_.end()) {
      missing_.insert(value.text("name"));
      continue;
    }
    TreeJoint& started = tree_.joints[index(joint->second)];
    const double initial = value.number("value");
    if (started.type == TreeJointType::fixed || started.mimic) continue;
    if (initial < started.lower || initial > started.upper) {
      tree_.notes.push_back("SRDF file, " + value.place() + ": outside the limits of joint " +
                            started.name + ", which starts elsewhere");
      continue;
    }
    started.initial = initial;
  }
  return true;
}

void SrdfReader::read_states(const std::string& hand_group) {
  const std::vector<XmlElement> states = root_.children("group_state");
  const auto take = [&](const std::vector<std::string>& names, bool of_hand) {
    for (const std::string& name : names) {
      for (const XmlElement& state : states) {
        if (state.text("name") != name) continue;
        if ((state.text("group") == hand_group) != of_hand) continue;
        start_from(state);
        tree_.notes.push_back("starts in the state " + name + " of the SRDF file's group " +
                              state.text("group"));
        return;
      }
    }
  };
  take({"open", "Open", "opened"}, true);
  take({"ready", "home", "Home", "default"}, false);
}

std::optional<int> SrdfReader::read() {
  read_exempt_pairs();
  const std::optional<int> hand = read_end_effector();
  std::string hand_group;
  if (hand) hand_group = root_["end_effector"].text("group");
  read_states(hand_group);
  if (!missing_.empty()) {
    tree_.notes.push_back(
        "the SRDF file names links or joints that the robot does not have: " + *missing_.begin() +
        (missing_.size() > 1 ? " and others" : std::string()));
  }
  return hand;
}

}  // namespace

std::optional<int> read_srdf(const XmlFile& file, JointTree& tree) {
  return SrdfReader(file, tree).read();
}

}  // namespace prehend
