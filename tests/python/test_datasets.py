"""Tests of files of data sets: what h5py reads of ours, and what evaluate reads of h5py's."""

import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

try:
    import h5py
except ImportError:
    h5py = None

CUBE = """v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 1 3 2
f 1 4 3
f 5 6 7
f 5 7 8
f 1 2 6
f 1 6 5
f 2 3 7
f 2 7 6
f 3 4 8
f 3 8 7
f 4 1 5
f 4 5 8
"""

# Of a file of ACRONYM: type and shape of each data set, with 3 grasps.
ACRONYM = {
    "grasps/transforms": ("<f8", (3, 4, 4)),
    "grasps/qualities/prehend/object_in_gripper": ("<i8", (3,)),
    "grasps/qualities/prehend/object_motion_during_closing_linear": ("<f8", (3,)),
    "grasps/qualities/prehend/object_motion_during_closing_angular": ("<f8", (3,)),
    "gripper/type": ("|O", ()),
    "gripper/configuration": ("<f8", (1,)),
    "object/file": ("|O", ()),
    "object/scale": ("<f8", ()),
    "object/density": ("<f8", ()),
    "object/friction": ("<f8", ()),
    "object/mass": ("<f8", ()),
    "object/volume": ("<f8", ()),
    "object/com": ("<f8", (3,)),
    "object/inertia": ("<f8", (3, 3)),
}

OURS = {
    "prehend/format": ("<i8", ()),
    "prehend/version": ("|O", ()),
    "prehend/settings": ("|O", ()),
    "prehend/outcome": ("|i1", (3,)),
    "prehend/outcome_names": ("|O", (15,)),
    "prehend/epsilon_lower": ("<f8", (3,)),
    "prehend/epsilon_upper": ("<f8", (3,)),
    "prehend/aim": ("<f8", (3, 4, 4)),
    "prehend/approach": ("<f8", (3, 3)),
    "prehend/dof_names": ("|O", (1,)),
    "prehend/dofs": ("<f8", (3, 1)),
    "prehend/joint_names": ("|O", (2,)),
    "prehend/joints": ("<f8", (3, 2)),
    "prehend/feature_names": ("|O", (2,)),
    "prehend/features": ("<f4", (3, 2)),
    "prehend/contacts/start": ("<i8", (4,)),
    "prehend/contacts/position": ("<f8", (2, 3)),
    "prehend/contacts/normal": ("<f8", (2, 3)),
    "prehend/contacts/link": ("<i4", (2,)),
    "prehend/contacts/link_names": ("|O", (2,)),
}


def pose(x, y, z):
    """The hand points along z, its fingers close along x."""
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


