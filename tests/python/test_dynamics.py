"""Tests of worlds and controllers in Python: closed forms, errors, exceptions, threads, signals."""

import gc
import signal
import threading
import unittest
import weakref

import numpy as np

import prehend
from prehend import dynamics, planning, robots

BENT = np.array([0.2, -1.2, 1.4, 0.3, 0.7, 0.1])
STEP = 2.5e-3


def box_mesh(x, y, z):
    vertices = np.array([[i, j, k] for i in (-x, x) for j in (-y, y) for k in (-z, z)]) / 2.0
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return vertices, np.array([[q[0], q[i], q[i + 1]] for q in quads for i in (1, 2)])


def moved(x, y, z):
    pose = np.eye(4)
    pose[:3, 3] = (x, y, z)
    return pose


def world_with_arm():
    world = dynamics.World()
    return world, world.add_robot("ur5e", positions=BENT)


class Worlds(unittest.TestCase):
    def test_a_body_falls_and_lies_on_another(self):
        world = dynamics.World()
        table = world.add_body("table", box_mesh(1, 1, 0.1), moved(0, 0, -0.05), material="wood")
        cube = world.add_body("cube", box_mesh(0.1, 0.1, 0.1), moved(0, 0, 0.06), mass=2.0)
        self.assertIsNone(table.mass)
        self.assertEqual(cube.mass, 2.0)
        for _ in range(200):
            self.assertEqual(world.step(STEP).outcome, "moved")
        self.assertAlmostEqual(cube.X_WB[2, 3], 0.05, delta=2e-4)
        self.assertLess(np.linalg.norm(cube.velocity), 1e-6)
        self.assertEqual({frozenset((c.a, c.b)) for c in world.contacts}, {frozenset(("table", "cube"))})
        force = sum((c.force if c.a == "cube" else -c.force) for c in world.contacts)
        np.testing.assert_allclose(force, [0, 0, 2.0 * 9.81], atol=1e-6)

    def test_bodies_are_thrown_and_pushed(self):
        world = dynamics.World(gravity=(0, 0, 0))
        cube = world.add_body("cube", box_mesh(0.1, 0.1, 0.1), mass=2.0)
        cube.velocity = [1, 0, 0]
        cube.angular_velocity = [0, 0, 2]
        cube.force = [0, 4, 0]
        for _ in range(10):
            world.step(0.01)
        np.testing.assert_allclose(cube.velocity, [1, 0.2, 0], atol=1e-12)
        np.testing.assert_allclose(cube.angular_velocity, [0, 0, 2], atol=1e-12)
        self.assertAlmostEqual(cube.X_WB[0, 3], 0.1, delta=1e-12)
        self.assertAlmostEqual(world.energy, 0.5 * 2 * 1.04 + 0.5 * 2.0 * 0.01 / 6 * 4, delta=1e-9)

    def test_bodies_of_a_scene(self):
        scene = prehend.make_scene(box_mesh(0.1, 0.1, 0.1), mass=0.5, X_WO=moved(0, 0, 0.0501))
        scene.add_obstacle("table", box_mesh(1, 1, 0.1), moved(0, 0, -0.05))
        scene.set_friction("plastic", "wood", 0.5, kinetic=0.3)
        world = dynamics.World()
        cube, table = world.add_bodies(scene)
        self.assertEqual((cube.name, cube.mass, table.mass), ("object", 0.5, None))
        cube.velocity = [1, 0, 0]
        start = cube.X_WB[0, 3]
        for _ in range(400):
            world.step(1e-3)
        # It slides v^2 / (2 mu g) far: the kinetic coefficient counts.
        way = cube.X_WB[0, 3] - start
        self.assertAlmostEqual(way, 1 / (2 * 0.3 * 9.81), delta=0.01)
        self.assertLess(np.linalg.norm(cube.velocity), 1e-6)

    def test_the_same_world_moves_in_the_same_way(self):
        world, arm = world_with_arm()
        arm.rates = 0.1 * np.arange(6)
        other = world.copy()
        for _ in range(20):
            world.step()
            other.step()
        self.assertEqual(arm.positions.tobytes(), other.robots[0].positions.tobytes())
        arm.positions = BENT
        self.assertNotEqual(arm.positions.tobytes(), other.robots[0].positions.tobytes())
        np.testing.assert_array_equal(arm.positions, BENT)

    def test_drives_hold_what_the_file_states(self):
        world = dynamics.World(gravity=(0, 0, 0))
        hand = world.add_robot("barrett")
        gains = dynamics.stated_gains(hand)
        np.testing.assert_array_equal(gains.stiffness, [100, 100, 100, 100])
        goal = dynamics.set_points("barrett", "spread_45")
        hand.drives = dynamics.pd_drives(hand, gains, goal)
        self.assertEqual(hand.drives[1].max_effort, hand.max_efforts[1])
        for _ in range(400):
            world.step()
        np.testing.assert_allclose(hand.positions, goal, atol=1e-6)
        self.assertEqual(hand.joints.shape, (8,))


