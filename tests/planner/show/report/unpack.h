// Reads what a report's page reads: its own way, so that writer and reader are two opinions.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/pose.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::test {

// RFC 4648, section 4. Throws std::invalid_argument for what is not canonical.
inline std::vector<std::uint8_t> from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  if (text.size() % 4 != 0) throw std::invalid_argument("length");
  const std::size_t padding =
      text.find('=') == std::string::npos ? 0 : text.size() - text.find('=');
  if (padding > 2) throw std::invalid_argument("padding");
  std::vector<bool> bits;
  for (std::size_t i = 0; i + padding < text.size(); ++i) {
    const std::size_t digit = digits.find(text[i]);
    if (digit == std::string::npos) throw std::invalid_argument("digit");
    for (int bit = 5; bit >= 0; --bit) bits.push_back((digit >> bit & 1U) != 0);
  }
  std::vector<std::uint8_t> bytes(bits.size() / 8);
  for (std::size_t i = 0; i < bits.size(); ++i) {
    if (i / 8 < bytes.size()) {
      bytes[i / 8] = static_cast<std::uint8_t>(2 * bytes[i / 8] + (bits[i] ? 1 : 0));
    } else if (bits[i]) {
      throw std::invalid_argument("bits beyond the last byte");
    }
  }
  return bytes;
}

// Little-endian words.
inline std::vector<std::uint32_t> words_of(const nlohmann::json& text) {
  const std::vector<std::uint8_t> bytes = from_base64(text.get<std::string>());
  if (bytes.size() % 4 != 0) throw std::invalid_argument("words");
  std::vector<std::uint32_t> words(bytes.size() / 4, 0);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    words[i / 4] |= static_cast<std::uint32_t>(bytes[i]) << 8 * (i % 4);
  }
  return words;
}

inline TriangleMesh unpacked(const nlohmann::json& packed) {
  TriangleMesh mesh;
  const std::vector<std::uint32_t> numbers = words_of(packed.at("positions"));
  const std::vector<std::uint32_t> indices = words_of(packed.at("indices"));
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    mesh.vertices.emplace_back(std::bit_cast<float>(numbers[i]),
                               std::bit_cast<float>(numbers[i + 1]),
                               std::bit_cast<float>(numbers[i + 2]));
  }
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    mesh.triangles.push_back({static_cast<int>(indices[i]), static_cast<int>(indices[i + 1]),
                              static_cast<int>(indices[i + 2])});
  }
  return mesh;
}

// A position and a quaternion x, y, z, w; null: no change.
inline Pose pose_in(const nlohmann::json& json) {
  if (json.is_null()) return Pose::Identity();
  const auto x = json.get<std::vector<double>>();
  const Eigen::Quaterniond turn(x.at(6), x.at(3), x.at(4), x.at(5));
  return pose_from(turn.normalized().toRotationMatrix(), Vector3(x[0], x[1], x[2]));
}

// The frames after each joint of a robot in a report, in its base frame.
inline std::vector<Pose> frames_in(const nlohmann::json& robot, const std::vector<double>& values) {
  std::vector<Pose> frames;
  for (const nlohmann::json& joint : robot.at("joints")) {
    const int parent = joint.at("parent");
    const double value = values.at(frames.size());
    Pose moved = Pose::Identity();
    const nlohmann::json& at = joint.at("axis");
    const Vector3 axis = at.is_null() ? Vector3::UnitZ() : Vector3(at[0], at[1], at[2]);
    if (joint.at("type") == "r") {
      moved = Pose(Eigen::AngleAxisd(value, axis));
    } else {
      moved = translation(value * axis);
    }
    const Pose X_BP = parent < 0 ? Pose::Identity() : frames.at(static_cast<std::size_t>(parent));
    frames.push_back(X_BP * pose_in(joint.at("before")) * moved * pose_in(joint.at("after")));
  }
  return frames;
}

}  // namespace prehend::test
