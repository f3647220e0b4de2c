"""Tests of what a result shows in a notebook, of learned orders and of decompositions."""

import base64
import copy
import html.parser
import json
import os
import pathlib
import pickle
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import prehend
from prehend import files, options, planning

SOURCE = pathlib.Path(os.environ["PREHEND_SOURCE"])


class Page(html.parser.HTMLParser):
    """Collects elements and text, and checks that elements are closed in order."""

    def __init__(self, text):
        super().__init__()
        self.open, self.images, self.rows, self.texts = [], [], [], []
        self.feed(text)
        self.close()
        if self.open:
            raise AssertionError(f"not closed: {self.open}")

    def handle_starttag(self, tag, attrs):
        if tag == "img":
            self.images.append(dict(attrs)["src"])
        else:
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])

    def handle_endtag(self, tag):
        if self.open.pop() != tag:
            raise AssertionError(f"</{tag}> closes another element")

    def handle_data(self, data):
        self.texts.append(data)
        if "tr" in self.open:
            self.rows[-1].append(data)


def few(trials=40, **fields):
    return prehend.PlanOptions(search=options.SearchOptions(trials=trials, **fields))


class Native(unittest.TestCase):
    """What a Python user would try first."""

    def test_a_name_a_file_or_a_mesh_is_planned_for(self):
        mesh = SOURCE / "docs" / "tutorial" / "bottle.obj"
        of_file = prehend.plan(mesh, few(), hand="franka_hand", top=2, seed=3)
        self.assertEqual(of_file.scene.hand.name, "franka_hand")
        self.assertEqual(len(of_file), 2)
        of_mesh = prehend.plan(prehend.load_mesh(mesh, unit="mm"), few(), hand="franka_hand")
        self.assertGreater(len(of_mesh), 0)
        by_name = prehend.plan("mug", few(), top=1)
        again = prehend.evaluate("mug", by_name.poses, preshape=by_name[0].preshape)
        self.assertEqual(again[0].outcome, "stable")

    def test_options_stay_as_they_are(self):
        chosen = few()
        prehend.plan("mug", chosen, top=1, seed=5)
        self.assertEqual((chosen.rank.top, chosen.seed), (10, 1))

    def test_a_scene_keeps_its_hand(self):
        with self.assertRaisesRegex(prehend.InputError, "hand: must not be given beside a Scene"):
            prehend.plan(prehend.load_scene("mug"), few(), hand="dlr")

    def test_grasps_that_are_kept(self):
        result = prehend.plan("mug", few(200))
        least = sorted(result.epsilon)[len(result) // 2]
        kept = result.where(lambda grasp: grasp.epsilon >= least)
        self.assertEqual(list(kept.epsilon), [e for e in result.epsilon if e >= least])
        written = json.loads(files.grasps_json(kept))
        self.assertEqual(len(written["grasps"]), len(kept))
        self.assertEqual(len(result.where(lambda grasp: False)), 0)

    def test_grasps_are_shaken(self):
        result = prehend.plan("mug", few(100), hand="franka_hand", top=3)
        shaken = planning.shake_grasps(result, "acronym", rank=True)
        self.assertIsNone(result[0].shake)
        written = json.loads(files.grasps_json(shaken))["grasps"]
        for grasp, other in zip(shaken, written):
            self.assertEqual(grasp.shake.procedure, "acronym")
            self.assertEqual(grasp.shake.survived, other["shake"]["survived"])
            self.assertEqual(
                [(test.name, test.outcome) for test in grasp.shake.tests],
                [(test["name"], test["outcome"]) for test in other["shake"]["tests"]],
            )
            self.assertEqual(grasp.shake.tests[0].phases[0].kind,
                             other["shake"]["tests"][0]["phases"][0]["kind"])
        survived = [grasp.shake.survived for grasp in shaken]
        self.assertEqual(survived, sorted(survived, reverse=True))
        self.assertIn("acronym", planning.library_test_procedures())
        with self.assertRaisesRegex(prehend.InputError, "nowhere"):
            planning.shake_grasps(result, "nowhere")

    def test_contacts_of_a_known_object_are_not_said_to_be_seen(self):
        self.assertEqual(set(prehend.plan("mug", few(), top=1).contacts[0].seen), {None})


class Loaded(unittest.TestCase):
    """Grasps of a file are the grasps that were written."""

    def test_grasps_of_a_file_are_those_that_were_written(self):
        result = prehend.plan("mug", few(), top=3)
        with tempfile.TemporaryDirectory() as folder:
            prehend.write_grasps(result, folder, report=False)
            file = pathlib.Path(folder) / "grasps.json"
            for again in (planning.load_grasps(file), planning.load_grasps(file, result.scene)):
                self.assertEqual(again.scene.hand.name, result.scene.hand.name)
                self.assertEqual(len(again), 3)
                # A file has quaternions for rotations.
                np.testing.assert_allclose(again.poses, result.poses, rtol=0, atol=1e-12)
                np.testing.assert_array_equal(again.epsilon, result.epsilon)
                self.assertEqual(again.outcomes, result.outcomes)
                self.assertEqual(again[0].contacts[0].link, result[0].contacts[0].link)

    def test_a_file_that_names_no_scene_needs_one(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "grasps.json"
            file.write_text('{"grasps": []}')
            with self.assertRaisesRegex(prehend.InputError, "names no scene"):
                planning.load_grasps(file)


class Copies(unittest.TestCase):
    """Pickles have the values of results; copies what C++ keeps as well."""

    @classmethod
    def setUpClass(cls):
        cls.scene = prehend.load_scene("mug", hand="franka_hand")
        cls.result = prehend.plan(cls.scene, options=few())

    def assertSame(self, one, two):
        self.assertEqual(len(one), len(two))
        self.assertEqual(one.outcomes, two.outcomes)
        for a, b in zip(one, two):
            self.assertEqual((a.epsilon, a.outcome, a.rule), (b.epsilon, b.outcome, b.rule))
            np.testing.assert_array_equal(a.X_OH, b.X_OH)
            np.testing.assert_array_equal(a.contacts.positions, b.contacts.positions)

    def test_a_pickled_result_has_its_values(self):
        again = pickle.loads(pickle.dumps(self.result))
        self.assertSame(again, self.result)
        np.testing.assert_array_equal(again.poses, self.result.poses)
        self.assertSame(again.where(lambda g: g.stable), self.result.where(lambda g: g.stable))
        with self.assertRaisesRegex(prehend.InputError, "unpickled"):
            files.grasp_picture(again[0])
        with self.assertRaisesRegex(prehend.InputError, "unpickled"):
            files.grasps_json(again)
        with self.assertRaisesRegex(prehend.InputError, "unpickled"):
            again.scene

    def test_worker_processes_return_results(self):
        code = (
            "import pickle, sys, prehend\n"
            "scene, options = (pickle.load(sys.stdin.buffer) for _ in range(2))\n"
            "sys.stdout.buffer.write(pickle.dumps(prehend.plan(scene, options=options)))"
        )
        sent = pickle.dumps(self.scene) + pickle.dumps(few())
        run = subprocess.run(
            [sys.executable, "-c", code], input=sent, capture_output=True, check=True
        )
        self.assertSame(pickle.loads(run.stdout), self.result)

    def test_copies_can_do_what_the_original_does(self):
        for again in (copy.copy(self.result), copy.deepcopy(self.result)):
            self.assertSame(again, self.result)
            self.assertEqual(files.grasps_json(again), files.grasps_json(self.result))
            self.assertEqual(files.grasp_picture(again[0]).shape, (700, 900, 3))
        apart = copy.deepcopy(self.result[0])
        self.assertIsNot(apart.X_OH, self.result[0].X_OH)

    def test_a_copied_scene_changes_alone(self):
        scene = prehend.load_scene("mug_on_table")
        again = copy.deepcopy(scene)
        again.add_obstacle("beam", prehend.Mesh(np.eye(3) + 5, np.array([[0, 1, 2]])))
        self.assertEqual(len(again.obstacles), len(scene.obstacles) + 1)
        self.assertEqual(pickle.loads(pickle.dumps(again)).obstacles[-1].name, "beam")


class Notebook(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = prehend.plan(prehend.load_scene("mug"), few())

    def png_of(self, page):
        (source,) = page.images
        kind, data = source.split(",")
        self.assertEqual(kind, "data:image/png;base64")
        return base64.b64decode(data, validate=True)

    def test_a_plan_shows_its_grasps_and_the_first_of_them(self):
        page = Page(self.result._repr_html_())
        self.assertTrue(self.png_of(page).startswith(b"\x89PNG"))
        shown = page.rows[1:]
        self.assertEqual(len(shown), min(10, len(self.result)))
        for row, grasp in zip(shown, self.result):
            self.assertEqual(row[1], f"{grasp.epsilon:.4f}")
        self.assertIn("mug: complete", page.texts[0])

    def test_a_grasp_shows_its_numbers_and_its_picture(self):
        grasp = self.result[0]
        page = Page(grasp._repr_html_())
        rows = dict(page.rows)
        self.assertEqual(rows["outcome"], "stable")
        self.assertIn(f"{grasp.epsilon:.4g}", rows["epsilon"])
        self.assertTrue(self.png_of(page).startswith(b"\x89PNG"))

    def test_a_trial_that_does_not_hold_says_why(self):
        far = prehend.Candidate(self.result[0].X_OH + np.array([[0, 0, 0, 1.0]] + [[0] * 4] * 3),
                                preshape=self.result[0].preshape)
        trial = planning.run_trial(self.result.scene, far)
        rows = dict(Page(trial._repr_html_()).rows)
        self.assertEqual(rows["outcome"], "no_contact")
        self.assertEqual(rows["what it means"], prehend.Outcome.no_contact.__doc__)

    def test_a_candidate_says_by_which_strategy_the_hand_closes(self):
        grasp = self.result[0]
        asked = prehend.Candidate(grasp.X_OH, preshape=grasp.preshape, strategy="gentle")
        trial = planning.run_trial(self.result.scene, asked)
        self.assertEqual(trial.candidate.strategy, "gentle")
        self.assertIsNone(grasp.candidate.strategy)
        unknown = prehend.Candidate(grasp.X_OH, preshape=grasp.preshape, strategy="rough")
        with self.assertRaisesRegex(prehend.InputError, "strategy.*not one of gentle, thumb_first"):
            planning.run_trial(self.result.scene, unknown)

    def test_a_plan_without_a_grasp_shows_the_outcomes(self):
        ring = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * 1.0
        faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1]]
        faces += [[2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
        result = prehend.plan(prehend.make_scene((ring, faces)), few())
        page = Page(result._repr_html_())
        self.assertEqual(result.status, "object_too_large")
        self.assertEqual(page.images, [])
        self.assertIn(result.reason, page.texts)

    def test_names_are_no_markup(self):
        mesh = self.result.scene.object
        nasty = "<b>&amp;\"'</b><script>"
        scene = prehend.make_scene(mesh, name=nasty)
        result = prehend.plan(scene, few())
        text = result._repr_html_()
        self.assertNotIn("<script", text)
        self.assertIn(f"{scene.name}: {result.status}", "".join(Page(text).texts))


class LearnedOrders(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = pathlib.Path(cls.folder.name)
        header = (SOURCE / "planner/plan/learn/grasp_features.h").read_text()
        names = header.split("kGraspFeatures = {")[1].split("};")[0]
        version = int(re.search(r"kGraspFeaturesVersion = (\d+)", header)[1])
        cls.content = {
            "format": "prehend trees 1",
            "features_version": version,
            "features": re.findall(r'"(\w+)"', names),
            "hands": ["barrett"],
            "any_hand": False,
            "objects": 1,
            "trials": 10,
            "base": 0.1,
            "trees": [  # rims, and what else is far from the centre, come last
                {
                    "feature": [4, -1, -1],
                    "threshold": [0.5, 0, 0],
                    "left": [1, -1, -1],
                    "right": [2, -1, -1],
                    "value": [0, 0.5, -0.5],
                }
            ],
        }
        cls.file = cls.path / "small.json"
        cls.file.write_text(json.dumps(cls.content))

    def test_the_program_writes_the_same_bytes(self):
        words = ["plan", "mug", "--trials", "40", "--no-report", "--model", str(self.file)]
        subprocess.run(
            [os.environ["PREHEND_PROGRAM"], *words, "--out", str(self.path / "out")],
            check=True,
            capture_output=True,
        )
        model = planning.load_model(self.file)
        self.assertEqual((model.name, model.hands, model.trials), ("small", ["barrett"], 10))
        order = options.LearnedOrder(model=model)
        result = prehend.plan(prehend.load_scene("mug"), few(learned=order))
        written = (self.path / "out" / "grasps.json").read_bytes()
        self.assertEqual(files.grasps_json(result).encode(), written)
        self.assertIn(b'"small"', written)

    def test_options_of_the_order(self):
        order = options.LearnedOrder(variety=0.25)
        self.assertIsNone(order.model)
        chosen = few(learned=order)
        self.assertEqual(chosen.search.learned.variety, 0.25)
        with self.assertRaisesRegex(prehend.InputError, "learned: has no model"):
            prehend.plan(prehend.load_scene("mug"), chosen)
        with self.assertRaisesRegex(prehend.InputError, "LearnedOrder.unordered"):
            options.LearnedOrder(unordered=2.0)

    def test_models_that_do_not_fit(self):
        with self.assertRaisesRegex(prehend.InputError, "nowhere.json"):
            planning.load_model(self.path / "nowhere.json")
        order = options.LearnedOrder(model=planning.load_model(self.file))
        with self.assertRaisesRegex(prehend.InputError, "trained for other hands"):
            prehend.plan(prehend.load_scene("mug", hand="parallel_jaw"), few(learned=order))


class Decompositions(unittest.TestCase):
    def test_distances_of_the_surface(self):
        found = planning.decompose(prehend.load_scene("mug").object)
        self.assertEqual(len(found.share), len(found.primitives))
        self.assertEqual(len(found.distances_of), len(found.primitives))
        self.assertGreater(found.tolerance, 0.0)
        for distances in (found.distances, *found.distances_of):
            self.assertLessEqual(distances.median, distances.percentile_95)
            self.assertLessEqual(distances.percentile_95, distances.largest)

    def test_a_plan_has_that_of_its_object(self):
        result = prehend.plan(prehend.load_scene("mug"), few())
        found = result.solids
        self.assertLess(len(found.primitives), len(result.primitives))  # a mug has a rim
        for one, solid in zip(result.primitives, found.primitives):
            self.assertEqual(one.shape, solid.shape)
        self.assertIsNone(prehend.evaluate(prehend.load_scene("mug"), []).solids)


if __name__ == "__main__":
    unittest.main()
