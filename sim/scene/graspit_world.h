// World files of GraspIt! as scenes (docs/reference/graspit-files.md).
#pragma once

#include <filesystem>

#include "sim/base/xml/xml_file.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_file.h"

namespace prehend {

// The scene in a world file: its first graspable body is the object, the others are obstacles; its
// first robot with a direction of approach is the hand, the robots that carry it are its arm, in
// the postures of the world; links of robots that are not connected to it are obstacles.
// Scene::notes says what was assumed or left out. `source.hand` replaces the hand. Throws
// InputError with file and line for what is broken or missing (graspit_body.h,
// graspit_world_robots.h), and for a world without a graspable body or without a hand.
Scene read_graspit_world(const XmlFile& file, const SceneSource& source = {});

// The scene in a world file, or, of a body file, a scene with the body as its object and nothing
// else in it, grasped by source.hand or kDefaultHand. Throws InputError for other files.
Scene read_graspit_scene(const XmlFile& file, const SceneSource& source = {});

// Whether `file` is one of read_graspit_scene: its name ends with .xml, its outermost element is
// <world> or <root>. Throws InputError for an .xml file that cannot be parsed.
bool is_graspit_scene(const std::filesystem::path& file);

}  // namespace prehend
