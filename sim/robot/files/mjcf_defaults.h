// Attributes of MJCF elements, with the defaults of their classes, and the angles of the file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/xml/xml_file.h"

namespace prehend {

// What <compiler> and <default> of an MJCF file say. Elements handed to its functions must be of
// that file. Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html
class MjcfDefaults {
 public:
  // Throws InputError for classes that are nested or called wrongly.
  explicit MjcfDefaults(const XmlElement& root);

  // The element that says `attribute`: this one, or the default of its class (or, without one, of
  // `childclass`, "" for none) or of a class around that. Nothing where none does.
  std::optional<XmlElement> saying(const std::string& attribute, const XmlElement& element,
                                   const std::string& childclass) const;

  // The pose that pos and one of quat, axisangle, euler, xyaxes and zaxis say.
  Pose pose(const XmlElement& element, const std::string& childclass) const;

  // The rotation by angles in the file's unit and order.
  Matrix3 from_euler(const Vector3& angles) const;

  double angle_unit() const { return angle_unit_; }  // rad
  bool autolimits() const { return autolimits_; }
  bool fits_bounds() const { return fits_bounds_; }  // as of fitted_geom
  const std::string& mesh_folder() const { return mesh_folder_; }

 private:
  struct Class {
    std::string around;  // the class that it stands in; "" for the outermost
    std::vector<XmlElement> elements;
  };
  void read_class(const XmlElement& element, const std::string& around);
  Matrix3 rotation(const XmlElement& element, const std::string& childclass) const;

  std::map<std::string, Class> classes_;
  double angle_unit_ = 1.0;
  bool autolimits_ = true;
  bool fits_bounds_ = false;
  std::string euler_order_ = "xyz";
  std::string mesh_folder_;
};

}  // namespace prehend