class Control(unittest.TestCase):
    def test_an_arm_stands_where_its_weight_is_compensated(self):
        world, arm = world_with_arm()
        run = dynamics.run_controlled(world, dynamics.gravity_compensation(), seconds=0.5)
        self.assertEqual((run.outcome, run.steps, run.why), ("finished", 200, ""))
        self.assertAlmostEqual(run.time, 0.5, delta=1e-9)
        np.testing.assert_allclose(arm.positions, BENT, atol=1e-9)

    def test_a_function_controls_as_the_library_does(self):
        world, arm = world_with_arm()
        goal = BENT + 0.1
        gains = dynamics.critically_damped(arm, 3.0)
        seen = []

        def pd(state):
            seen.append((state.time, state.step, state.gravity.tolist()))
            return gains.stiffness * (goal - state.positions) - gains.damping * state.rates

        other = world.copy()
        run = dynamics.run_controlled(world, {arm: pd}, seconds=0.3)
        native = dynamics.pd_controller(other.robots[0], gains, goal)
        dynamics.run_controlled(other, {0: native}, seconds=0.3)
        np.testing.assert_allclose(arm.positions, other.robots[0].positions, rtol=0, atol=1e-12)
        self.assertEqual(len(seen), run.steps)
        self.assertEqual(seen[0], (0.0, STEP, [0.0, 0.0, -9.81]))
        self.assertTrue(0.3 - STEP - 1e-9 < seen[-1][0] < 0.3)

    def test_controllers_answer_outside_of_runs(self):
        world, arm = world_with_arm()
        state = arm.state()
        self.assertEqual(state.positions.shape, (6,))
        self.assertEqual(state.joints.shape, (6,))
        weight = dynamics.gravity_compensation()(state)
        twice = dynamics.sum_of(dynamics.gravity_compensation(), lambda s: weight)(state)
        np.testing.assert_allclose(twice, 2 * weight, atol=1e-12)
        arm.positions = BENT + 1.0  # a state is a copy
        np.testing.assert_array_equal(state.positions, BENT)

    def test_computed_torque_follows_a_function_of_time(self):
        world, arm = world_with_arm()

        def motion(time):
            return BENT + 0.1 * (1 - np.cos(3 * max(time, 0.0))) * np.ones(6)

        controller = dynamics.computed_torque(arm, motion, 3.0)
        dynamics.run_controlled(world, {"ur5e": controller}, seconds=0.5)
        np.testing.assert_allclose(arm.positions, motion(0.5), atol=2e-4)

    def test_a_wrist_on_springs_stays_where_it_is(self):
        world, arm = world_with_arm()
        robot = arm.robot
        X_WT = robots.joint_poses(robot, arm.joints)[robot.tip_joint]
        X_WT[0, 3] += 0.05
        spring = dynamics.wrist_impedance(arm, X_WT, stiffness=500)
        dynamics.run_controlled(world, spring, seconds=2.0, step=1e-3)
        reached = robots.joint_poses(robot, arm.joints)[robot.tip_joint]
        np.testing.assert_allclose(reached, X_WT, atol=1e-3)

    def test_a_path_is_followed(self):
        world, arm = world_with_arm()
        path = planning.Path(
            joints=arm.dofs[:2],
            times=np.array([0.0, 0.5]),
            positions=np.array([BENT[:2], BENT[:2] + 0.2]),
            velocities=np.zeros((2, 2)),
            segments=[],
            lift="not_asked",
        )
        motion = dynamics.motion_along(arm, path)
        np.testing.assert_allclose(motion(0.25), BENT + [0.1, 0.1, 0, 0, 0, 0], atol=1e-12)
        np.testing.assert_allclose(motion(9.0), BENT + [0.2, 0.2, 0, 0, 0, 0], atol=1e-12)
        dynamics.run_controlled(world, dynamics.computed_torque(arm, motion), seconds=0.6)
        np.testing.assert_allclose(arm.positions, motion(0.6), atol=1e-3)

    def test_a_watcher_ends_the_run(self):
        world, _ = world_with_arm()
        run = dynamics.run_controlled(
            world,
            dynamics.gravity_compensation(),
            stops=lambda time, now: now is world and time > 0.0999,
        )
        self.assertEqual((run.outcome, run.steps), ("stopped", 40))

    def test_two_robots_have_a_controller_each(self):
        world, arm = world_with_arm()
        other = world.add_robot("ur5e", moved(0, 3, 0), positions=BENT, name="other")
        weight = dynamics.gravity_compensation()
        dynamics.run_controlled(world, {"other": weight}, seconds=0.1)
        np.testing.assert_allclose(other.positions, BENT, atol=1e-9)
        self.assertGreater(np.abs(arm.positions - BENT).max(), 1e-3)
        with self.assertRaisesRegex(prehend.InputError, "controllers: must say which robot"):
            dynamics.run_controlled(world, weight)
        with self.assertRaisesRegex(prehend.InputError, "robot: the world has no such robot .third"):
            dynamics.run_controlled(world, {"third": weight})
        with self.assertRaisesRegex(prehend.InputError, "robot: is of another world"):
            dynamics.run_controlled(world_with_arm()[0], {arm: weight})


