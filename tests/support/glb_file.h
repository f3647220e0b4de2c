// A binary glTF file taken apart as the specification has it, for tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/pose.h"

namespace prehend::test {

template <typename Number>
Number at(const std::string& bytes, std::size_t place) {
  Number number{};
  if (place + sizeof(Number) > bytes.size()) throw std::out_of_range("file ends early");
  std::memcpy(&number, bytes.data() + place, sizeof(Number));
  return number;
}

struct Glb {
  nlohmann::json document;
  std::string data;

  explicit Glb(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(at<std::uint32_t>(file, 4), 2U);
    EXPECT_EQ(at<std::uint32_t>(file, 8), file.size());
    const std::uint32_t size = at<std::uint32_t>(file, 12);
    EXPECT_EQ(at<std::uint32_t>(file, 16), 0x4E4F534AU);
    EXPECT_EQ(size % 4, 0U);
    document = nlohmann::json::parse(file.substr(20, size));  // throws for invalid UTF-8
    if (file.size() == 20 + size) return;
    EXPECT_EQ(at<std::uint32_t>(file, 20 + size), file.size() - 28 - size);
    EXPECT_EQ(at<std::uint32_t>(file, 24 + size), 0x004E4942U);
    data = file.substr(28 + size);
    EXPECT_EQ(data.size() % 4, 0U);
  }

  const nlohmann::json& entry(const char* list, const nlohmann::json& number) const {
    return document.at(list).at(number.get<std::size_t>());
  }
  const nlohmann::json& root() const { return entry("nodes", document["scenes"][0]["nodes"][0]); }
  const nlohmann::json& node(std::size_t child) const {
    return entry("nodes", root()["children"][child]);
  }
  const nlohmann::json& primitive(const nlohmann::json& node) const {
    return entry("meshes", node["mesh"])["primitives"][0];
  }
  const nlohmann::json& material(const nlohmann::json& node) const {
    return entry("materials", primitive(node)["material"]);
  }

  // Of an accessor of single-precision numbers, so many in an element.
  std::vector<float> numbers(const nlohmann::json& accessor_number, std::size_t size) const {
    const nlohmann::json& accessor = entry("accessors", accessor_number);
    const std::size_t start = entry("bufferViews", accessor["bufferView"])["byteOffset"];
    std::vector<float> numbers(size * accessor["count"].get<std::size_t>());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = at<float>(data, start + 4 * i);
    return numbers;
  }

  std::vector<std::size_t> indices(const nlohmann::json& node) const {
    const nlohmann::json& accessor = entry("accessors", primitive(node)["indices"]);
    const std::size_t start = entry("bufferViews", accessor["bufferView"])["byteOffset"];
    std::vector<std::size_t> indices(accessor["count"].get<std::size_t>());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      indices[i] = accessor["componentType"] == 5123 ? at<std::uint16_t>(data, start + 2 * i)
                                                     : at<std::uint32_t>(data, start + 4 * i);
    }
    return indices;
  }

  // In the node's frame.
  std::vector<Vector3> vectors(const nlohmann::json& node, const char* attribute) const {
    const nlohmann::json& accessor = entry("accessors", primitive(node)["attributes"][attribute]);
    const std::size_t start = entry("bufferViews", accessor["bufferView"])["byteOffset"];
    std::vector<Vector3> vectors(accessor["count"].get<std::size_t>());
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        vectors[i][static_cast<int>(k)] =
            static_cast<double>(at<float>(data, start + 12 * i + 4 * k));
      }
    }
    return vectors;
  }
};

// Of a node in its parent.
inline Pose pose_of(const nlohmann::json& node) {
  const nlohmann::json& q = node["rotation"];
  const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
  EXPECT_NEAR(rotation.norm(), 1.0, 1e-12);
  const nlohmann::json t = node.value("translation", nlohmann::json({0.0, 0.0, 0.0}));
  return pose_from(rotation.toRotationMatrix(), Vector3(t[0], t[1], t[2]));
}

}  // namespace prehend::test
