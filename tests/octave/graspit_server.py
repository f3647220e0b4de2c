"""A server of GraspIt!'s text protocol with a made-up world, which answers in its formats."""

import socket
import threading

BODIES = ["glass", "table top"] + [f"link {number}" for number in range(2, 14)]
ROBOTS = ["Puma560", "table robot", "Barrett"]
DOFS = [6, 1, 4]
LARGEST_FORCE = 5.0
TIMESTEP = 0.01


def contacts_of(body):
    """Wrench and place of each contact: the fingertips have two, other bodies none."""
    if body not in (6, 9, 12):
        return []
    return [([body, 0.5, -1e-7, k, 0, 0], [0.001 * body, k, -k]) for k in (1, 3)]


def words(numbers):
    return " ".join(f"{number:.9g}" for number in numbers)


class Refused(Exception):
    pass


class GraspitServer:
    """Serves each client on a thread of its own, until it says "end". `lines` is what came."""

    def __init__(self):
        self.lines = []
        self._values = [[0.125 * d for d in range(count)] for count in DOFS]
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = self._listener.getsockname()[1]
        self._threads = [threading.Thread(target=self._accept)]

    def __enter__(self):
        self._threads[0].start()
        return self

    def __exit__(self, *_):
        self._listener.shutdown(socket.SHUT_RDWR)
        for thread in self._threads:
            thread.join()
        self._listener.close()

    def _accept(self):
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            self._threads.append(threading.Thread(target=self._serve, args=(connection,)))
            self._threads[-1].start()

    def _serve(self, connection):
        with connection, connection.makefile("r", newline="\n") as lines:
            for line in lines:
                self.lines.append(line[:-1])
                if line == "end\n":
                    return
                answer = "".join(each + "\n" for each in self._answer(line.split())).encode()
                for at in range(0, len(answer), 7):  # cut anywhere
                    connection.sendall(answer[at : at + 7])

    def _answer(self, asked):
        """The lines of a reply; what is not understood has none."""
        answers = getattr(self, "_" + asked[0], None)
        lines = []
        try:
            lines.extend(answers(asked[1:]) if answers else [])
        except Refused as refused:
            lines.append(f"Error: {refused}")
        return lines

    def _listed(self, asked, kind, names):
        if asked[0] == "ALL":
            return [str(len(names))], list(range(len(names)))
        numbers = [int(number) for number in asked[1 : 1 + int(asked[0])]]
        for number in numbers:
            if not 0 <= number < len(names):
                raise Refused(f"Cannot find {kind} {number}")
        return [], numbers

    def _getBodyName(self, asked):
        count, numbers = self._listed(asked, "body", BODIES)
        return count + [BODIES[number] for number in numbers]

    def _getRobotName(self, asked):
        count, numbers = self._listed(asked, "robot", ROBOTS)
        return count + [ROBOTS[number] for number in numbers]

    def _getContacts(self, asked):
        lines, numbers = self._listed(asked[1:], "body", BODIES)
        for number in numbers:
            contacts = contacts_of(number)
            lines.append(str(len(contacts)))
            for wrench, place in contacts:
                lines.append(words(wrench))
                if int(asked[0]) > 1:
                    lines.append(words(place))
        return lines

    def _getAverageContacts(self, asked):
        lines, numbers = self._listed(asked, "body", BODIES)
        for number in numbers:
            contacts = contacts_of(number) or [([0] * 6, [0] * 3)]
            for part in (0, 1):
                columns = zip(*(contact[part] for contact in contacts))
                lines.append(words(sum(column) / len(contacts) for column in columns))
        return lines

    def _getDOFVals(self, asked):
        lines, numbers = self._listed(asked, "robot", ROBOTS)
        for number in numbers:
            lines += [str(DOFS[number])] + [words([value]) for value in self._values[number]]
        return lines

    def _moveDOFs(self, asked):
        robot, count = int(asked[0]), int(asked[1])
        if robot >= len(ROBOTS):
            raise Refused("Robot does not exist.")
        if count != DOFS[robot]:
            raise Refused(f"robot has {DOFS[robot]} DOF.")
        self._values[robot] = [min(1.0, float(value)) for value in asked[2 : 2 + count]]
        return [words([value]) for value in self._values[robot]]

    def _setDOFForces(self, asked):
        _, robots = self._listed(asked, "robot", ROBOTS)
        count, forces = int(asked[2]), [float(force) for force in asked[3:]]
        if count != DOFS[robots[0]]:
            raise Refused(f"robot has {DOFS[robots[0]]} DOF.")
        return [words([max(-LARGEST_FORCE, min(LARGEST_FORCE, force))]) for force in forces]

    def _moveDynamicBodies(self, asked):
        step = float(asked[0]) if asked else TIMESTEP
        if step > 1.0:
            raise Refused("Timestep failsafe reached.")
        return [words([step])]

    def _computeNewVelocities(self, asked):
        return ["0" if float(asked[0]) > 0.0 else "-1"]
