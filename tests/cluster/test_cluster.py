"""Batches through a real Slurm and GNU parallel give the bytes of a run without either."""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import one_machine_slurm
from one_machine_slurm import Slurm, wait_until

PREHEND = os.environ["PREHEND_PROGRAM"]
SHARDS = 8
# Names that scripts are easily mistaken about.
AWKWARD = "it's \"so\" $HOME `id` {}"

CUBE = """v 0 0 0
v 0.04 0 0
v 0 0.04 0
v 0.04 0.04 0
v 0 0 {height}
v 0.04 0 {height}
v 0 0.04 {height}
v 0.04 0.04 {height}
f 1 3 4 2
f 5 6 8 7
f 1 2 6 5
f 3 7 8 4
f 1 5 7 3
f 2 4 8 6
"""


def files_of(folder):
    return {str(file.relative_to(folder)): file.read_bytes()
            for file in sorted(folder.rglob("*")) if file.is_file()}


class Batch(unittest.TestCase):
    environment = dict(os.environ)

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="prehend-cluster-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        for i in range(SHARDS):
            (self.folder / f"cuboid_{i}.obj").write_text(CUBE.format(height=0.04 + 0.01 * i))
        self.file = self.folder / "batch.json"
        self.file.write_text(json.dumps({
            "objects": [f"cuboid_{i}.obj" for i in range(SHARDS)], "hands": ["franka_hand"],
            "settings": [{"accuracy": "standard", "trials": 4000}]}))
        self.out = self.folder / AWKWARD

    def run_prehend(self, *words, status=0):
        run = subprocess.run([PREHEND, "batch", *map(str, words)], env=self.environment, check=False,
                             capture_output=True, text=True)
        self.assertEqual(run.returncode, status, run.stderr)
        return run.stdout if status == 0 else run.stderr

    def submit(self, *words, status=0):
        return self.run_prehend("submit", self.file, "-o", self.out, "--shards", SHARDS,
                                *words, status=status)

    def queue(self):
        return self.run_prehend("queue", "-o", self.out)

    def shard_processes(self, node=None):
        """The processes of the program that are at a shard of this batch, on all nodes or on one."""
        out = os.fsencode(self.out)
        return [pid for pid, words, environment in one_machine_slurm.processes()
                if out in words and b"--shard" in words
                and (node is None or f"SLURMD_NODENAME={node}".encode() in environment)]

    def expect_merged_as_without_a_cluster(self):
        alone = self.folder / "alone"
        subprocess.run([PREHEND, "batch", self.file, "-o", alone], check=True, capture_output=True)
        subprocess.run([PREHEND, "batch", "merge", self.file, "-o", alone], check=True, capture_output=True)
        expected = files_of(alone / "merged")
        self.assertTrue(expected)
        self.assertEqual(files_of(self.out / "merged"), expected)


