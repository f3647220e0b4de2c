// The protocol over a WebSocket: requests that are answered, and events.

// What the session has refused, with the field that it names.
class Refusal extends Error {
  constructor({field, problem, value}) {
    super((field ? `${field}: ` : '') + problem + (value ? ` (${value})` : ''));
    this.field = field;
  }
}

// There is no connection, or it was lost before the answer came.
class Disconnected extends Error {}

const retryAfter = 1000;  // ms without a connection

class Connection {
  // `opened` is called whenever there is a connection, `closed` when it is lost, `event` with each
  // event.
  constructor({opened, closed, event}) {
    this.handlers = {opened, closed, event};
    this.waiting = new Map();  // by the request's number
    this.last = 0;
    this.open();
  }

  open() {
    const address = new URL('/socket', window.location.href);
    address.protocol = window.location.protocol === 'https:' ? 'wss:' : 'ws:';
    address.search = window.location.search;
    this.socket = new WebSocket(address.href);
    this.socket.onopen = () => this.handlers.opened();
    this.socket.onmessage = (message) => this.take(JSON.parse(message.data));
    this.socket.onclose = () => this.lose();
  }

  lose() {
    for (const {reject} of this.waiting.values()) {
      reject(new Disconnected('the connection was lost'));
    }
    this.waiting.clear();
    this.handlers.closed();
    setTimeout(() => this.open(), retryAfter);
  }

  take(message) {
    if (message.event) {
      this.handlers.event(message);
      return;
    }
    const asked = this.waiting.get(message.id);
    if (!asked) return;
    this.waiting.delete(message.id);
    if (message.ok) {
      asked.resolve(message.result);
    } else {
      asked.reject(new Refusal(message.error));
    }
  }

  // Promises the result; fails with a Refusal or as Disconnected.
  call(command, fields = {}) {
    if (this.socket.readyState !== WebSocket.OPEN) {
      return Promise.reject(new Disconnected('there is no connection'));
    }
    const id = ++this.last;
    this.socket.send(JSON.stringify({id, command, ...fields}));
    return new Promise((resolve, reject) => this.waiting.set(id, {resolve, reject}));
  }
}

// Runs an asynchronous function once at a time; of what is asked for meanwhile only the last is
// done. This is how a pointer that moves faster than the session answers stays in step with it.
class Coalescer {
  constructor(run) {
    this.run = run;
    this.busy = false;
    this.next = null;
  }

  async ask(...words) {
    this.next = words;
    if (this.busy) return;
    this.busy = true;
    while (this.next) {
      const now = this.next;
      this.next = null;
      try {
        await this.run(...now);
      } catch (error) {
        reportError(error);  // in the console; what is asked for later is done all the same
      }
    }
    this.busy = false;
  }
}
