// What the page knows of the session, and how it asks for changes.

// Poses in messages, and as three.js has them.
function poseOf(matrix) {
  const position = new THREE.Vector3();
  const turn = new THREE.Quaternion();
  matrix.decompose(position, turn, new THREE.Vector3());
  return {position: position.toArray(), quaternion_wxyz: [turn.w, turn.x, turn.y, turn.z]};
}

// Position and quaternion (x, y, z, w) in one list, as matrixOf takes it.
function listOfPose({position, quaternion_wxyz: [w, x, y, z]}) {
  return [...position, x, y, z, w];
}

function matrixOfPose({position, quaternion_wxyz: [w, x, y, z]}) {
  return matrixOf([...position, x, y, z, w]);
}

class SessionClient {
  constructor() {
    this.state = null;
    this.known = null;  // what `hello` tells
    this.listeners = new Map();
    this.gesture = 0;  // that is going on; 0: none
    this.lastGesture = Date.now() % 1e9;
    this.connection = new Connection({
      opened: () => this.greet().catch((error) => {
        if (!(error instanceof Disconnected)) throw error;  // else the next connection greets
      }),
      closed: () => this.tell('connected', false),
      event: (event) => this.hear(event),
    });
  }

  // Listens to "state", "hand", "connected", "refused", and to events by their names.
  on(name, listener) {
    if (!this.listeners.has(name)) this.listeners.set(name, []);
    this.listeners.get(name).push(listener);
  }

  tell(name, value) {
    for (const listener of this.listeners.get(name) || []) listener(value);
  }

  async greet() {
    this.known = await this.connection.call('hello');
    this.tell('connected', true);
    this.take(await this.connection.call('state'), true);
  }

  has(command) {
    return this.known !== null && this.known.commands.includes(command);
  }

  hear(event) {
    if (event.event === 'state') {
      this.take(event.state);
    } else {
      this.tell(event.event, event);
    }
  }

  // States may come twice, with the reply and as an event, and the older one last. A new connection
  // may be one to another session, whose states count from the beginning.
  take(state, always = false) {
    if (!always && this.state && state.revision < this.state.revision) return;
    this.state = state;
    this.tell('state', state);
  }

  // Asks for something that a person wants: a refusal is shown, and answered with null.
  async ask(command, fields = {}) {
    let result;
    try {
      result = await this.connection.call(command, fields);
    } catch (error) {
      this.tell('refused', error.message);
      return null;
    }
    if (result.revision !== undefined && result.hand) this.take(result);
    if (result.state) this.take(result.state);
    if (result.hand && result.revision === undefined) this.moved(result);
    this.tell('done', command);
    return result;
  }

  // The hand as a reply has it; the state follows.
  moved({hand, arm}) {
    if (!this.state) return;
    this.state = {...this.state, hand, ...(arm === undefined ? {} : {arm})};
    this.tell('hand', this.state);
  }

  // All motions between these are undone at once.
  beginGesture() {
    this.gesture = ++this.lastGesture;
  }
  endGesture() {
    this.gesture = 0;
  }
  gestureField() {
    return this.gesture > 0 ? {drag: this.gesture} : {};
  }
}
