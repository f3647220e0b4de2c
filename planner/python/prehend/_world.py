"""Worlds: bodies and robots that move through time."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import List, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _core
from ._arrays import ArrayLike, FloatArray, as_finite, as_pose
from ._core import StepOutcome
from ._errors import InputError
from .robots import RobotLike, as_robot
from .scenes import Material, MeshLike, Scene, as_mesh


class WorldContact(NamedTuple):
    """Where two bodies touch in the last step."""

    a: str
    """The first body: its name, or "ROBOT/LINK"."""
    b: str
    """The second."""
    position: FloatArray
    """(3,), world, between the surfaces [m]."""
    normal: FloatArray
    """(3,), world: unit, from b into a."""
    force: FloatArray
    """(3,), world: of b on a [N]."""
    gap: float
    """Between the surfaces, at the beginning of the step [m]."""
    slip: float
    """Tangential speed at its end [m/s]."""


@dataclass(frozen=True)
class StepResult:
    """How a step ended."""

    outcome: StepOutcome
    """not_converged: moved, but the law of contact was not met to its tolerance; blocked: no step
    however short was free of penetration, and nothing moved; not_finite: velocities beyond all
    numbers, and nothing moved."""
    time: float
    """That the step took: less than asked for where bodies would have met [s]."""
    crossings: int
    """Pairs that began to cross, by no more than 0.01 mm."""
    violation: float
    """Of the law of contact, relative."""


class WorldBody:
    """A body of a world."""

    def __init__(self, core: "_core._World", index: int) -> None:
        self._core = core
        self._index = index

    @property
    def name(self) -> str:
        """What it is called."""
        return self._core.body_name(self._index)

    @property
    def mass(self) -> Optional[float]:
        """[kg]; None: it does not move."""
        return self._core.body_mass(self._index)

    @property
    def X_WB(self) -> FloatArray:
        """(4, 4): its frame in the world."""
        return self._core.body_pose(self._index)

    @X_WB.setter
    def X_WB(self, pose: ArrayLike) -> None:
        self._core.set_body_pose(self._index, as_pose(pose, "X_WB"))

    @property
    def velocity(self) -> FloatArray:
        """(3,): of its centre of mass, world [m/s]."""
        return self._core.body_velocity(self._index)[0]

    @velocity.setter
    def velocity(self, velocity: ArrayLike) -> None:
        linear = as_finite(velocity, "velocity", (3,))
        self._core.set_body_velocity(self._index, linear, self.angular_velocity)

    @property
    def angular_velocity(self) -> FloatArray:
        """(3,), world [rad/s]."""
        return self._core.body_velocity(self._index)[1]

    @angular_velocity.setter
    def angular_velocity(self, velocity: ArrayLike) -> None:
        angular = as_finite(velocity, "angular_velocity", (3,))
        self._core.set_body_velocity(self._index, self.velocity, angular)

    @property
    def force(self) -> FloatArray:
        """(3,), world: that acts at its centre of mass besides gravity, until it is set again [N]."""
        return self._core.body_force(self._index)

    @force.setter
    def force(self, force: ArrayLike) -> None:
        self._core.set_body_force(self._index, as_finite(force, "force", (3,)))

    def __repr__(self) -> str:
        return f"<prehend.WorldBody {self.name}: {'fixed' if self.mass is None else 'moves'}>"


class WorldRobot:
    """A robot of a world, with D degrees of freedom and J joints."""

    def __init__(self, core: "_core._World", index: int) -> None:
        self._core = core
        self._index = index
        self._robot: Optional["_core.Robot"] = None

    @property
    def name(self) -> str:
        """What it is called in the world."""
        return self._core.robot_name(self._index)

    @property
    def robot(self) -> "_core.Robot":
        """What it is."""
        if self._robot is None:
            self._robot = self._core.robot(self._index)
        return self._robot

    @property
    def dofs(self) -> List[str]:
        """Names of its degrees of freedom."""
        return self.robot.dofs

    @property
    def positions(self) -> FloatArray:
        """(D,): values of the degrees of freedom [rad or m]. Setting them moves the robot there; its
        joints follow, whatever their clutches have slipped."""
        return self._core.positions(self._index)

    @positions.setter
    def positions(self, positions: ArrayLike) -> None:
        values = as_finite(positions, "positions", (len(self.dofs),))
        self._core.set_positions(self._index, values)

    @property
    def rates(self) -> FloatArray:
        """(D,): of the degrees of freedom [rad/s or m/s]."""
        return self._core.rates(self._index)

    @rates.setter
    def rates(self, rates: ArrayLike) -> None:
        self._core.set_rates(self._index, as_finite(rates, "rates", (len(self.dofs),)))

    @property
    def joints(self) -> FloatArray:
        """(J,): values of the joints, with what clutches have slipped [rad or m]."""
        return self._core.joints(self._index)

    @property
    def X_WB(self) -> FloatArray:
        """(4, 4): its base in the world."""
        return self._core.base(self._index)

    @X_WB.setter
    def X_WB(self, pose: ArrayLike) -> None:
        self._core.set_base(self._index, as_pose(pose, "X_WB"))

    @property
    def efforts(self) -> FloatArray:
        """(D,): that act on the degrees of freedom besides the drives, until they are set again; the
        last ones of its controller, after a run [N m or N]."""
        return self._core.efforts(self._index)

    @efforts.setter
    def efforts(self, efforts: ArrayLike) -> None:
        self._core.set_efforts(self._index, as_finite(efforts, "efforts", (len(self.dofs),)))

    @property
    def max_efforts(self) -> FloatArray:
        """(D,): the largest of each degree of freedom: of its joints as the robot's file states them,
        or what presses with 15 N at its farthest link [N m or N]."""
        return self._core.max_efforts(self._index)

    @property
    def drives(self) -> List["_core.Drive"]:
        """What moves its degrees of freedom. The list is a copy: set it to change them."""
        return self._core.drives(self._index)

    @drives.setter
    def drives(self, drives: Sequence["_core.Drive"]) -> None:
        self._core.set_drives(self._index, list(drives))

    def state(self, time: float = 0.0, step: float = 2.5e-3) -> "_core.ControlState":
        """What a controller is told of it."""
        return _core.control_state(self._core, self._index, time, step)

    def __repr__(self) -> str:
        return f"<prehend.WorldRobot {self.name}: {len(self.dofs)} degrees of freedom>"


class World:
    """Bodies that fall, slide and are grasped, and robots that drives and controllers move.

        world = dynamics.World()
        arm = world.add_robot("ur5e")
        arm.rates = [1, 0, 0, 0, 0, 0]
        world.step()

    Bodies must not overlap. While a thread steps the world, no other may use it: RuntimeError.
    """

    def __init__(self, gravity: ArrayLike = (0.0, 0.0, -9.81)) -> None:
        self._core = _core._World()
        self.gravity = as_finite(gravity, "gravity", (3,))

    @property
    def gravity(self) -> FloatArray:
        """(3,), world [m/s^2]."""
        return self._core.gravity()

    @gravity.setter
    def gravity(self, gravity: ArrayLike) -> None:
        self._core.set_gravity(as_finite(gravity, "gravity", (3,)))

    @property
    def robots(self) -> List[WorldRobot]:
        """In the order in which they were added."""
        return [WorldRobot(self._core, i) for i in range(self._core.robots())]

    @property
    def bodies(self) -> List[WorldBody]:
        """In the order in which they were added."""
        return [WorldBody(self._core, i) for i in range(self._core.bodies())]

    @property
    def contacts(self) -> List[WorldContact]:
        """Of the last step."""
        return [WorldContact(*contact) for contact in self._core.contacts()]

    @property
    def energy(self) -> float:
        """Kinetic and potential, of all that moves [J]."""
        return self._core.energy()

    def add_robot(
        self,
        robot: RobotLike,
        X_WB: Optional[ArrayLike] = None,
        *,
        positions: Optional[ArrayLike] = None,
        name: Optional[str] = None,
    ) -> WorldRobot:
        """Adds a robot, at rest.

        Args:
            robot: a Robot, the name of one or of a platform, or a robot file.
            X_WB: (4, 4), its base in the world; None: at the world's origin. The base does not move.
            positions: (D,), of its degrees of freedom; None: Robot.initial [rad or m].
            name: in the world; None: the robot's own.

        Raises:
            InputError: also for a robot whose joints move no mass.
        """
        body = as_robot(os.fspath(robot) if isinstance(robot, os.PathLike) else robot)
        dofs = body.initial if positions is None else positions
        index = self._core.add_robot(
            body,
            body.name if name is None else name,
            np.eye(4) if X_WB is None else as_pose(X_WB, "X_WB"),
            as_finite(dofs, "positions", (len(body.dofs),)),
        )
        return WorldRobot(self._core, index)

    def add_body(
        self,
        name: str,
        mesh: MeshLike,
        X_WB: Optional[ArrayLike] = None,
        *,
        mass: Optional[float] = None,
        material: Union[str, Material] = Material.plastic,
        restitution: float = 0.0,
    ) -> WorldBody:
        """Adds a body, at rest.

        Args:
            name: for messages and contacts.
            mesh: in its own frame B [m]; its mass fills what it encloses evenly.
            X_WB: (4, 4), its pose in the world; None: at its origin.
            mass: [kg]; None: it does not move.
            material: of its surface.
            restitution: part of the velocity of an impact that it bounces with, 0 to 1; of two
                bodies, the larger counts.
        """
        if not 0.0 <= restitution <= 1.0:
            raise InputError("must be from 0 to 1", field="restitution", value=str(restitution))
        vertices, faces = as_mesh(mesh)
        pose = np.eye(4) if X_WB is None else as_pose(X_WB, "X_WB")
        weight = None if mass is None else float(mass)
        index = self._core.add_body(name, vertices, faces, pose, str(material), weight, restitution)
        return WorldBody(self._core, index)

    def add_bodies(self, scene: Scene) -> List[WorldBody]:
        """Adds the object of a scene, which moves, and its obstacles, which do not, and takes over its
        friction. The scene's hand and arm are not added."""
        before = self._core.bodies()
        self._core.add_bodies(scene._core)
        return self.bodies[before:]

    def set_friction(
        self, a: str, b: str, friction: float, kinetic: Optional[float] = None
    ) -> None:
        """Sets the static friction coefficient (>= 0) between two materials, and that of surfaces that
        slide; None: the same."""
        self._core.set_friction(a, b, friction, kinetic)

    def step(self, longest: float = 2.5e-3) -> StepResult:
        """Moves the world on by at most `longest`, 1e-5 to 0.1 [s]. The same world gives
        the same bytes.

        Raises:
            InputError: for a world that cannot be stepped, such as one in which bodies overlap.
        """
        outcome, time, crossings, violation = self._core.step(float(longest))
        return StepResult(StepOutcome(outcome), time, crossings, violation)

    def copy(self) -> "World":
        """Another world in the same state."""
        other = World.__new__(World)
        other._core = self._core.copy()
        return other

    def __repr__(self) -> str:
        return f"<prehend.World: {self._core.robots()} robots, {self._core.bodies()} bodies>"


#: A WorldRobot, its number in World.robots, or its name.
RobotOfWorld = Union[WorldRobot, int, str]


def number_of_robot(world: World, robot: RobotOfWorld) -> int:
    """The number of a robot of the world."""
    robots = world.robots
    if isinstance(robot, WorldRobot):
        if robot._core is not world._core:
            raise InputError("is of another world", field="robot", value=robot.name)
        return robot._index
    if isinstance(robot, str):
        found = [one._index for one in robots if one.name == robot]
        if len(found) != 1:
            problem = "is there more than once" if found else "the world has no such robot"
            raise InputError(problem, field="robot", value=robot)
        return found[0]
    if not 0 <= robot < len(robots):
        raise InputError("the world has no such robot", field="robot", value=str(robot))
    return int(robot)
