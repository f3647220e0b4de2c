"""Tests of validation.compare_executions: the same bytes as the program, consistent figures, refusals."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import prehend
from prehend import validation

SCORES = {"force_closure", "epsilon", "volume", "weight_given", "weight_worst", "success"}


def rim_grasps(count):
    """The parallel gripper over the rim of the mug, ever higher: the lower ones lifted it."""
    return {
        "format": "prehend truth 1",
        "hand": "parallel_jaw",
        "objects": [{"name": "mug", "scene": "mug"}],
        "executions": [
            {
                "object": "mug",
                "session": "monday" if i % 2 == 0 else "tuesday",
                "X_object_hand": {
                    "position": [-0.05, 0.0, 0.13 + 0.08 * i / count],
                    "quaternion_wxyz": [0, 1, 0, 0],
                },
                "preshape": "open",
                "lifted": 2 * i < count,
            }
            for i in range(count)
        ],
    }


def draft():
    options = prehend.plan_options("draft")
    return prehend.EvaluateOptions(trial=options.trial, uncertainty=options.uncertainty)


class Truth(unittest.TestCase):
    """One small file, compared once."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = pathlib.Path(cls.folder.name)
        cls.file = cls.path / "executed.json"
        cls.file.write_text(json.dumps(rim_grasps(12)))
        cls.report = validation.compare_executions(cls.file, draft(), resamples=50)

    def test_the_program_writes_the_same_bytes(self):
        out = self.path / "out"
        program = os.environ["PREHEND_PROGRAM"]
        words = ["--resamples", "50", "--accuracy", "draft", "--out", str(out)]
        run = subprocess.run(
            [program, "truth", str(self.file), *words], check=True, capture_output=True
        )
        self.assertEqual(self.report.json.encode(), (out / "truth.json").read_bytes())
        self.assertEqual(self.report.html.encode(), (out / "truth.html").read_bytes())
        self.assertTrue(run.stdout.startswith(str(self.report).encode()))
        self.report.save_json(self.path / "saved.json")
        self.report.save_html(self.path / "saved.html")
        self.assertEqual((self.path / "saved.json").read_text(), self.report.json)
        self.assertEqual((self.path / "saved.html").read_text(), self.report.html)

    def test_figures_belong_together(self):
        report = self.report
        self.assertEqual((report.lifted, report.failed), (6, 6))
        self.assertEqual(sum(report.outcomes.values()), 12)
        self.assertLess(SCORES, set(report.scores))
        self.assertEqual(report.settings["groups"], "session")
        self.assertEqual([part.name for part in report.sessions], ["monday", "tuesday"])
        self.assertEqual(report.objects[0].auc["epsilon"], report.scores["epsilon"].auc)
        self.assertEqual(report.frames.grasps, 12)
        self.assertEqual(sum(report.frames.object.values()), 12)
        for name, score in report.scores.items():
            with self.subTest(name):
                shares, below = score.roc[:, 0], score.roc[:, 1]
                area = np.sum(np.diff(shares) * (below[1:] + below[:-1]) / 2.0)
                self.assertAlmostEqual(score.auc, area)
                self.assertLessEqual(score.interval[0], score.interval[1])
                epsilon = report.scores["epsilon"].auc
                self.assertAlmostEqual(score.over_epsilon, score.auc - epsilon)

    def test_calibration_of_probabilities_only(self):
        scores = self.report.scores
        self.assertIsNone(scores["epsilon"].calibration)
        bins = scores["success"].calibration.bins
        self.assertEqual(len(bins), 10)
        self.assertEqual(sum(one.count for one in bins), 12)
        self.assertEqual(sum(one.lifted for one in bins), 6)
        error = sum(o.count * abs(o.predicted - o.observed) for o in bins if o.count) / 12
        self.assertAlmostEqual(scores["success"].calibration.expected_error, error)
        self.assertAlmostEqual(scores["success"].calibration.brier_of_base_rate, 0.25)

    def test_keywords_are_the_options_of_the_program(self):
        one = validation.compare_executions(
            self.file, draft(), volumes=False, groups="each", resamples=20, threads=1
        )
        self.assertNotIn("volume", one.scores)
        self.assertEqual(one.settings["groups"], "each")
        self.assertEqual(one.settings["resamples"], 20)
        self.assertEqual(one.groups_drawn, 12)
        two = validation.compare_executions(
            self.file, draft(), volumes=False, groups="each", resamples=20, threads=2
        )
        self.assertEqual(one.json, two.json)

    def test_a_frame_that_is_wrong_is_suspected(self):
        file = rim_grasps(12)
        for execution in file["executions"]:
            execution["X_object_hand"]["position"][2] -= 0.2
        shifted = self.path / "shifted.json"
        shifted.write_text(json.dumps(file))
        frames = validation.compare_executions(shifted, draft(), volumes=False, resamples=1).frames
        self.assertIsNotNone(frames.suspicion)
        self.assertGreater(frames.suspicion.between, frames.object["between"])
        self.assertIn(frames.suspicion.change, frames.words)


class Refusals(unittest.TestCase):
    def refused(self, words, *arguments, **keywords):
        with self.assertRaises(prehend.InputError) as caught:
            validation.compare_executions(*arguments, **keywords)
        self.assertIn(words, str(caught.exception))
        return caught.exception

    def test_arguments(self):
        self.refused("groups: must be object, session, both or each", "x.json", groups="objects")
        self.refused("groups: must be object, session, both or each", "x.json", groups="")
        self.refused("resamples: must be from 1 to 1000000 (0)", "x.json", resamples=0)
        self.refused("threads", "x.json", threads=-1)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "executed.json"
            self.refused("executed.json", file)
            content = rim_grasps(4)
            content["executions"][1]["lifte"] = True
            file.write_text(json.dumps(content))
            error = self.refused("executions[1].lifte", file)
            self.assertEqual(error.field, "executions[1].lifte")

    def test_cancelled(self):
        cancellation = prehend.Cancellation()
        cancellation.request()
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "executed.json"
            file.write_text(json.dumps(rim_grasps(4)))
            with self.assertRaises(prehend.Cancelled):
                validation.compare_executions(file, draft(), cancellation=cancellation)


if __name__ == "__main__":
    unittest.main()
