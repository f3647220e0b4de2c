"""Tests of the Python package: the same numbers as the program, arrays, errors, threads, signals."""

import copy
import errno
import gc
import json
import os
import pathlib
import pickle
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
import weakref

import numpy as np

import prehend
from prehend import files, planning, quality, results, robots

FEW = 40  # candidates, where it does not matter how many


def few_options(**fields):
    return prehend.PlanOptions(
        search=prehend.options.SearchOptions(trials=FEW), **fields
    )


def box_mesh(x, y, z):
    vertices = np.array([[i, j, k] for i in (-x, x) for j in (-y, y) for k in (-z, z)]) / 2.0
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    faces = [[q[0], q[i], q[i + 1]] for q in quads for i in (1, 2)]
    return vertices, np.array(faces)


def moved(x, y, z):
    pose = np.eye(4)
    pose[:3, 3] = (x, y, z)
    return pose


class LikeTrimesh:
    """What trimesh.Trimesh has of interest."""

    def __init__(self, vertices, faces):
        self.vertices = vertices
        self.faces = faces


class Mug(unittest.TestCase):
    """One small plan, shared by the tests that only look at it."""

    @classmethod
    def setUpClass(cls):
        cls.scene = prehend.compile_scene(prehend.load_scene("mug"))
        cls.result = prehend.plan(cls.scene, few_options())

    def test_the_program_writes_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(
                [os.environ["PREHEND_PROGRAM"], "plan", "mug", "--no-report", "--out", folder],
                check=True,
                capture_output=True,
            )
            written = (pathlib.Path(folder) / "grasps.json").read_bytes()
        result = prehend.plan(prehend.load_scene("mug"))
        self.assertEqual(files.grasps_json(result).encode(), written)

    def test_arrays_have_the_shapes_they_are_said_to_have(self):
        result, n = self.result, len(self.result)
        self.assertGreater(n, 0)
        hand = self.scene.hand
        for name, shape in {
            "poses": (n, 4, 4),
            "world_poses": (n, 4, 4),
            "epsilon": (n,),
            "volume": (n,),
            "dofs": (n, len(hand.dofs)),
            "joints": (n, len(hand.joints)),
        }.items():
            array = getattr(result, name)
            self.assertEqual((array.shape, array.dtype), (shape, np.float64), name)
        self.assertEqual(result.tried.poses.shape, (FEW, 4, 4))
        self.assertEqual(sum(result.outcomes.values()), FEW)
        self.assertEqual(result.status, "complete")
        # Those come first that hold a free object firmly, then the others that were closed on one,
        # both by the epsilon where it ends: it grows once at most.
        free = [grasp.free for grasp in result if grasp.free is not None]
        self.assertEqual([grasp.free for grasp in result][: len(free)], free)
        self.assertGreater(len(free), 0)
        self.assertLessEqual(np.sum(np.diff([one.epsilon for one in free]) > 0.0), 1)
        self.assertTrue(np.all(np.diff(result.epsilon[len(free) :]) <= 0.0))
        for one in free:
            self.assertIn(one.outcome, ("stable", "not_force_closure"))
            self.assertEqual((one.X_OH.shape, one.X_OC.shape), ((4, 4), (4, 4)))
            self.assertEqual(one.joints.shape, (len(hand.joints),))

    def test_poses_are_those_of_the_grasps_file(self):
        grasps = json.loads(files.grasps_json(self.result))["grasps"]
        for grasp, written in zip(self.result, grasps):
            position = written["X_object_hand"]["position"]
            np.testing.assert_array_equal(grasp.X_OH[:3, 3], position)
            self.assertEqual(grasp.epsilon, written["epsilon"])

    def test_returned_arrays_own_their_memory(self):
        scene = prehend.compile_scene(prehend.load_scene("mug"))
        result = prehend.plan(scene, few_options())
        pose = result[0].X_OH
        vertices = scene.object.vertices
        before = pose.copy(), vertices.copy()
        self.assertTrue(pose.flags.owndata and vertices.flags.owndata)
        del result, scene
        gc.collect()
        np.testing.assert_array_equal(pose, before[0])
        np.testing.assert_array_equal(vertices, before[1])

    def test_contacts_are_objects_and_arrays(self):
        contacts = self.result[0].contacts
        for i, contact in enumerate(contacts):
            np.testing.assert_array_equal(contact.position, contacts.positions[i])
            self.assertIn(contact.link, self.scene.hand.links)
            self.assertAlmostEqual(float(np.linalg.norm(contact.normal)), 1.0, places=9)
        flat = self.result.flat_contacts
        self.assertEqual(len(flat), sum(len(one) for one in self.result.contacts))
        np.testing.assert_array_equal(flat.positions[flat.grasps == 0], contacts.positions)
        self.assertEqual(len(contacts[1:3]), 2)

    def test_quality_of_contacts_is_that_of_the_trial(self):
        frame = {
            "torque_origin": self.scene.torque_origin,
            "torque_scale": self.scene.torque_scale,
        }
        np.testing.assert_allclose(
            quality.epsilon(self.result.contacts, **frame), self.result.epsilon, rtol=1e-8
        )

    def test_threads_and_seed(self):
        one = prehend.plan(self.scene, few_options(), threads=1)
        self.assertEqual(files.grasps_json(one), files.grasps_json(self.result))
        seeded = prehend.plan(self.scene, few_options(), seed=7)
        self.assertEqual(json.loads(files.grasps_json(seeded))["settings"]["seed"], 7)

    def test_evaluate_and_run_trial_agree_with_plan(self):
        candidates = [grasp.candidate for grasp in self.result]
        again = prehend.evaluate(self.scene, candidates)
        np.testing.assert_array_equal(again.poses, self.result.poses)
        np.testing.assert_array_equal(again.epsilon, self.result.epsilon)
        alone = planning.run_trial(self.scene, candidates[0])
        np.testing.assert_array_equal(alone.X_OH, self.result[0].X_OH)
        self.assertEqual(alone.epsilon, self.result[0].epsilon)

    def test_proposals_are_what_plan_tries(self):
        proposals = planning.propose_grasps(self.scene, count=FEW)
        options = prehend.PlanOptions(search=prehend.options.SearchOptions(trials=FEW, follow=0.0))
        np.testing.assert_array_equal(
            [one.X_OH for one in proposals.candidates],
            prehend.plan(self.scene, options).tried.poses,
        )

    def test_pictures_are_pixels(self):
        picture = files.grasp_picture(self.result[0], size=(120, 90))
        self.assertEqual((picture.shape, picture.dtype), ((90, 120, 3), np.uint8))
        self.assertGreater(len(np.unique(picture.reshape(-1, 3), axis=0)), 50)
        self.assertTrue(files.png_bytes(picture).startswith(b"\x89PNG"))

    def test_files_are_written(self):
        with tempfile.TemporaryDirectory() as folder:
            for earlier in ("grasp_7.glb", "notes.txt"):
                (pathlib.Path(folder) / earlier).write_text("of an earlier result")
            names = prehend.write_grasps(self.result, folder, exports=["csv"])
            (pathlib.Path(folder) / "notes.txt").unlink()
            self.assertEqual(sorted(os.listdir(folder)), sorted(names))
            self.assertIn("report.html", names)
            text = (pathlib.Path(folder) / "grasps.json").read_text()
        self.assertEqual(text, files.grasps_json(self.result))
        with self.assertRaisesRegex(prehend.InputError, "csv"):
            files.export_files(self.result, "docx")

    def test_report_and_picture_are_written_where_wanted(self):
        for wanted, names in (
            ({}, ["best.png", "report.html"]),
            ({"picture": False}, ["report.html"]),
            ({"report": False}, []),
            ({"report": False, "picture": True}, ["best.png"]),
        ):
            with self.subTest(**wanted), tempfile.TemporaryDirectory() as folder:
                prehend.write_grasps(self.result, folder, **wanted)
                self.assertEqual(
                    sorted(os.listdir(folder)), sorted([*names, "grasps.json", "timings.json"])
                )

    def test_nothing_leaks(self):
        mesh = box_mesh(0.05, 0.05, 0.1)
        counts = None
        for _ in range(20):
            scene = prehend.make_scene(mesh)
            compiled = prehend.compile_scene(scene)
            contacts = quality.epsilon(self.result[0].contacts)
            trial = planning.run_trial(compiled, prehend.Candidate(moved(0, 0, -0.3), preshape="spread_0"))
            gone = weakref.ref(trial)
            del trial, contacts
            gc.collect()
            self.assertIsNone(gone())
            now = [sys.getrefcount(part) for part in (*mesh, prehend.InputError, results.Trial)]
            counts = counts or now
            self.assertEqual(now, counts)


