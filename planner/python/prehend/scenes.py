"""Scenes: what is to be grasped, by which hand, among what."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _core
from ._arrays import ArrayLike, FloatArray, IntArray, as_faces, as_floats, as_pose
from ._core import CompiledScene, GraspableBody, Material, StaticBody
from ._errors import InputError
from ._names import show_in

__all__ = [
    "CompiledScene",
    "GraspableBody",
    "Material",
    "Mesh",
    "Scene",
    "StaticBody",
    "compile_scene",
    "library_scene_names",
    "load_mesh",
    "load_scene",
    "make_scene",
    "scene_objects",
]

show_in(__name__, GraspableBody, Material, StaticBody)

PathLike = Union[str, "os.PathLike[str]"]


class Mesh(NamedTuple):
    """A triangle mesh. Wherever a mesh is taken, a pair (vertices, faces) and any object with these
    attributes, a trimesh.Trimesh for instance, will do as well."""

    vertices: FloatArray
    """(V, 3) [m]."""
    faces: IntArray
    """(F, 3): three vertices each, counter-clockwise seen from outside."""


#: A Mesh, a pair (vertices, faces), or an object with these attributes.
MeshLike = Any


def as_mesh(mesh: MeshLike) -> Mesh:
    """`mesh` as arrays of the right types. Raises InputError for other shapes and indices."""
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        vertices, faces = mesh.vertices, mesh.faces
    else:
        try:
            vertices, faces = mesh
        except (TypeError, ValueError):
            raise InputError(
                "must be (vertices, faces) or have these attributes",
                field="mesh",
                value=type(mesh).__name__,
            ) from None
    points = as_floats(vertices, "vertices", ("V", 3))
    return Mesh(points, as_faces(faces, len(points)))


#: A region of an object's surface: the name of a part of its mesh file, or as in a scene file,
#: {"inside": {"shape": "box", "size": [0.02, 0.05, 0.1], "pose": {...}}}.
Region = Union[str, Mapping[str, Any]]


def as_region(region: Region) -> Mapping[str, Any]:
    return {"part": region} if isinstance(region, str) else region


def load_mesh(file: PathLike, unit: str = "m") -> Mesh:
    """Reads a mesh: OBJ, STL, PLY, OFF, glTF, COLLADA, Inventor or VRML.

    Equal vertices are joined, triangles turned outward and lengths turned into metres.

    Args:
        file: its path.
        unit: of the file: "m", "cm", "mm" or "in".

    Raises:
        InputError: that names the file and what is wrong with it.
    """
    return Mesh(*_core.load_mesh(os.fsencode(file), unit))


class Scene:
    """An object to grasp, a hand, the things around them, friction.

    Made by load_scene() and make_scene(). A scene may be changed until it is compiled; a compiled
    scene does not change with it.
    """

    def __init__(self, core: "_core._Scene") -> None:
        self._core = core

    @property
    def name(self) -> str:
        """Of the scene."""
        return self._core.name

    @property
    def object(self) -> "_core.GraspableBody":
        """What is to be grasped."""
        return self._core.object

    @property
    def hand(self) -> "_core.Robot":
        """The hand that grasps."""
        return self._core.hand

    @property
    def platform(self) -> Optional[str]:
        """Name of the robots that carry the hand; None: it flies free."""
        return self._core.platform

    @property
    def notes(self) -> List[str]:
        """What was assumed about the object and repaired: one line each."""
        return self._core.notes

    @property
    def obstacles(self) -> List["_core.StaticBody"]:
        """What stands around."""
        return self._core.obstacles

    def set_pose(self, X_WO: ArrayLike) -> None:
        """Puts the object elsewhere in the world: (4, 4)."""
        self._core.set_pose(as_pose(X_WO, "X_WO"))

    def set_mass(
        self,
        mass: Optional[float] = None,
        *,
        density: Optional[float] = None,
        center_of_mass: Optional[ArrayLike] = None,
        parts: Optional[Sequence[Mapping[str, Any]]] = None,
    ) -> None:
        """States the object's mass and where it is, in place of what the scene said of them.

        Args:
            mass: of the whole [kg]; None: what follows from the densities, else 0.3.
            density: of what no part covers, or of the whole [kg/m^3].
            center_of_mass: (3,), frame O [m]; None: what follows from the parts, or that of uniform
                density.
            parts: of other densities or masses, as in a scene file (docs/reference/scene-file.md), for
                instance [{"component": 1, "density": 7800}] or [{"at": [0, 0, 0.1], "mass": 0.2}].

        Raises:
            InputError: that names the argument: for a value out of its range, a part that is not
                there, parts that overlap or weigh more than the whole.
        """
        stated: Dict[str, Any] = {"mass": mass, "density": density, "parts": parts}
        if center_of_mass is not None:
            stated["center_of_mass"] = as_floats(center_of_mass, "center_of_mass", (3,))
        given = {key: value for key, value in stated.items() if value is not None}
        self._core.set_mass(json.dumps(given, default=lambda array: np.asarray(array).tolist()))

    def set_friction(
        self, a: str, b: str, friction: float, kinetic: Optional[float] = None
    ) -> None:
        """Sets the static friction coefficient (>= 0) between two materials, and that of surfaces that
        slide; None: the same."""
        self._core.set_friction(a, b, friction, kinetic)

    def friction(self, a: str, b: str) -> float:
        """The static friction coefficient between two materials."""
        return self._core.friction(a, b)

    def mount(
        self,
        platform: PathLike,
        X_WB: Optional[ArrayLike] = None,
        *,
        hand: PathLike = "",
        start: Optional[Mapping[str, float]] = None,
    ) -> None:
        """Puts the hand on an arm: the scene's hand becomes the one that stands there.

        Args:
            platform: a name of the library (robots.library_platform_names()) or a file with robots.
            X_WB: (4, 4), the platform's base in the world; None: at the world's origin.
            hand: in place of the platform's own; "": that one.
            start: degrees of freedom by name, "ROBOT/NAME": where they start, if not where the
                robots' files say [rad or m].

        Raises:
            InputError: for an unknown name, a platform without a hand on an arm, or a start outside
                the limits.
        """
        base = np.eye(4) if X_WB is None else as_pose(X_WB, "X_WB")
        self._core.mount(os.fsencode(platform), os.fsencode(hand), base, dict(start or {}))

    def add_obstacle(
        self,
        name: str,
        mesh: MeshLike,
        X_WB: Optional[ArrayLike] = None,
        *,
        material: Union[str, Material] = Material.wood,
    ) -> None:
        """Adds a body that does not move: it can be touched and stands in the way.

        Args:
            name: for messages and files.
            mesh: in its own frame B [m].
            X_WB: (4, 4), its pose in the world; None: at its origin.
            material: of its surface.
        """
        vertices, faces = as_mesh(mesh)
        pose = np.eye(4) if X_WB is None else as_pose(X_WB, "X_WB")
        self._core.add_obstacle(name, vertices, faces, pose, str(material))

    def save(self, file: PathLike) -> None:
        """Writes a scene file (docs/reference/scene-file.md), which load_scene() and the program read. From
        then on grasps.json of this scene names that file."""
        self._core.save(os.fsencode(file))

    def __repr__(self) -> str:
        carried = f" on {self.platform}" if self.platform else ""
        return (
            f"<prehend.Scene {self.name}: {len(self.object.faces)} triangles, hand "
            f"{self.hand.name}{carried}, {len(self.obstacles)} obstacles>"
        )


def load_scene(
    scene: PathLike,
    *,
    hand: PathLike = "",
    unit: str = "",
    repair: bool = True,
    object: str = "",
    keep_out: Sequence[Region] = (),
    preferred: Sequence[Region] = (),
) -> Scene:
    """Reads a scene.

    Args:
        scene: a name of the library (scenes.library_scene_names()), a scene file (.json), or a mesh file,
            which becomes the object of a scene with nothing else in it.
        hand: replaces the scene's: a name of the library (robots.library_robot_names()) or a robot file.
        unit: of a mesh file: "m", "cm", "mm" or "in"; "": the likely one by the object's size, which
            Scene.notes says where it is not the metre.
        repair: closes small and flat holes and cracks in the object's surface if it comes from a
            mesh file, turns triangles that disagree, drops dust; Scene.notes says what.
        object: which of several objects of a scene file to grasp, by name; "": the first.
        keep_out: parts of the object that no finger may touch, in addition to those of the file.
        preferred: the same of parts of which grasps come first that touch nothing else.

    Raises:
        InputError: that names the file, the field and the value.
    """
    return Scene(
        _core.load_scene(
            os.fsencode(scene),
            os.fsencode(hand),
            unit,
            repair,
            object,
            json.dumps([as_region(region) for region in keep_out]),
            json.dumps([as_region(region) for region in preferred]),
        )
    )


def scene_objects(scene: PathLike) -> List[str]:
    """Names of the objects of a scene file that lists several; else empty.

    Raises:
        InputError: that names the file, the field and the value.
    """
    return _core.scene_objects(os.fsencode(scene))


def make_scene(
    mesh: MeshLike,
    *,
    hand: PathLike = "barrett",
    name: str = "object",
    material: Union[str, Material] = Material.plastic,
    mass: float = 0.3,
    X_WO: Optional[ArrayLike] = None,
    repair: bool = True,
) -> Scene:
    """A scene of one's own mesh, with a hand that flies free; Scene.mount() puts one on an arm.

    Equal vertices are joined and triangles turned outward, as of a mesh file.

    Args:
        mesh: in the object's frame O [m].
        hand: a name of the library or a robot file.
        name: of the object.
        material: of its surface.
        mass: [kg].
        X_WO: (4, 4), the object's pose in the world; None: at the world's origin.
        repair: as of load_scene().

    Raises:
        InputError: for a mesh that cannot be used, an unknown name, a mass that is not positive.
    """
    vertices, faces = as_mesh(mesh)
    scene = Scene(
        _core.make_scene(vertices, faces, os.fsencode(hand), name, str(material), float(mass), repair)
    )
    if X_WO is not None:
        scene.set_pose(X_WO)
    return scene


def compile_scene(scene: Scene) -> "_core.CompiledScene":
    """Makes a scene ready for trials: search structures, friction, pairs of bodies that may meet.

    Worth keeping where the same scene is planned for or evaluated more than once.

    Raises:
        InputError: for a hand or object that cannot be used, or where the object overlaps an
            obstacle or the arm starts in collision.
    """
    return _core.compile_scene(scene._core)


def as_compiled(scene: Union[Scene, "_core.CompiledScene"]) -> "_core.CompiledScene":
    """A scene as it is if it is compiled, else compiled."""
    return compile_scene(scene) if isinstance(scene, Scene) else scene


def library_scene_names() -> List[str]:
    """Names of the scenes that come with prehend."""
    return _core.library_scene_names()
