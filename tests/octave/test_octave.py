"""Runs the tests of planner/live/octave, which are scripts of Octave, against servers."""

import json
import os
import re
import socket
import subprocess
import unittest

from graspit_server import GraspitServer

FOLDER = os.path.dirname(os.path.realpath(__file__))
CLIENT = os.path.join(FOLDER, "..", "..", "planner", "live", "octave")
PROGRAM = os.environ["PREHEND_PROGRAM"]

# prehend's own server of GraspIt!'s protocol: the words that start it on a free port, and what it
# prints of that port. The test of it runs as soon as `serve` knows the first word.
GRASPIT_WORDS = ["--graspit", "0"]
GRASPIT_PORT = re.compile(r"GraspIt.*port (\d+)|port (\d+).*GraspIt", re.IGNORECASE)
LINES_PORT = re.compile(r"port (\d+): one JSON text a line")


def serve_knows(word):
    words = subprocess.run([PROGRAM, "serve", "--help"], capture_output=True, text=True, check=True)
    return word in words.stdout


class Served:
    """`prehend serve`; `port_of` waits for the line that has a port."""

    def __init__(self, *words):
        self._process = subprocess.Popen(
            [PROGRAM, "serve", "--tcp", "0", *words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        self._said = ""

    def port_of(self, pattern):
        while not pattern.search(self._said):
            line = self._process.stdout.readline()
            if not line:
                raise AssertionError(f"the server has not said its port, but: {self._said}")
            self._said += line
        return next(port for port in pattern.search(self._said).groups() if port)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.terminate()
        self._process.communicate()


def ask(port, request):
    """The reply to one request of prehend's own protocol."""
    with socket.create_connection(("127.0.0.1", int(port))) as connection, connection.makefile("rb") as lines:
        connection.sendall(json.dumps(request).encode() + b"\n")
        for line in lines:
            message = json.loads(line)
            if "ok" in message:
                return message
    raise AssertionError("no reply")


class Scripts(unittest.TestCase):
    def run_script(self, name, port):
        ran = subprocess.run(
            ["octave-cli", "-q", "--norc", "--path", CLIENT, os.path.join(FOLDER, name)],
            env={**os.environ, "PREHEND_TEST_PORT": str(port)},
            capture_output=True,
            text=True,
        )
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
        # A script that ends early by itself must not count.
        self.assertIn("all passed", ran.stdout, ran.stderr)

    def test_a_session(self):
        with Served() as served:
            self.run_script("session_script.m", served.port_of(LINES_PORT))

    def test_the_formats_of_graspit(self):
        with GraspitServer() as server:
            self.run_script("graspit_script.m", server.port)
            command, step = server.lines[0].split(" ")
            self.assertEqual((command, float(step)), ("moveDynamicBodies", 0.0025))
            self.assertIn("moveDynamicBodies", server.lines)
            self.assertIn("getAverageContacts 3 6 9 12", server.lines)
            self.assertIn("getContacts 2 ALL", server.lines)
            self.assertIn("moveDOFs 2 4 0.5 0.25 1 0 0.5 0.5 0.5 0.5", server.lines)
            self.assertEqual(server.lines.count("moveToContacts"), 1)

    @unittest.skipUnless(serve_knows(GRASPIT_WORDS[0]), f"serve has no {GRASPIT_WORDS[0]} yet")
    def test_the_control_loop_with_prehend(self):
        with Served(*GRASPIT_WORDS) as served:
            scene = {"id": 1, "command": "scene.load", "scene": "mug_on_table"}
            self.assertTrue(ask(served.port_of(LINES_PORT), scene)["ok"])
            self.run_script("control_loop_script.m", served.port_of(GRASPIT_PORT))


if __name__ == "__main__":
    unittest.main()
