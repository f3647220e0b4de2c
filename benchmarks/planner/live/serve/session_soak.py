"""Four clients that give a live session ten thousand lines, garbage among them.

    PREHEND_PROGRAM=PROGRAM python3 benchmarks/planner/live/serve/session_soak.py [LINES]

Every line has to be answered by one line, a client that never reads must not hold up the others,
and memory must stay: printed are the answers, the resident memory after each quarter, and how long
Ctrl-C took. The exit status is 1 where a line is not answered, or memory grows by more than 5 %
from the first quarter's end to the last's.
"""

import json
import os
import random
import signal
import socket
import subprocess
import sys
import threading
import time

CLIENTS = 4
HUGE = 100 << 20  # bytes of the longest lines
HUGE_EVERY = 300  # lines of a client, so that the first quarter has some
MATERIALS = ["glass", "metal", "plastic", "wood", "rubber"]


def pose(rng, reach=0.3):
    """A pose somewhere around the object."""
    turn = [rng.gauss(0, 1) for _ in range(4)]
    size = sum(x * x for x in turn) ** 0.5
    return {
        "position": [rng.uniform(-reach, reach) for _ in range(3)],
        "quaternion_wxyz": [x / size for x in turn],
    }


def command(rng):
    """A sound request, most of them cheap."""
    return rng.choice(
        [
            lambda: {"command": "hand.move", "X_world_hand": pose(rng)},
            lambda: {"command": "hand.move", "X_object_hand": pose(rng, 0.15)},
            lambda: {"command": "hand.dofs", "dofs": [rng.uniform(-1, 3) for _ in range(4)]},
            lambda: {"command": "hand.open"},
            lambda: {"command": "hand.approach"},
            lambda: {"command": "hand.auto_grasp"},
            lambda: {"command": "contacts"},
            lambda: {"command": "collisions"},
            lambda: {"command": "state"},
            lambda: {"command": "undo"},
            lambda: {"command": "redo"},
            lambda: {"command": "object.change", "mass": rng.uniform(0.1, 2)},
            lambda: {"command": "object.change", "material": rng.choice(MATERIALS)},
            lambda: {"command": "forces", "force_object": [0, 0, -rng.uniform(0, 9)]},
        ]
    )()


def garbage(rng):
    """A line that is no request."""
    sound = json.dumps(command(rng)).encode()
    return rng.choice(
        [
            lambda: sound[: rng.randrange(1, len(sound))],  # cut
            lambda: bytes(rng.choice(range(14, 256)) for _ in range(40)),  # binary
            lambda: b"[" * rng.randrange(1, 100000),  # deep
            lambda: b'{"command":' * 500 + b"1" + b"}" * 500,
            lambda: b'{"command": "hand.dofs", "dofs": [1e999, "x", null]}',
            lambda: b'{"command": "no such thing"}',
            lambda: b'{"id": {}, "command": "state"}',
        ]
    )()


class Soaker(threading.Thread):
    """One client; it waits for the answer of each line before it sends the next."""

    def __init__(self, port, seed, lines):
        super().__init__()
        self.rng = random.Random(seed)
        self.socket = socket.create_connection(("127.0.0.1", port))
        self.reader = self.socket.makefile("rb")
        self.lines = lines
        self.good = self.refused = 0
        self.pause = threading.Event()
        self.pause.set()

    def answer(self):
        while True:
            line = self.reader.readline()
            if not line:
                raise ConnectionError("the session has ended")
            message = json.loads(line)
            if "event" not in message:
                return message

    def run(self):
        for k in range(1, self.lines + 1):
            if k % HUGE_EVERY == 0:
                line = b"x" * HUGE
            elif self.rng.random() < 0.3:
                line = garbage(self.rng)
            else:
                line = json.dumps(command(self.rng)).encode()
            self.socket.sendall(line + b"\n")
            if self.answer()["ok"]:
                self.good += 1
            else:
                self.refused += 1


def resident(pid):
    """Resident memory [MB]."""
    with open(f"/proc/{pid}/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def main():
    lines = int(sys.argv[1]) if len(sys.argv) > 1 else 10000
    program = subprocess.Popen(
        [os.environ["PREHEND_PROGRAM"], "serve", "--tcp", "0"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    port = int(program.stdout.readline().split("port ")[1].split(":")[0])
    starter = Soaker(port, 0, 0)
    starter.socket.sendall(b'{"command": "scene.load", "scene": "mug"}\n')
    assert starter.answer()["ok"]

    # One that asks and never reads.
    deaf = socket.create_connection(("127.0.0.1", port))
    deaf.sendall(b'{"command": "state"}\n' * 500)

    soakers = [Soaker(port, seed, lines // CLIENTS) for seed in range(1, CLIENTS + 1)]
    start = time.monotonic()
    for soaker in soakers:
        soaker.start()
    memory = []
    while any(soaker.is_alive() for soaker in soakers):
        done = sum(soaker.good + soaker.refused for soaker in soakers)
        if done >= (len(memory) + 1) * lines // 4:
            memory.append(resident(program.pid))
            print(f"{done:6d} lines answered, {memory[-1]:.1f} MB", flush=True)
        time.sleep(0.01)
    if len(memory) < 4:
        memory.append(resident(program.pid))
    seconds = time.monotonic() - start
    good = sum(soaker.good for soaker in soakers)
    refused = sum(soaker.refused for soaker in soakers)
    growth = memory[-1] / memory[0] - 1
    print(f"{good} carried out, {refused} refused in {seconds:.0f} s")
    print(f"memory from the first quarter to the end: {100 * growth:+.1f} %")

    begin = time.monotonic()
    program.send_signal(signal.SIGINT)
    status = program.wait()
    print(f"Ctrl-C: exit status {status} after {time.monotonic() - begin:.2f} s")
    return 0 if good + refused == lines // CLIENTS * CLIENTS and growth < 0.05 else 1


if __name__ == "__main__":
    sys.exit(main())