class DataSets(unittest.TestCase):
    """A folder with the files that write_sample_sets writes."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = pathlib.Path(cls.folder.name)
        subprocess.run([os.environ["PREHEND_SAMPLE_SETS"], cls.folder.name], check=True)
        (cls.path / "cube.obj").write_text(CUBE)

    def evaluate(self, file, *words):
        out = self.path / "out"
        command = [os.environ["PREHEND_PROGRAM"], "evaluate", str(file), "--no-report"]
        command += ["--accuracy", "draft", "--volumes", "0", "--out", str(out), *words]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def grasps(self):
        return json.loads((self.path / "out" / "grasps.json").read_text())["grasps"]


@unittest.skipIf(h5py is None, "there is no h5py")
class Acronym(DataSets):
    """Files of ACRONYM."""

    def test_names_types_and_shapes(self):
        found = {}
        with h5py.File(self.path / "sample.h5") as file:
            file.visititems(
                lambda name, item: found.update({name: (item.dtype.str, item.shape)})
                if isinstance(item, h5py.Dataset)
                else None
            )
            for name in ("gripper/type", "object/file", "prehend/dof_names"):
                self.assertEqual(h5py.check_string_dtype(file[name].dtype).encoding, "utf-8")
        self.assertEqual(found, {**ACRONYM, **OURS})

    def test_values(self):
        with h5py.File(self.path / "sample.h5") as file:
            np.testing.assert_array_equal(file["grasps/transforms"][0], pose(0, 0, -0.1))
            quality = file["grasps/qualities/prehend"]
            np.testing.assert_array_equal(quality["object_in_gripper"], [1, 0, 0])
            closing = quality["object_motion_during_closing_linear"]
            np.testing.assert_array_equal(closing, [0.001, np.nan, np.nan])
            self.assertEqual(file["gripper/type"].asstr()[()], "panda")
            self.assertEqual(file["object/file"].asstr()[()], "meshes/Cube/cube.obj")
            self.assertEqual(file["object/inertia"][0, 1], 0.1)
            names = file["prehend/outcome_names"].asstr()[:]
            outcomes = list(names[file["prehend/outcome"][:]])
            self.assertEqual(outcomes, ["stable", "no_contact", "hand_blocked"])
            start = file["prehend/contacts/start"][:]
            np.testing.assert_array_equal(start, [0, 2, 2, 2])
            links = file["prehend/contacts/link_names"].asstr()[:]
            self.assertEqual(list(links[file["prehend/contacts/link"][0:2]]), ["left_pad", "right_pad"])
            np.testing.assert_array_equal(file["prehend/dofs"][:, 0], [0.02, np.nan, np.nan])
            np.testing.assert_array_equal(file["prehend/joints"][0], [0.02, -0.02])
            self.assertEqual(json.loads(file["prehend/settings"].asstr()[()]), {"seed": 7})

    def write(self, name, **kinds):
        """Two grasps of the cube from above, one that is far from it, as ACRONYM has them."""
        file = self.path / name
        poses = [pose(0, 0, -0.11), pose(0, 0.005, -0.11), pose(0, 0, -1.0)]
        with h5py.File(file, "w", libver=kinds.get("libver", "earliest")) as h5:
            h5.create_dataset(
                "grasps/transforms",
                data=np.array(poses),
                compression=kinds.get("compression"),
                maxshape=kinds.get("maxshape"),
            )
            held = np.array([1, 0, 0], kinds.get("labels", np.int64))
            h5["grasps/qualities/flex/object_in_gripper"] = held
            h5["gripper/type"] = "panda"
            h5["gripper/configuration"] = np.array([0.04])
            h5["object/file"] = kinds.get("mesh", "meshes/Cube/cube.obj")
            h5["object/scale"] = 0.02
        return file

    def test_evaluate_reads_what_h5py_writes(self):
        for kinds in (
            {},
            {"libver": "latest"},
            {"compression": "gzip", "maxshape": (None, 4, 4)},
            {"labels": np.bool_},
            {"labels": np.int8, "mesh": np.bytes_("cube.obj")},
        ):
            with self.subTest(**kinds):
                run = self.evaluate(self.write("made.h5", **kinds))
                self.assertEqual(run.returncode, 0, run.stderr)
                self.assertIn("2 of 3 agree (66.7 %)", run.stdout)
                self.assertIn(
                    "held there and here 1, there only 0, here only 1, neither 1", run.stdout
                )
                outcomes = [grasp["outcome"] for grasp in self.grasps()]
                self.assertEqual(outcomes, ["stable", "stable", "no_contact"])

    def test_the_scaled_object_is_written_for_others(self):
        run = self.evaluate(self.write("made.h5"))
        self.assertIn("evaluated_scene.json", run.stdout)
        first = self.grasps()
        again = self.evaluate(self.path / "out" / "grasps.json")
        self.assertEqual(again.returncode, 0, again.stderr)
        poses = [grasp["X_object_hand"] for grasp in first]
        self.assertEqual(poses, [grasp["X_object_hand"] for grasp in self.grasps()])

    def test_filters_and_links_to_elsewhere_are_refused(self):
        file = self.write("elsewhere.h5")
        with h5py.File(file, "a") as h5:
            del h5["grasps/transforms"]
            h5["grasps/transforms"] = h5py.ExternalLink("sample.h5", "grasps/transforms")
        run = self.evaluate(file)
        self.assertEqual(run.returncode, 2)
        self.assertIn("grasps/transforms: must not be a link", run.stderr)
        with h5py.File(file, "a") as h5:
            del h5["grasps/transforms"]
            h5.create_dataset("grasps/transforms", data=np.zeros((3, 4, 4)), compression="lzf")
        run = self.evaluate(file)
        self.assertEqual(run.returncode, 2)
        self.assertIn("grasps/transforms: is stored with a filter", run.stderr)

    def test_more_values_than_the_file_can_hold_are_refused(self):
        file = self.write("huge.h5")
        with h5py.File(file, "a") as h5:
            del h5["grasps/transforms"]
            h5.create_dataset("grasps/transforms", (10**9, 4, 4), "f8", chunks=(1000, 4, 4))
        run = self.evaluate(file)
        self.assertEqual(run.returncode, 2)
        self.assertIn("has more values than a file of this size can hold", run.stderr)


class GraspGen(DataSets):
    """Files of GraspGen, and the table."""

    def test_read_as_the_authors_read_them(self):
        grasps = json.loads((self.path / "sample.json").read_text())
        self.assertEqual(grasps["object"], {"file": "meshes/Cube/cube.obj", "scale": 0.02})
        poses = np.array(grasps["grasps"]["transforms"])
        mask = np.array(grasps["grasps"]["object_in_gripper"])
        self.assertEqual(mask.dtype, np.bool_)
        np.testing.assert_array_equal(poses[mask], [pose(0, 0, -0.1)])
        self.assertEqual(len(poses[~mask]), 2)

    def test_evaluate(self):
        grasps = {
            "object": {"file": "cube.obj", "scale": 0.02},
            "grasps": {
                "transforms": [pose(0, 0, -0.11).tolist(), pose(0, 0, -1).tolist()],
                "object_in_gripper": [True, True],
            },
        }
        file = self.path / "graspgen.json"
        file.write_text(json.dumps(grasps))
        refused = self.evaluate(file)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("name one with --hand", refused.stderr)
        run = self.evaluate(file, "--hand", "franka_hand")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("held there and here 1, there only 1", run.stdout)

    def test_the_table(self):
        with open(self.path / "sample.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["outcome"] for row in rows], ["stable", "no_contact", "hand_blocked"])
        self.assertEqual(rows[0]["set"], "sample")
        self.assertEqual(float(rows[0]["object_hand_z"]), -0.1)
        self.assertEqual(rows[0]["contacts"], "2")
        self.assertEqual([float(dof) for dof in rows[0]["dofs"].split()], [0.02])
        self.assertEqual(rows[1]["dofs"], "")


if __name__ == "__main__":
    unittest.main()
