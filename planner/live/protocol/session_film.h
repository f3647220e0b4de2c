// A recorded session as an animated 3-D file.
#pragma once

#include <string>

#include "planner/live/session.h"
#include "planner/show/scene_film.h"

namespace prehend {

// How long a command that changes the session takes in the file [s].
inline constexpr double kSecondsPerCommand = 0.25;

// The session as it is now, as the next moment. The arm, where there is one, stands at its start:
// commands move the hand alone.
void add_moment(SceneFilm& film, const Session& session);

// A glTF file (.glb) of a film of a session.
std::string session_glb(const SceneFilm& film);

}  // namespace prehend
