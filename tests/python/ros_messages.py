"""Messages of ROS 2 as Python classes, as strict as those that rosidl makes, for tests without ROS.

The definitions are those of Jazzy (moveit_msgs, shape_msgs, trajectory_msgs, geometry_msgs,
std_msgs, builtin_interfaces); types that no test fills have none here and cannot be set.
"""

DEFINITIONS = {
    "Time": "int32 sec, uint32 nanosec",
    "Duration": "int32 sec, uint32 nanosec",
    "Header": "Time stamp, string frame_id",
    "Point": "float64 x, float64 y, float64 z",
    "Quaternion": "float64 x, float64 y, float64 z, float64 w",
    "Pose": "Point position, Quaternion orientation",
    "JointTrajectoryPoint": "float64[] positions, float64[] velocities, float64[] accelerations, "
    "float64[] effort, Duration time_from_start",
    "JointTrajectory": "Header header, string[] joint_names, JointTrajectoryPoint[] points",
    "MultiDOFJointTrajectory": "Header header, string[] joint_names, "
    "MultiDOFJointTrajectoryPoint[] points",
    "RobotTrajectory": "JointTrajectory joint_trajectory, "
    "MultiDOFJointTrajectory multi_dof_joint_trajectory",
    "MeshTriangle": "uint32[3] vertex_indices",
    "Mesh": "MeshTriangle[] triangles, Point[] vertices",
    "CollisionObject": "Header header, Pose pose, string id, ObjectType type, "
    "SolidPrimitive[] primitives, Pose[] primitive_poses, Mesh[] meshes, Pose[] mesh_poses, "
    "Plane[] planes, Pose[] plane_poses, string[] subframe_names, Pose[] subframe_poses, "
    "byte operation",
    "PlanningSceneWorld": "CollisionObject[] collision_objects, OctomapWithPose octomap",
    "AllowedCollisionEntry": "bool[] enabled",
    "AllowedCollisionMatrix": "string[] entry_names, AllowedCollisionEntry[] entry_values, "
    "string[] default_entry_names, bool[] default_entry_values",
    "PlanningScene": "string name, RobotState robot_state, string robot_model_name, "
    "TransformStamped[] fixed_frame_transforms, AllowedCollisionMatrix allowed_collision_matrix, "
    "LinkPadding[] link_padding, LinkScale[] link_scale, ObjectColor[] object_colors, "
    "PlanningSceneWorld world, bool is_diff",
    "MoveItErrorCodes": "int32 val, string message, string source",
    "ApplyPlanningScene.Request": "PlanningScene scene",
    "ApplyPlanningScene.Response": "bool success",
    "ExecuteTrajectory.Goal": "RobotTrajectory trajectory, string[] controller_names",
    "ExecuteTrajectory.Result": "MoveItErrorCodes error_code",
}

INTEGERS = {"int32": (-(2**31), 2**31), "uint32": (0, 2**32)}
DEFAULTS = {"string": "", "bool": False, "float64": 0.0, "byte": b"\0", "int32": 0, "uint32": 0}


def check(of, value):
    """Raises where `value` is not one of the type `of`."""
    if of.endswith("]"):
        of, length = of[:-1].split("[")
        if isinstance(value, (str, bytes)) or not hasattr(value, "__len__"):
            raise TypeError(f"{of}[{length}]: {value!r}")
        if length and len(value) != int(length):
            raise ValueError(f"{of}[{length}]: {value!r}")
        for one in value:
            check(of, one)
    elif of in INTEGERS:
        least, end = INTEGERS[of]
        if not isinstance(value, int) or isinstance(value, bool) or not least <= value < end:
            raise TypeError(f"{of}: {value!r}")
    elif of in ("string", "bool", "float64"):
        if not isinstance(value, {"string": str, "bool": bool, "float64": float}[of]):
            raise TypeError(f"{of}: {value!r}")
    elif of == "byte":
        if not isinstance(value, bytes) or len(value) != 1:
            raise TypeError(f"byte: {value!r}")
    elif not isinstance(value, Message) or value.of != of:
        raise TypeError(f"{of}: {value!r}")


class Message:
    """A message of one of the definitions, each field with its default."""

    def __init__(self, of):
        fields = dict(reversed(field.split(" ")) for field in DEFINITIONS[of].split(", "))
        self.__dict__.update(of=of, fields=fields)
        for name, kind in fields.items():
            if kind.endswith("]"):
                self.__dict__[name] = []
            elif kind in DEFAULTS:
                self.__dict__[name] = DEFAULTS[kind]
            elif kind in DEFINITIONS:
                self.__dict__[name] = Message(kind)

    def __setattr__(self, name, value):
        if name not in self.fields:
            raise AttributeError(f"{self.of} has no field {name}")
        check(self.fields[name], value)
        self.__dict__[name] = value


def message_class(of):
    return lambda: Message(of)


def set_message_fields(message, values):
    """As that of rosidl_runtime_py: casts to the type of the field, and fills nested messages."""
    for name, value in values.items():
        kind = message.fields.get(name, "")
        if kind in DEFINITIONS:
            set_message_fields(getattr(message, name), value)
        elif kind.split("[")[0] in DEFINITIONS:
            made = [Message(kind.split("[")[0]) for _ in value]
            for one, of_one in zip(made, value):
                set_message_fields(one, of_one)
            setattr(message, name, made)
        elif kind in DEFAULTS:
            setattr(message, name, type(DEFAULTS[kind])(value))
        else:
            setattr(message, name, value)


class Future:
    def __init__(self, result):
        self._result = result

    def result(self):
        return self._result