class SlurmTest(Batch):
    def setUp(self):
        super().setUp()
        self.slurm = Slurm(self.folder / "slurm")
        self.slurm.__enter__()
        self.addCleanup(self.slurm.__exit__)
        self.environment = self.slurm.environment

    def submit_to_slurm(self, *words):
        return self.submit("--engine", "slurm", "--memory", "100M", *words)

    def wait_for_task_on(self, node):
        def runs_there():
            tasks = self.slurm.tasks()
            self.assertTrue(tasks, f"all has ended: {self.queue()}")
            return self.shard_processes(node) and any(row[1:3] == ["RUNNING", node] for row in tasks)

        wait_until(runs_there, f"a task runs on {node}")

    def wait_for_end(self):
        def is_empty():
            self.slurm.start_waiting_tasks()
            return not self.slurm.tasks()

        wait_until(is_empty, "the queue is empty")

    def test_a_node_that_fails(self):
        self.assertIn(f"submitted {SHARDS} shards: Slurm job ", self.submit_to_slurm())
        # A task may end between two looks at the queue, before the next one runs.
        running = r"Slurm job \d+: .*running.* of 8 shards; merge pending\n"
        wait_until(lambda: re.fullmatch(running, self.queue()), "the queue says that tasks run")
        self.assertIn("still waits or runs", self.submit("--engine", "slurm", status=2))
        self.wait_for_task_on("n1")
        self.slurm.kill_node("n1")
        wait_until(lambda: any(row[3] > 0 for row in self.slurm.tasks()), "a task starts again")
        self.assertIn("started again", self.queue())
        self.wait_for_end()
        self.assertRegex(self.queue(), r"has ended: 8 completed of 8 shards; merge completed\n$")
        self.expect_merged_as_without_a_cluster()

    def signal_until_one_starts_again(self):
        """Returns the task that does. One that is signalled may just have come to its end."""
        while True:
            self.wait_for_task_on("n1")
            try:
                task = self.slurm.signal_task("n1", signal.SIGUSR1)
            except LookupError:
                continue
            restarts = wait_until(lambda: {row[0]: row[3] for row in self.slurm.tasks()}.get(task, -1),
                                  "the task starts again or ends")
            if restarts > 0:
                return task

    def test_time_that_ends(self):
        """What Slurm sends before the time limit, which is minutes away at least, is sent here by hand."""
        self.submit_to_slurm()
        task = self.signal_until_one_starts_again()
        self.wait_for_end()
        self.assertIn("time limit is near", (self.out / "log" / f"{task}.txt").read_text())
        self.expect_merged_as_without_a_cluster()

    def test_cancel_and_go_on(self):
        self.submit_to_slurm("--at-once", "1")
        self.wait_for_task_on("n0")
        self.assertIn("cancelled", self.run_prehend("cancel", "-o", self.out))
        self.wait_for_end()
        self.assertEqual(self.shard_processes(), [])
        self.assertFalse((self.out / "merged").exists())
        self.assertIn("ended already", self.run_prehend("cancel", "-o", self.out))
        self.submit_to_slurm()
        self.wait_for_end()
        self.expect_merged_as_without_a_cluster()

    def test_slurm_refuses(self):
        complaint = self.submit("--engine", "slurm", "--partition", "none", status=2)
        self.assertRegex(complaint, r"^prehend: sbatch: .*partition.*\n$")
        self.assertIn("no job", self.queue())


class ParallelTest(Batch):
    def submit_to_parallel(self):
        self.submit("--engine", "parallel", "--at-once", "2")

    def process_of_job(self):
        return json.loads((self.out / "job.json").read_text())["process"]["pid"]

    def wait_for_end(self):
        wait_until(lambda: "has ended" in self.queue(), "GNU parallel has ended")

    def test_a_worker_that_is_killed(self):
        self.submit_to_parallel()
        one_machine_slurm.stop(wait_until(self.shard_processes, "a shard runs")[-1])
        self.assertIn("still waits or runs", self.submit("--engine", "parallel", status=2))
        self.wait_for_end()
        self.assertIn("has ended: 8 completed of 8 shards", self.queue())
        self.expect_merged_as_without_a_cluster()

    def test_cancel_and_go_on(self):
        self.submit_to_parallel()
        wait_until(self.shard_processes, "a shard runs")
        self.assertIn("cancelled", self.run_prehend("cancel", "-o", self.out))
        wait_until(lambda: not self.shard_processes(), "its shards have ended", 10)
        self.assertIn("ended already", self.run_prehend("cancel", "-o", self.out))
        self.assertFalse((self.out / "merged").exists())
        self.submit_to_parallel()
        self.wait_for_end()
        self.expect_merged_as_without_a_cluster()

    def test_cancel_leaves_a_stranger_alone(self):
        self.submit_to_parallel()
        self.wait_for_end()
        file = self.out / "job.json"
        job = json.loads(file.read_text())
        with subprocess.Popen(["sleep", "600"], start_new_session=True) as stranger:
            job["process"]["pid"] = stranger.pid
            file.write_text(json.dumps(job))
            self.assertIn("ended already", self.run_prehend("cancel", "-o", self.out))
            self.assertIsNone(stranger.poll())
            stranger.kill()


if __name__ == "__main__":
    # Ends by an exception, so that what was started is stopped.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    unittest.main()
