"""A client of prehend's server: lines of JSON over TCP. Needs the standard library only."""

import collections
import json
import socket
import time


class CommandError(Exception):
    """The server refused a command: field, problem and value as it names them, None where it does not."""

    def __init__(self, error):
        self.field = error.get("field")
        self.problem = error.get("problem")
        self.value = error.get("value")
        parts = [str(part) for part in (self.field, self.problem) if part]
        super().__init__(": ".join(parts) or json.dumps(error))


class Client:
    """A connection. Not for several threads at once.

    timeout: seconds to wait for an answer, None for ever. TimeoutError (socket.timeout before Python
    3.10) is raised after it, ConnectionError when the server ends the connection.
    """

    def __init__(self, host="127.0.0.1", port=4700, token=None, timeout=None):
        self.timeout = timeout
        self._socket = socket.create_connection((host, port), timeout)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._unread = bytearray()
        self._events = collections.deque()
        self._next_id = 1
        if token is not None:
            self._socket.sendall(token.encode() + b"\n")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self._socket.close()

    def call(self, command, **fields):
        """The result of a command. Raises CommandError where it is refused. Events are kept."""
        number = self._next_id
        self._next_id += 1
        request = {**fields, "id": number, "command": command}
        self._socket.settimeout(self.timeout)
        self._socket.sendall(json.dumps(request, allow_nan=False).encode() + b"\n")
        deadline = None if self.timeout is None else time.monotonic() + self.timeout
        while True:
            message = self._message(deadline)
            if "event" in message:
                self._events.append(message)
            elif message.get("id", number) != number:
                continue  # of a call that was given up
            elif message.get("ok"):
                return message.get("result")
            else:
                raise CommandError(message.get("error") or {})

    def events(self, timeout=0.0):
        """Yields the events that have come, and those of the next `timeout` seconds (None: for ever)."""
        deadline = None if timeout is None else time.monotonic() + timeout
        while True:
            while self._events:
                yield self._events.popleft()
            try:
                message = self._message(deadline)
            except (socket.timeout, BlockingIOError):
                return
            if "event" in message:
                yield message

    def _message(self, deadline):
        looked = 0
        while True:
            end = self._unread.find(b"\n", looked)
            if end >= 0:
                line = bytes(self._unread[:end])
                del self._unread[: end + 1]
                return json.loads(line)
            looked = len(self._unread)
            left = None if deadline is None else max(0.0, deadline - time.monotonic())
            self._socket.settimeout(left)
            piece = self._socket.recv(65536)
            if not piece:
                raise ConnectionError("the server ended the connection")
            self._unread += piece