class Cancelling(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = prehend.compile_scene(prehend.load_scene("mug"))

    def test_progress_is_reported_in_the_thread_that_called(self):
        seen = []
        prehend.plan(
            self.scene, few_options(), progress=lambda p: seen.append((p, threading.get_ident()))
        )
        self.assertEqual({thread for _, thread in seen}, {threading.get_ident()})
        trials = [p for p, _ in seen if p.stage == "trials"]
        self.assertTrue(trials)
        self.assertTrue(all(0 <= p.done <= p.total for p, _ in seen))

    def test_an_exception_from_progress_ends_the_plan(self):
        calls = []

        def refuse(progress):
            if progress.stage == "trials":
                calls.append(progress)
                raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            prehend.plan(self.scene, progress=refuse)
        self.assertEqual(len(calls), 1)

    def test_cancelled_plans_return_what_they_have(self):
        stop = prehend.Cancellation()

        def stop_soon(progress):
            if progress.stage == "trials" and progress.done > 0:
                stop.request()

        result = prehend.plan(self.scene, progress=stop_soon, cancellation=stop, threads=1)
        self.assertEqual(result.status, "cancelled")
        self.assertGreater(result.untested, 0)
        self.assertTrue(stop.requested)

    def test_calls_without_a_partial_result_raise_cancelled(self):
        stop = prehend.Cancellation()
        stop.request()
        with self.assertRaises(prehend.Cancelled):
            planning.decompose(self.scene.object, cancellation=stop)

    def test_a_signal_in_the_callback_raises_keyboard_interrupt(self):
        def interrupt(progress):
            if progress.stage == "trials":
                signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            prehend.plan(self.scene, progress=interrupt)

    def test_a_signal_while_nothing_is_reported_raises_keyboard_interrupt(self):
        started = threading.Event()
        main = threading.main_thread().ident

        def interrupt():
            started.wait()
            signal.pthread_kill(main, signal.SIGINT)

        sender = threading.Thread(target=interrupt)
        sender.start()
        # Only the first report lets the signal go: it arrives while the main thread waits.
        try:
            with self.assertRaises(KeyboardInterrupt):
                prehend.plan(self.scene, progress=lambda p: started.set())
        finally:
            started.set()
            sender.join()

    def test_other_threads_run_while_one_plans(self):
        turns = []
        done = threading.Event()

        def count():
            while not done.is_set():
                turns.append(None)

        counter = threading.Thread(target=count)
        before = None

        def note(progress):
            nonlocal before
            if before is None:
                before = len(turns)

        counter.start()
        try:
            prehend.plan(self.scene, few_options(), progress=note)
        finally:
            done.set()
            counter.join()
        self.assertGreater(len(turns), before + 1000)


class Scenes(unittest.TestCase):
    def test_a_mesh_of_any_kind(self):
        vertices, faces = box_mesh(0.05, 0.06, 0.12)
        texts = set()
        for mesh in [
            (vertices, faces),
            (vertices.tolist(), faces.tolist()),
            (np.asfortranarray(vertices), faces.astype(np.uint8)),
            (np.repeat(vertices, 2, axis=0)[::2], faces.astype(np.int64)),
            LikeTrimesh(vertices, faces),
            prehend.Mesh(vertices, faces),
            (vertices, faces[:, ::-1]),
        ]:
            scene = prehend.make_scene(mesh, mass=0.2)
            np.testing.assert_allclose(scene.object.center_of_mass, 0.0, atol=1e-12)
            inertia = 0.2 / 12 * (0.05**2 + 0.06**2)
            self.assertAlmostEqual(scene.object.inertia[2, 2], inertia, places=12)
            texts.add(files.grasps_json(prehend.plan(scene, few_options())))
        # The last one has its triangles turned: the same grasps, not the same bytes of a mesh.
        self.assertLessEqual(len(texts), 2)

    def test_single_precision_is_close(self):
        vertices, faces = box_mesh(0.05, 0.06, 0.12)
        scene = prehend.make_scene((vertices.astype(np.float32), faces))
        np.testing.assert_allclose(scene.object.vertices, vertices, atol=1e-8)

    def test_mass_of_parts(self):
        scene = prehend.make_scene(box_mesh(0.02, 0.02, 0.4))
        self.assertEqual(scene.object.mass_from, "uniform density")
        self.assertRegex(scene.notes[0], "400 mm long")
        scene.set_mass(
            density=700,
            parts=[
                {"beyond": {"point": np.zeros(3), "normal": (0, 0, 1)}, "density": 2100},
                {"at": [0, 0, 0.1], "mass": 0.1},
            ],
        )
        half = 0.02 * 0.02 * 0.2
        mass = 2800 * half + 0.1
        self.assertEqual(scene.object.mass_from, "stated parts")
        self.assertAlmostEqual(scene.object.mass, mass, places=12)
        center = [0, 0, 0.1 * (1400 * half + 0.1) / mass]
        np.testing.assert_allclose(scene.object.center_of_mass, center, atol=1e-12)
        self.assertEqual(scene.notes, [])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "bar.json"
            scene.save(file)
            again = prehend.load_scene(file)
        np.testing.assert_allclose(again.object.inertia, scene.object.inertia, rtol=1e-12)
        scene.set_mass(0.4, center_of_mass=[0, 0, 0.1])
        self.assertEqual(scene.object.mass_from, "stated centre of mass")
        np.testing.assert_array_equal(scene.object.center_of_mass, [0, 0, 0.1])
        scene.set_mass()
        self.assertEqual((scene.object.mass, len(scene.notes)), (0.3, 1))
        with self.assertRaises(prehend.InputError) as caught:
            scene.set_mass(density=700, parts=[{"component": 1, "density": 1}])
        self.assertEqual(caught.exception.field, "parts[0].component")
        with self.assertRaisesRegex(prehend.InputError, "center_of_mass"):
            scene.set_mass(center_of_mass=[0, 0])

    def test_obstacles_and_arms(self):
        scene = prehend.make_scene(box_mesh(0.05, 0.05, 0.1), X_WO=moved(0.6, 0.0, 0.06))
        scene.add_obstacle("table", box_mesh(0.3, 0.3, 0.02), moved(0.6, 0.0, -0.02))
        self.assertEqual([body.name for body in scene.obstacles], ["table"])
        self.assertIsNone(scene.platform)
        scene.mount("puma560_barrett")
        self.assertIsNotNone(scene.platform)
        ready = prehend.compile_scene(scene)
        self.assertGreater(len(ready.robot.dofs), len(ready.hand.dofs))
        start = {name: 0.1 for name in ready.robot.dofs[:1]}
        scene.mount("puma560_barrett", start=start)
        with self.assertRaisesRegex(prehend.InputError, "nobody"):
            scene.mount("puma560_barrett", start={"nobody": 0.0})

    def test_saved_scenes_are_read_again(self):
        scene = prehend.make_scene(box_mesh(0.05, 0.05, 0.1), hand="franka_hand")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "box.json"
            scene.save(file)
            again = prehend.load_scene(file)
        self.assertEqual(again.hand.name, scene.hand.name)
        np.testing.assert_array_equal(again.object.vertices, scene.object.vertices)
        record = json.loads(files.grasps_json(prehend.plan(scene, few_options())))["scene"]
        self.assertEqual(record["file"], str(file))

    def test_a_file_that_cannot_be_written_is_an_error_of_the_system(self):
        scene = prehend.make_scene(box_mesh(0.05, 0.05, 0.1), hand="franka_hand")
        soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "box.json"
            resource.setrlimit(resource.RLIMIT_FSIZE, (10, hard))
            try:
                with self.assertRaisesRegex(OSError, "box.json: cannot be written") as caught:
                    scene.save(file)
            finally:
                resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
            self.assertEqual(caught.exception.errno, errno.EFBIG)
            self.assertEqual(os.listdir(folder), [])

    def test_too_large_an_object_is_a_status(self):
        result = prehend.plan(prehend.make_scene(box_mesh(2.0, 2.0, 2.0)))
        self.assertEqual(result.status, "object_too_large")
        self.assertGreater(result.smallest_width, result.largest_opening)
        self.assertIn("the hand opens to", result.reason)
        self.assertEqual(result.advice, [])
        self.assertEqual((len(result), result.poses.shape), (0, (0, 4, 4)))

    def test_a_plan_without_a_grasp_says_what_may_help(self):
        result = prehend.plan(prehend.make_scene(box_mesh(0.12, 0.12, 0.12), hand="parallel_jaw"))
        self.assertEqual([one.hint for one in result.advice], ["other_hand"])
        self.assertIn("--hand parallel_jaw_wide, which opens to 140 mm", result.advice[0].words)
        few = prehend.PlanOptions(search=prehend.options.SearchOptions(trials=5))
        held = prehend.plan(prehend.make_scene(box_mesh(0.05, 0.05, 0.1), hand="franka_hand"), few)
        self.assertEqual((held.advice, held.rules), ([], []))

    def test_decompositions_and_primitives(self):
        found = planning.decompose(box_mesh(0.05, 0.06, 0.12))
        self.assertEqual([one.shape for one in found.primitives], ["box"])
        np.testing.assert_allclose(sorted(found.primitives[0].size), [0.05, 0.06, 0.12], atol=2e-3)
        sphere = planning.Primitive("sphere", np.eye(4), radius=0.03)
        scene = prehend.make_scene(box_mesh(0.05, 0.06, 0.12))
        self.assertTrue(planning.propose_grasps(scene, [sphere]).grasps)
        with self.assertRaisesRegex(prehend.InputError, "height"):
            planning.propose_grasps(scene, [planning.Primitive("cylinder", np.eye(4), radius=0.03)])


class Kinematics(unittest.TestCase):
    def test_solutions_reach_the_target(self):
        arm = robots.find_robot("puma560")
        dofs = np.clip(np.linspace(-0.6, 0.7, len(arm.dofs)), *arm.dof_limits.T)
        target = robots.joint_poses(arm, robots.joint_values(arm, dofs))[arm.tip_joint]
        solutions = robots.solve_all(arm, target)
        self.assertEqual(solutions.shape[1:], (len(arm.dofs),))
        self.assertGreater(len(solutions), 1)
        for solution in [*solutions, robots.solve_near(arm, target, dofs)]:
            pose = robots.joint_poses(arm, robots.joint_values(arm, solution))[arm.tip_joint]
            np.testing.assert_allclose(pose, target, atol=1e-7)
        self.assertIsNone(robots.solve_near("puma560", moved(10.0, 0.0, 0.0)))
        joint = robots.IkTarget(target, joint=arm.joints[arm.tip_joint])
        np.testing.assert_array_equal(robots.solve_all(arm, [joint]), solutions)

    def test_whichever_of_several_objects(self):
        box = {"geometry": [{"shape": "box", "size": [0.05, 0.05, 0.05]}]}
        away = {**box, "name": "away", "pose": {"position": [1, 0, 0]}}
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "scene.json"
            file.write_text(
                json.dumps({"objects": [{**box, "name": "here"}, away], "hand": "parallel_jaw"})
            )
            names = prehend.scenes.scene_objects(file)
            self.assertEqual(names, ["here", "away"])
            low = {"inside": {"shape": "box", "size": [1, 1, 0.04], "pose": {"position": [0, 0, -0.03]}}}
            found = [
                prehend.load_scene(file, object=name, keep_out=[low], preferred=[]) for name in names
            ]
            with self.assertRaisesRegex(prehend.InputError, "the scene has no such object"):
                prehend.load_scene(file, object="there")
            with self.assertRaisesRegex(prehend.InputError, "keep_out: the object has no parts"):
                prehend.load_scene(file, keep_out=["lid"])
            with self.assertRaisesRegex(prehend.InputError, "keep_out: the object has no colours"):
                prehend.load_scene(file, keep_out=["#cc3311"])
            with self.assertRaisesRegex(prehend.InputError, "must be a colour, such as"):
                prehend.load_scene(file, preferred=[{"color": "red", "within": 0.1}])
            stick = pathlib.Path(os.environ["PREHEND_SOURCE"]) / "tests/corpus/ply/good_face_colors.ply"
            half = prehend.load_scene(stick, unit="cm", keep_out=["#0000ff"])
            half.save(pathlib.Path(folder) / "half.json")
            saved = json.loads((pathlib.Path(folder) / "half.json").read_text())
            self.assertEqual(saved["object"]["keep_out"], [{"color": "#0000ff"}])
        any_plan = planning.plan_any(found, few_options())
        self.assertEqual(len(any_plan.results), 2)
        self.assertEqual(any_plan.first, [[], []])
        scene, grasp = any_plan.ranked[0]
        best = any_plan.results[scene][grasp]
        self.assertTrue(all(contact.position[2] > -0.01 for contact in best.contacts))
        self.assertEqual(len(any_plan.ranked), sum(len(one) for one in any_plan.results))

    def test_hands_that_come_from_one_side(self):
        limit = prehend.options.ApproachLimit(direction=[0.0, 0.0, -2.0], angle=0.3)
        np.testing.assert_array_equal(limit.direction, [0.0, 0.0, -2.0])
        options = few_options(candidates=prehend.options.CandidateOptions(approach=limit))
        result = prehend.plan(prehend.load_scene("mug"), options)
        self.assertGreater(len(result), 0)
        for grasp in result:
            self.assertGreaterEqual(-grasp.approach[2], np.cos(0.3) - 1e-9)
        with self.assertRaisesRegex(prehend.InputError, "ApproachLimit.angle"):
            limit.angle = 4.0
        limit.direction = np.zeros(3)
        options.candidates.approach = limit
        with self.assertRaisesRegex(prehend.InputError, "candidates.approach.direction: must not be zero"):
            prehend.plan(prehend.load_scene("mug"), options)

    def test_a_path_to_a_grasp(self):
        scene = prehend.compile_scene(prehend.load_scene("mug_on_table"))
        options = few_options(paths=prehend.options.GraspPathOptions())
        options.search.trials = 150
        options.search.settled = 1.0
        options.rank.top = 1
        result = prehend.plan(scene, options)
        path = result[0].path
        samples = len(path.times)
        self.assertEqual(path.positions.shape, (samples, len(path.joints)))
        self.assertEqual(path.velocities.shape, (samples, len(path.joints)))
        self.assertTrue(np.all(np.diff(path.times) > 0.0))
        self.assertEqual(path.segments[-1].last, samples - 1)
        self.assertEqual(path.lift, "complete")
        self.assertEqual([s.name for s in path.segments[-2:]], ["lift", "retreat"])
        bare = prehend.options.GraspPathOptions(lift=prehend.options.LiftOptions(height=0.0))
        self.assertEqual(planning.plan_grasp_path(result[0], bare).lift, "not_asked")
        alone = planning.plan_grasp_path(result[0])
        np.testing.assert_array_equal(alone.positions[0], path.positions[0])

    def test_a_path_without_a_grasp(self):
        scene = prehend.compile_scene(prehend.load_scene("panda_on_table"))
        goal = scene.robot.initial
        goal[0] += 0.5
        there = planning.plan_arm_path(scene, goal)
        self.assertEqual(there.end, "found")
        self.assertAlmostEqual(there.path.positions[-1, 0], goal[0])
        self.assertEqual([s.name for s in there.path.segments], ["transfer"])
        self.assertGreaterEqual(there.relative_length, 1.0)
        goal[0] = 100.0
        beyond = planning.plan_arm_path(scene, goal)
        self.assertEqual((beyond.end, beyond.path), ("beyond_limits", None))
        self.assertIn("joint1", beyond.why)
        far = np.eye(4)
        far[0, 3] = 5.0
        self.assertEqual(planning.plan_arm_path(scene, X_WH=far).end, "unreachable")
        line = planning.plan_arm_path(scene, X_WH=far, straight=True)
        self.assertEqual((line.end, line.path), ("unreachable", None))
        self.assertRegex(line.why, r"^after \d+ % of the line$")
        for wrong in [
            dict(),
            dict(dofs=goal, X_WH=far),
            dict(dofs=[1.0]),
            dict(dofs=goal * np.nan),
            dict(dofs=goal, straight=True),
        ]:
            with self.assertRaises(prehend.InputError):
                planning.plan_arm_path(scene, **wrong)
        with self.assertRaisesRegex(prehend.InputError, "arm"):
            planning.plan_arm_path(prehend.load_scene("mug"), goal)


class Quality(unittest.TestCase):
    def setUp(self):
        random = np.random.default_rng(3)
        self.normals = random.normal(size=(30, 4, 3))
        self.normals /= np.linalg.norm(self.normals, axis=2, keepdims=True)
        self.positions = -0.1 * self.normals
        self.friction = random.uniform(0.2, 1.0, size=(30, 4))

    def test_a_batch_is_the_single_calls(self):
        arguments = self.positions, self.normals, self.friction
        for call in [
            quality.epsilon,
            quality.volume,
            quality.force_closure,
            quality.isotropy,
            quality.smallest_singular_value,
            lambda *a, **k: quality.robust_epsilon(
                *a, noise=quality.NoiseOptions(samples=5), **k
            ).mean,
            lambda *a, **k: quality.wrench_resistance([0, 0, 1, 0, 0, 0], *a, **k).lower,
            lambda *a, **k: quality.epsilon_bracket(*a, **k).weakest,
        ]:
            batch = call(*arguments, torque_scale=10.0)
            single = [call(*one, torque_scale=10.0) for one in zip(*arguments)]
            np.testing.assert_array_equal(batch, single)
            ragged = call(*(list(one) for one in arguments), torque_scale=10.0, threads=3)
            np.testing.assert_array_equal(batch, ragged)

    def test_a_cube_between_soft_fingers(self):
        # Two soft fingers on a line through the centre: the torque about that line is what they
        # resist least of all, by twice the friction times the torsion times the scale.
        positions, normals = [[-1.0, 0, 0], [1.0, 0, 0]], [[1.0, 0, 0], [-1.0, 0, 0]]
        self.assertEqual(quality.epsilon(positions, normals, 0.5), 0.0)
        self.assertFalse(quality.force_closure(positions, normals, 0.5))
        self.assertTrue(quality.force_closure(positions, normals, 0.5, torsion=0.3))
        held = quality.balancing_forces([0, 0, -1.0, 0, 0, 0], positions, normals, 0.5)
        self.assertEqual(held.outcome, "balanced")
        self.assertAlmostEqual(held.largest_normal, 1.0, places=5)
        np.testing.assert_allclose(held.forces.sum(axis=0), [0, 0, 1.0], atol=1e-6)

    def test_any_array_will_do(self):
        p, n = np.round(self.positions[0], 3), self.normals[0]
        expected = quality.epsilon(p, n, 1)
        for one in [p.tolist(), np.asfortranarray(p), np.repeat(p, 2, axis=0)[::2]]:
            self.assertEqual(quality.epsilon(one, n, 1), expected)
        whole = quality.epsilon(np.array([[1, 0, 0], [-1, 0, 0]]), [[-1, 0, 0], [1, 0, 0]], 1)
        self.assertEqual(whole, 0.0)
        single = quality.epsilon(p.astype(np.float32), n.astype(np.float32), np.float32(1.0))
        self.assertAlmostEqual(single, expected, places=5)

    def test_measures_by_name(self):
        self.assertIn("epsilon", quality.measures())
        found = quality.measure("epsilon", self.positions, self.normals, 0.8)
        np.testing.assert_array_equal(
            found.lower, quality.epsilon(self.positions, self.normals, 0.8)
        )
        task = quality.Task.gravity(weight=0.1)
        resisted = quality.task_resistance(task, self.positions[0], self.normals[0], 0.8)
        self.assertLessEqual(resisted.lower, resisted.upper)

    def test_empty(self):
        self.assertEqual(quality.epsilon([], [], 0.5), 0.0)
        self.assertEqual(quality.epsilon(np.zeros((0, 3, 3)), np.zeros((0, 3, 3)), 0.5).shape, (0,))


class Errors(unittest.TestCase):
    def refused(self, words, call, *arguments, **keywords):
        with self.assertRaisesRegex(prehend.InputError, words) as caught:
            call(*arguments, **keywords)
        self.assertIsInstance(caught.exception, ValueError)
        self.assertNotIn("\n", str(caught.exception))
        return caught.exception

    def test_shapes_name_the_argument(self):
        vertices, faces = box_mesh(1, 1, 1)
        error = self.refused(
            r"vertices: must have the shape \(V, 3\), not \(8, 2\)",
            prehend.make_scene,
            (vertices[:, :2], faces),
        )
        self.assertEqual(error.field, "vertices")
        self.refused(r"faces: .*\(F, 3\), not \(12,\)", prehend.make_scene, (vertices, faces[:, 0]))
        self.refused("faces: refers to a vertex", prehend.make_scene, (vertices, faces + 3))
        self.refused("faces: must be whole", prehend.make_scene, (vertices, faces * 1.0))
        self.refused("mesh: must be", prehend.make_scene, 5)
        self.refused(r"normals: .*\(2, 3\)", quality.epsilon, np.zeros((2, 3)), np.zeros((3, 3)), 1)
        self.refused("friction", quality.epsilon, np.zeros((2, 3)), np.zeros((2, 3)), [1, 2, 3])
        self.refused("positions: not an array", quality.epsilon, [[1, "a", 2]], [[1, 0, 0]], 1)

    def test_the_core_refuses_what_is_not_a_number(self):
        points, normals = np.array([[np.nan, 0, 0]]), np.array([[0.0, 0, 1]])
        self.refused("contact 0.*finite|finite", quality.epsilon, points, normals, 0.5)
        self.refused("normal", quality.epsilon, np.zeros((1, 3)), 2.0 * normals, 0.5)
        batch = np.zeros((3, 1, 3)), np.array([normals, normals, 2.0 * normals])
        self.refused(r"grasps\[2\].*normal", quality.epsilon, *batch, 0.5)
        vertices, faces = box_mesh(1, 1, 1)
        vertices[0, 0] = np.inf
        self.refused("finite", prehend.make_scene, (vertices, faces))

    def test_names(self):
        self.refused("barrett", robots.find_robot, "no_such_hand")
        self.refused("mug", prehend.load_scene, "no_such_scene")
        self.refused("wood", prehend.make_scene, box_mesh(1, 1, 1), material="cheese")
        error = self.refused("mass", prehend.make_scene, box_mesh(1, 1, 1), mass=0.0)
        self.assertEqual((error.field, error.problem), ("mass", "must be positive"))
        self.refused("epsilon", quality.measure, "nothing", [[0, 0, 0]], [[0, 0, 1]], 1)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "broken.json"
            file.write_text('{"object": {"generate": "mug", "mass": -1}}')
            self.refused("broken.json.*mass", prehend.load_scene, file)

    def test_candidates(self):
        scene = prehend.compile_scene(prehend.make_scene(box_mesh(0.05, 0.05, 0.1)))
        poses = np.array([np.eye(4), 2.0 * np.eye(4)])
        self.refused(r"poses\[1\]: not a rigid", prehend.evaluate, scene, poses, preshape="spread_0")
        self.refused(r"poses: .*\(N, 4, 4\)", prehend.evaluate, scene, np.eye(4))
        self.refused("preshape: say one of", prehend.evaluate, scene, poses[:1])
        self.refused("preshape: not one", prehend.evaluate, scene, poses[:1], preshape="fist")
        limits = scene.hand.dof_limits
        self.refused("outside its limits", prehend.evaluate, scene, poses[:1], dofs=limits[:, 1] + 1)
        result = prehend.evaluate(scene, np.zeros((0, 4, 4)), preshape="spread_0")
        self.assertEqual(result.status, "no_candidates")

    def test_options(self):
        with self.assertRaisesRegex(TypeError, "no field tops.*same_angle"):
            prehend.options.RankOptions(tops=3)
        error = self.refused("RankOptions.top: must be at least 1", prehend.options.RankOptions, top=0)
        self.assertEqual((error.field, error.value), ("RankOptions.top", "0"))
        self.refused("NaN|nan|at least", prehend.options.RankOptions, same_angle=float("nan"))
        self.refused("rrt_star", prehend.options.TransferOptions, planner="walk")
        self.refused("coarse", prehend.plan_options, "coarse")
        self.assertFalse(prehend.plan_options("draft").volumes)
        self.assertEqual(repr(prehend.plan_options()), repr(prehend.PlanOptions()))
        self.refused("budget: must be above 0", prehend.plan, prehend.load_scene("mug"), budget=0.0)
        self.refused("seed", prehend.plan, prehend.load_scene("mug"), seed=-1)
        self.refused("threads", prehend.plan, prehend.load_scene("mug"), threads=-1)
        self.refused(
            "no arm", prehend.plan, prehend.load_scene("mug"), few_options(paths=prehend.options.GraspPathOptions())
        )

    def test_pads_of_finite_elements(self):
        options = few_options()
        options.trial.contacts = "fem"
        self.refused("barrett: contacts: fem needs", prehend.plan, prehend.load_scene("mug"), options)
        scene = prehend.make_scene(box_mesh(0.03, 0.05, 0.1), hand="franka_hand")
        pads = prehend.plan(scene, options).grasps[0].pads
        self.assertGreater(pads.softest, 0.0)
        self.assertEqual([patch.link for patch in pads.patches], ["left_pad", "right_pad"])
        for patch in pads.patches:
            self.assertGreater(patch.load, 0.0)
            self.assertGreater(patch.nodes, 0)
            self.assertAlmostEqual(np.linalg.norm(patch.normal), 1.0)
        self.assertIsNone(prehend.plan(scene, few_options()).grasps[0].pads)

    def test_options_are_values(self):
        options = few_options()
        twin = copy.deepcopy(options)
        twin.trial.contacts = "hard"
        twin.rank.top = 3
        self.assertEqual(options.trial.contacts, "soft")
        self.assertEqual(options.rank.top, 10)
        self.assertIsNone(options.paths)
        twin.paths = prehend.options.GraspPathOptions(alternatives=2)
        self.assertEqual(twin.paths.alternatives, 2)
        self.assertIn("RankOptions(top=3, by='epsilon', pool=3.0, same_distance=0.01", repr(twin))

    def test_survive_a_pickle_with_all_that_is_nested(self):
        options = prehend.plan_options("fine")
        options.trial.contacts = "hard"
        options.paths = prehend.options.GraspPathOptions(alternatives=2)
        twin = pickle.loads(pickle.dumps(options))
        self.assertEqual(repr(twin), repr(options))
        self.assertEqual(twin.paths.alternatives, 2)


class Views(unittest.TestCase):
    """What depth cameras saw, as arrays: a block on a table, in closed form."""

    SIZE = (0.05, 0.05, 0.12)
    CAMERA = dict(fx=600.0, fy=600.0, cx=319.5, cy=239.5)

    @classmethod
    def setUpClass(cls):
        eye = np.array([0.45, -0.35, 0.45])
        z = (np.array([0.0, 0.0, 0.03]) - eye) / np.linalg.norm(np.array([0.0, 0.0, 0.03]) - eye)
        y = z[2] * z - np.array([0.0, 0.0, 1.0])
        y /= np.linalg.norm(y)
        cls.X_WC = np.eye(4)
        cls.X_WC[:3, :3] = np.column_stack([np.cross(y, z), y, z])
        cls.X_WC[:3, 3] = eye
        u, v = np.meshgrid(np.arange(640), np.arange(480))
        rays = np.stack([(u - 319.5) / 600.0, (v - 239.5) / 600.0, np.ones(u.shape)], axis=-1)
        d = rays @ cls.X_WC[:3, :3].T
        t = -eye[2] / d[..., 2]
        far = np.linalg.norm(eye[:2] + t[..., None] * d[..., :2], axis=-1) > 0.5
        depth = np.where((d[..., 2] < 0) & ~far, t, np.inf)
        lower = np.array([-cls.SIZE[0] / 2, -cls.SIZE[1] / 2, 0.0])
        a, b = (lower - eye) / d, (lower + cls.SIZE - eye) / d
        first, last = np.minimum(a, b).max(axis=-1), np.maximum(a, b).min(axis=-1)
        depth = np.where(first <= last, np.minimum(depth, first), depth)
        cls.depth = np.where(np.isfinite(depth), depth, 0.0)
        seen = cls.depth > 0
        cls.points = eye + cls.depth[seen][:, None] * d[seen]

    def image(self, depth=None, **fields):
        given = dict(self.CAMERA, X_WC=self.X_WC)
        given.update(fields)
        return prehend.scenes.DepthImage(self.depth if depth is None else depth, **given)

    def check(self, scene):
        self.assertEqual(scene.object.name, "object1")
        self.assertEqual([body.name for body in scene.obstacles], ["support"])
        corners = scene.object.vertices + scene.object.X_WO[:3, 3]
        # Two cells of the grid.
        np.testing.assert_allclose(corners.max(axis=0) - corners.min(axis=0), self.SIZE, atol=0.012)

    def test_a_depth_image_is_planned(self):
        scenes = prehend.scenes.scenes_from_views(self.image(), hand="franka_hand")
        self.assertEqual(len(scenes), 1)
        self.check(scenes[0])
        result = prehend.plan(scenes[0], few_options())
        self.assertGreater(len(result), 0)
        self.assertTrue(result[0].shapes.likely)

    def test_units_and_types(self):
        tenths = np.round(1e4 * self.depth).astype(np.uint16)
        self.check(prehend.scenes.scenes_from_views([self.image(tenths, unit=1e-4)])[0])
        holes = np.where(self.depth > 0, self.depth, np.nan).astype(np.float32)
        self.check(prehend.scenes.scenes_from_views(self.image(holes))[0])

    def test_points(self):
        cloud = prehend.scenes.Cloud(self.points, viewpoint=self.X_WC[:3, 3])
        self.check(prehend.scenes.scenes_from_views(cloud)[0])

    def test_what_is_refused_is_named(self):
        def refusal(views, **options):
            with self.assertRaises(prehend.InputError) as caught:
                prehend.scenes.scenes_from_views(views, **options)
            return str(caught.exception)

        self.assertIn("views[0].depth", refusal(self.image(np.zeros(5))))
        self.assertIn("views[0].camera.fx", refusal(self.image(fx=0.0)))
        self.assertIn("views[0].unit", refusal(self.image(1000.0 * self.depth)))
        self.assertIn("views[1]", refusal([self.image(), self.image(np.zeros((120, 160)))]))
        few = prehend.scenes.Cloud(self.points, normals=np.zeros((3, 3)))
        self.assertIn("views[0].normals", refusal(few))
        self.assertIn("views", refusal([]))
        self.assertIn("voxel", refusal(self.image(), voxel=0.0))


if __name__ == "__main__":
    unittest.main()
