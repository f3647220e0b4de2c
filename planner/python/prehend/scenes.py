"""Scenes: what is to be grasped, by which hand, among what."""

from __future__ import annotations

import json
import os
import tempfile
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._arrays import ArrayLike, FloatArray, IntArray, as_faces, as_finite, as_floats, as_pose
from ._core import CompiledScene, GraspableBody, Material, StaticBody
from ._errors import InputError
from ._names import show_in

__all__ = [
    "Cloud",
    "CompiledScene",
    "DepthImage",
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
    "scenes_from_views",
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


#: A region of an object's surface: the name of a part of its mesh file, a colour there ("#cc3311"),
#: or as in a scene file, {"inside": {"shape": "box", "size": [0.02, 0.05, 0.1], "pose": {...}}}.
Region = Union[str, Mapping[str, Any]]


def as_region(region: Region) -> Mapping[str, Any]:
    if not isinstance(region, str):
        return region
    return {"color": region} if region.startswith("#") else {"part": region}


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

    # By the text of its file, which names meshes and robots that came from files.
    def __reduce__(self) -> Tuple[Callable[[str], Scene], Tuple[str]]:
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "scene.json")
            self.save(file)
            with open(file, encoding="utf-8") as stream:
                return _scene_of_text, (stream.read(),)

    def __deepcopy__(self, memo: Dict[int, Any]) -> Scene:
        make, (text,) = self.__reduce__()
        return make(text)

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


def _scene_of_text(text: str) -> Scene:
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "scene.json")
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(text)
        return load_scene(file)