class Failing(unittest.TestCase):
    def setUp(self):
        self.world, self.arm = world_with_arm()
        self.weight = dynamics.gravity_compensation()

    def test_an_exception_ends_the_run_and_is_passed_on(self):
        class OwnError(Exception):
            pass

        def fails(state):
            if state.time > 0.0999:
                raise OwnError("enough")
            return self.weight(state)

        for controller in (fails, dynamics.sum_of(fails)):
            with self.assertRaisesRegex(OwnError, "enough"):
                dynamics.run_controlled(self.world, controller)
        np.testing.assert_allclose(self.arm.positions, BENT, atol=1e-9)
        # The world goes on from there.
        self.assertEqual(dynamics.run_controlled(self.world, self.weight, seconds=0.1).outcome, "finished")
        with self.assertRaises(ZeroDivisionError):
            dynamics.run_controlled(self.world, self.weight, stops=lambda time, world: 1 / 0)

    def test_what_is_not_a_number_ends_the_run(self):
        def fails(state):
            return self.weight(state) + (np.nan if state.time > 0.0999 else 0.0)

        run = dynamics.run_controlled(self.world, fails)
        self.assertEqual((run.outcome, run.steps), ("not_a_number", 40))
        self.assertAlmostEqual(run.time, 0.1, delta=1e-9)
        self.assertEqual(
            run.why, "ur5e: the controller answered an effort that is not a number at 0.1 s"
        )
        self.assertTrue(np.isfinite(self.arm.positions).all())

    def test_another_number_of_efforts_ends_the_run(self):
        run = dynamics.run_controlled(self.world, lambda state: np.zeros(5))
        self.assertEqual(run.outcome, "wrong_size")
        self.assertEqual(run.why, "ur5e: the controller answered 5 efforts for 6 at 0 s")
        self.assertEqual(dynamics.run_controlled(self.world, lambda state: []).outcome, "wrong_size")

    def test_what_is_no_row_of_numbers_is_refused(self):
        for answer, words in (
            (None, "NoneType"),
            ("no", "str"),
            ([[1], [2, 3]], "list"),
            (np.zeros((6, 1)), r"shape \(6, 1\)"),
        ):
            with self.subTest(words), self.assertRaisesRegex(
                prehend.InputError, f"ur5e: controller: must answer with .*{words}"
            ):
                dynamics.run_controlled(self.world, lambda state: answer)
        with self.assertRaisesRegex(prehend.InputError, "controller: must be a controller"):
            dynamics.run_controlled(self.world, 3)

    def test_motions_and_gains_name_their_size(self):
        gains = dynamics.critically_damped(self.arm, 3.0)
        with self.assertRaisesRegex(prehend.InputError, r"motion: must have the shape \(6,\)"):
            dynamics.pd_controller(self.arm, gains, np.zeros(5))
        with self.assertRaisesRegex(prehend.InputError, r"stiffness: must have the shape \(6,\)"):
            dynamics.pd_controller(self.arm, ([1, 2], gains.damping), BENT)
        with self.assertRaisesRegex(prehend.InputError, "damping: must not be negative"):
            dynamics.pd_controller(self.arm, (gains.stiffness, -gains.damping), BENT)
        short = dynamics.computed_torque(self.arm, lambda time: np.zeros(5))
        with self.assertRaisesRegex(prehend.InputError, "motion: must have a number for each of 6"):
            dynamics.run_controlled(self.world, short)
        hand = dynamics.World().add_robot("barrett")
        of_hand = dynamics.computed_torque(hand, np.zeros(4))
        with self.assertRaisesRegex(prehend.InputError, "is of a robot with 4 degrees of freedom"):
            dynamics.run_controlled(self.world, of_hand)

    def test_arguments_are_named(self):
        for words, call in (
            (r"positions: must have the shape \(6,\)", lambda: setattr(self.arm, "positions", [1])),
            ("rates: a number is not finite", lambda: setattr(self.arm, "rates", [np.nan] * 6)),
            ("efforts: not an array", lambda: setattr(self.arm, "efforts", "none")),
            ("X_WB: not a rigid pose", lambda: setattr(self.arm, "X_WB", np.zeros((4, 4)))),
            (r"gravity: must have the shape \(3,\)", lambda: dynamics.World(gravity=9.81)),
            ("Drive.stiffness: must be at least 0", lambda: dynamics.Drive(stiffness=-1)),
            (r"drives\[0\].dof: must be below 6", lambda: setattr(self.arm, "drives", [dynamics.Drive(dof=6)])),
            ("step: must be at least 1e-5", lambda: self.world.step(0)),
            ("seconds: must not be negative", lambda: dynamics.run_controlled(self.world, self.weight, seconds=-1)),
            ("frequency: must be above 0", lambda: dynamics.stated_gains(self.arm, 0)),
            ("preshapes: has no preshape", lambda: dynamics.set_points("barrett", "fist")),
            ("mass: must be positive", lambda: self.world.add_body("cube", box_mesh(1, 1, 1), mass=0)),
            ("restitution: must be from 0", lambda: self.world.add_body("cube", box_mesh(1, 1, 1), restitution=2)),
        ):
            with self.subTest(words), self.assertRaisesRegex(prehend.InputError, words):
                call()
        with self.assertRaises(TypeError):
            dynamics.Drive(strength=1)

    def test_bodies_that_overlap_are_named(self):
        self.world.add_body("one", box_mesh(0.1, 0.1, 0.1), moved(3, 0, 0))
        other = self.world.add_body("other", box_mesh(0.1, 0.1, 0.1), moved(3, 0, 0.05), mass=1.0)
        with self.assertRaisesRegex(prehend.InputError, "overlaps"):
            self.world.step()
        other.X_WB = moved(3, 0, 0.2)
        self.assertEqual(self.world.step().outcome, "moved")

    def test_functions_are_dropped_with_what_holds_them(self):
        class Function:
            def __call__(self, state):
                return np.zeros(6)

        function = Function()
        alive = weakref.ref(function)
        controller = dynamics.sum_of(function)
        dynamics.run_controlled(self.world, controller, seconds=0.01)
        del function, controller
        gc.collect()
        self.assertIsNone(alive())


