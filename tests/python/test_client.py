"""Tests of the client of the server, against a server of lines made here."""

import json
import os
import socket
import sys
import threading
import unittest

sys.path.insert(0, os.path.join(os.environ["PREHEND_SOURCE"], "planner", "python", "client"))

from prehend_client import Client, CommandError  # noqa: E402


class LineServer:
    """Answers one client: `answers` makes the bytes to send of each line."""

    def __init__(self, answers):
        self.lines = []
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = self._listener.getsockname()[1]
        self._thread = threading.Thread(target=self._serve, args=(answers,))
        self._thread.start()

    def _serve(self, answers):
        connection, _ = self._listener.accept()
        with connection, connection.makefile("rb") as lines:
            for line in lines:
                self.lines.append(line)
                answer = answers(line)
                if answer is None:
                    return
                for at in range(0, len(answer), 7):  # cut anywhere
                    connection.sendall(answer[at : at + 7])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._thread.join()
        self._listener.close()


def echo(line):
    request = json.loads(line)
    answer = {"id": request["id"], "ok": True, "result": request}
    return json.dumps(answer).encode() + b"\n"


class Calls(unittest.TestCase):
    def test_a_result_comes_back(self):
        with LineServer(echo) as server, Client(port=server.port, timeout=60) as client:
            self.assertEqual(client.call("close", hand="grün")["hand"], "grün")
            self.assertEqual(client.call("open"), {"id": 2, "command": "open"})

    def test_a_refusal_is_raised_with_its_parts(self):
        def refuse(line):
            error = {"field": "body", "problem": "unknown", "value": "mug"}
            return json.dumps({"id": 1, "ok": False, "error": error}).encode() + b"\n"

        with LineServer(refuse) as server, Client(port=server.port, timeout=60) as client:
            with self.assertRaises(CommandError) as raised:
                client.call("contacts", body="mug")
            self.assertEqual(raised.exception.field, "body")
            self.assertEqual(raised.exception.problem, "unknown")
            self.assertEqual(raised.exception.value, "mug")
            self.assertEqual(str(raised.exception), "body: unknown")

    def test_an_answer_without_an_id_is_the_calls(self):
        line = b'{"ok":false,"error":{"problem":"not UTF-8"}}\n'
        with LineServer(lambda _: line) as server, Client(port=server.port, timeout=60) as client:
            with self.assertRaisesRegex(CommandError, "not UTF-8"):
                client.call("contacts")

    def test_events_are_kept_in_order(self):
        def with_events(line):
            return b'{"event":"a"}\n' + echo(line)[:-1] + b'\n{"event":"b"}\n'

        with LineServer(with_events) as server, Client(port=server.port, timeout=60) as client:
            client.call("plan")
            client.call("plan")  # its answer comes after the second event
            events = client.events(timeout=60)
            self.assertEqual([next(events)["event"] for _ in range(4)], ["a", "b", "a", "b"])
            self.assertEqual(list(client.events()), [])

    def test_the_token_comes_first(self):
        def after_token(line):
            return b"" if line == b"secret\n" else echo(line)

        with LineServer(after_token) as server:
            with Client(port=server.port, token="secret", timeout=60) as client:
                client.call("open")
            self.assertEqual(server.lines[0], b"secret\n")

    def test_the_end_of_the_connection_is_an_error(self):
        with LineServer(lambda _: None) as server, Client(port=server.port, timeout=60) as client:
            with self.assertRaises(ConnectionError):
                client.call("quit")


if __name__ == "__main__":
    unittest.main()