def load_scene(
    scene: PathLike,
    *,
    hand: PathLike = "",
    unit: str = "",
    repair: bool = True,
    object: str = "",
    keep_out: Sequence[Region] = (),
    preferred: Sequence[Region] = (),
    apart: float = 0.0,
) -> Scene:
    """Reads a scene.

    Args:
        scene: a name of the library (scenes.library_scene_names()), a scene file (.json), a mesh file,
            which becomes the object of a scene with nothing else in it, or what depth cameras saw.
        hand: replaces the scene's: a name of the library (robots.library_robot_names()) or a robot file.
        unit: of a mesh file: "m", "cm", "mm" or "in"; "": the likely one by the object's size, which
            Scene.notes says where it is not the metre.
        repair: closes small and flat holes and cracks in the object's surface if it comes from a
            mesh file, turns triangles that disagree, drops dust; Scene.notes says what.
        object: which of several objects of a scene file to grasp, by name; "": the first.
        keep_out: parts of the object that no finger may touch, in addition to those of the file.
        preferred: the same of parts of which grasps come first that touch nothing else.
        apart: how far the hand keeps from the other objects [m]; 0: fingers that close may end at
            them.

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
            apart,
        )
    )


def scene_objects(scene: PathLike, unit: str = "") -> List[str]:
    """Names of the objects of a scene file that lists several, or of the things that depth cameras
    saw; else empty.

    Args:
        scene: as of load_scene().
        unit: of a cloud of points.

    Raises:
        InputError: that names the file, the field and the value.
    """
    return _core.scene_objects(os.fsencode(scene), unit)


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


class DepthImage(NamedTuple):
    """What a depth camera saw. Its frame C: x to the right of the image, y down, z into the scene."""

    depth: ArrayLike
    """(H, W), along z: floats in metres, or whole numbers in millimetres, if `unit` is none other; 0
    and what is not finite is no reading."""
    fx: float
    """[pixels], as fy, cx and cy: pixel (u, v) sees x = (u - cx) / fx z, y = (v - cy) / fy z."""
    fy: float
    cx: float
    cy: float
    X_WC: Optional[ArrayLike] = None
    """(4, 4), the camera in the world; None: at its origin."""
    unit: Optional[float] = None
    """Metres per number; None: 1 of floats, 0.001 of whole numbers."""


class Cloud(NamedTuple):
    """Points that depth cameras saw."""

    points: ArrayLike
    """(N, 3), in a frame F [m]; what is not finite is no reading."""
    normals: Optional[ArrayLike] = None
    """(N, 3), out of the surface."""
    viewpoint: Optional[ArrayLike] = None
    """(3,), where the camera stood, frame F [m]; None: where normals face, else at the origin."""
    X_WF: Optional[ArrayLike] = None
    """(4, 4), the frame F in the world; None: the same."""


def _image_in_core(image: DepthImage, name: str) -> "_core._DepthImage":
    try:
        depth = np.asarray(image.depth)
    except ValueError as error:
        raise InputError(f"not an array of numbers: {error}", field=name + ".depth") from None
    unit = image.unit
    if unit is None:
        unit = 0.001 if np.issubdtype(depth.dtype, np.integer) else 1.0
    metres = as_floats(depth, name + ".depth", ("H", "W")) * unit
    X_WC = np.eye(4) if image.X_WC is None else as_pose(image.X_WC, name + ".X_WC")
    intrinsics = [float(value) for value in (image.fx, image.fy, image.cx, image.cy)]
    return _core._DepthImage(metres.astype(np.float32), intrinsics, X_WC)


def _cloud_in_core(cloud: Cloud, name: str) -> "_core._Cloud":
    points = as_floats(cloud.points, name + ".points", ("N", 3))
    normals = np.zeros((0, 3))
    if cloud.normals is not None:
        normals = as_floats(cloud.normals, name + ".normals", (len(points), 3))
    viewpoint = None
    if cloud.viewpoint is not None:
        viewpoint = as_finite(cloud.viewpoint, name + ".viewpoint", (3,))
    X_WF = np.eye(4) if cloud.X_WF is None else as_pose(cloud.X_WF, name + ".X_WF")
    with np.errstate(over="ignore"):
        return _core._Cloud(
            points.astype(np.float32), normals.astype(np.float32), viewpoint, X_WF
        )


def scenes_from_views(
    views: Union[DepthImage, Cloud, Sequence[Union[DepthImage, Cloud]]],
    *,
    hand: PathLike = "barrett",
    material: Union[str, Material] = Material.plastic,
    mass: float = 0.3,
    voxel: float = 0.003,
    outliers: bool = True,
    plane: bool = True,
    symmetry: bool = True,
    gap: float = 0.012,
    min_readings: int = 60,
) -> List[Scene]:
    """A scene for each thing that depth cameras saw, that with the most readings first. In each the
    thing is the object, its unseen sides completed, and the others and what they stand on are
    obstacles. planning.plan_any() takes them all.

    Args:
        views: one, or several of the same scene; images come before clouds.
        hand: a name of the library or a robot file.
        material: of the object's surface.
        mass: of the object [kg].
        voxel: edge of the grid in which shapes are found [m].
        outliers: whether readings without others near them are left out.
        plane: whether the plane on which things stand is found.
        symmetry: whether unseen sides are completed by symmetry.
        gap: things that are nearer to each other are one [m].
        min_readings: things that fewer pixels saw are left out.

    Raises:
        InputError: for what no camera sees: too few readings, depths in another unit, a focal length
            that is not positive, and where nothing stands apart from the plane.
    """
    given = [views] if isinstance(views, (DepthImage, Cloud)) else list(views)
    # Named tuples are sequences, and so are lists of them.
    images = [view for view in given if isinstance(view, DepthImage)]
    clouds = [view for view in given if isinstance(view, Cloud)]
    if len(images) + len(clouds) != len(given) or not given:
        raise InputError("must be DepthImage or Cloud, one or several", field="views")
    scenes = _core.scenes_from_views(
        [_image_in_core(image, f"views[{i}]") for i, image in enumerate(images)],
        [_cloud_in_core(cloud, f"views[{len(images) + i}]") for i, cloud in enumerate(clouds)],
        float(voxel),
        outliers,
        plane,
        symmetry,
        float(gap),
        min_readings,
        os.fsencode(hand),
        str(material),
        float(mass),
    )
    return [Scene(core) for core in scenes]


def compile_scene(scene: Scene) -> "_core.CompiledScene":
    """Makes a scene ready for trials: search structures, friction, pairs of bodies that may meet.

    Worth keeping where the same scene is planned for or evaluated more than once.

    Raises:
        InputError: for a hand or object that cannot be used, or where the object overlaps an
            obstacle or the arm starts in collision.
    """
    return _core.compile_scene(scene._core)


def as_compiled(scene: Any, hand: PathLike = "") -> "_core.CompiledScene":
    """A scene as it is if it is compiled, else compiled; of a name, a file or a mesh that of
    load_scene() or make_scene(). Raises InputError for a hand beside a scene that has its own."""
    if isinstance(scene, (Scene, _core.CompiledScene)):
        if hand:
            raise InputError(
                "must not be given beside a Scene: load it with this hand",
                field="hand",
                value=os.fsdecode(hand),
            )
        return compile_scene(scene) if isinstance(scene, Scene) else scene
    if isinstance(scene, (str, os.PathLike)):
        return compile_scene(load_scene(scene, hand=hand))
    return compile_scene(make_scene(scene, hand=hand or "barrett"))


def library_scene_names() -> List[str]:
    """Names of the scenes that come with prehend."""
    return _core.library_scene_names()