class Threads(unittest.TestCase):
    def setUp(self):
        self.world, self.arm = world_with_arm()
        self.weight = dynamics.gravity_compensation()

    def test_functions_are_called_in_the_thread_that_called(self):
        seen = set()

        def controller(state):
            seen.add(threading.get_ident())
            return self.weight(state)

        dynamics.run_controlled(self.world, controller, seconds=0.05)
        self.assertEqual(seen, {threading.get_ident()})

    def test_functions_may_look_at_the_world_and_not_step_it(self):
        def controller(state):
            np.testing.assert_array_equal(self.arm.positions, state.positions)
            for change in (
                lambda: self.world.step(),
                lambda: dynamics.run_controlled(self.world, self.weight),
                lambda: self.world.add_robot("ur5e"),
            ):
                with self.assertRaisesRegex(RuntimeError, "a run of the world is going on"):
                    change()
            return self.weight(state)

        run = dynamics.run_controlled(self.world, controller, seconds=0.01)
        self.assertEqual(run.outcome, "finished")

    def test_other_threads_run_but_not_with_the_world(self):
        cancellation = prehend.Cancellation()
        results = []

        def long_run():
            try:
                dynamics.run_controlled(
                    self.world, self.weight, seconds=1e6, cancellation=cancellation
                )
            except BaseException as error:  # noqa: B902
                results.append(error)

        thread = threading.Thread(target=long_run)
        thread.start()
        refused = None
        try:
            while refused is None:  # until the thread has begun
                try:
                    self.arm.positions
                except RuntimeError as error:
                    refused = error
        finally:
            cancellation.request()
            thread.join()
        self.assertIn("another thread is stepping the world", str(refused))
        self.assertIsInstance(results[0], prehend.Cancelled)
        np.testing.assert_allclose(self.arm.positions, BENT, atol=1e-6)

    def test_a_signal_raises_keyboard_interrupt(self):
        main = threading.main_thread().ident

        def interrupt():
            signal.pthread_kill(main, signal.SIGINT)

        for controller in (self.weight, lambda state: self.weight(state)):
            begun = threading.Event()

            def watch(time, world):
                begun.set()
                return False

            def after_it_begun():
                begun.wait()
                interrupt()

            thread = threading.Thread(target=after_it_begun)
            thread.start()
            with self.assertRaises(KeyboardInterrupt):
                dynamics.run_controlled(self.world, controller, seconds=1e6, stops=watch)
            thread.join()
        # Without any Python function in the run as well.
        timer = threading.Timer(0.2, interrupt)
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            dynamics.run_controlled(self.world, self.weight, seconds=1e6)
        timer.join()


if __name__ == "__main__":
    unittest.main()
