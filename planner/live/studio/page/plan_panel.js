// Plans from here: progress, grasps as they are found, the results, and what was put aside.

const mostShown = 200;  // grasps in the list while they are found

function poseInWorld({X_object_hand}) {
  return X_WO.clone().multiply(matrixOfPose(X_object_hand));
}

class PlanPanel {
  constructor(stage, live) {
    this.stage = stage;
    this.live = live;
    this.found = [];  // while a plan runs
    this.results = [];
    this.current = -1;  // the result in hand; -1: none
    this.went = null;   // to which result this page has gone last, and the hand's state there
    this.pictures = new Map();  // of pins
    this.table = new ResultsTable(byId('results'), {
      show: (grasp) => this.planning ? this.preview(grasp) : this.go(grasp.rank - 1),
      play: (grasp) => this.playPath(grasp.rank - 1),
    });
    byId('export-format')
        .append(
            ...data.formats.map(({name, summary}) => element('option', {title: summary}, name)));
    byId('plan').addEventListener('click', () => this.start());
    byId('cancel').addEventListener('click', () => this.cancel());
    byId('export').addEventListener('click', () => this.save());
    byId('pin').addEventListener('click', () => this.pin());
    live.on('progress', (event) => this.progress(event));
    live.on('grasps', ({grasps}) => this.add(grasps));
    live.on('plan', (event) => this.end(event));
    live.on('path', () => {
      byId('plan-words').textContent = '';
    });
    live.on('state', (state) => this.follow(state));
    live.on('hand', (state) => this.mark(state));
    live.on('judged', (found) => this.learn(found));
  }

  async start() {
    const fields = {};
    for (const name of ['trials', 'top', 'seed']) {
      const value = numberIn(byId(`plan-${name}`));
      if (value !== null) fields[name] = value;
    }
    const approach = byId('plan-approach').value.trim();
    if (approach) fields.approach = approach;
    fields.accuracy = byId('plan-accuracy').value;
    if (this.live.state.platform && byId('plan-paths').checked) fields.paths = true;
    await this.live.ask('plan.start', fields);
  }

  cancel() {
    return this.live.ask(this.live.state.finding_path ? 'path.cancel' : 'plan.cancel');
  }

  progress({stage, done, total, stable}) {
    byId('plan-progress').max = total || 1;
    byId('plan-progress').value = done;
    byId('plan-words').textContent = this.planning ?
        `${stage}: ${done} of ${total}, ${stable} hold` :
        `a path: ${done} of ${total} ways tried`;
  }

  add(grasps) {
    this.found.push(...grasps);
    this.askList();
  }

  end({status, size, problem}) {
    byId('plan-words').textContent =
        `${status.replaceAll('_', ' ')}: ${size} grasps` + (problem ? ` (${problem})` : '');
    this.live.tell('said', `plan: ${size} grasps`);
  }

  async follow(state) {
    const busy = state.planning || state.finding_path;
    byId('plan').disabled = busy || state.problem !== null;
    byId('cancel').disabled = !busy;
    byId('plan-progress').hidden = !busy;
    byId('plan-paths').parentElement.hidden = state.platform === null;
    if (state.planning && !this.planning) this.found = [];
    const ended = this.planning && !state.planning;
    this.planning = state.planning;
    if (state.results === 0) {
      this.results = [];
      this.went = null;
      this.askList();
    } else if (ended || state.results !== this.results.length) {
      const {grasps} = await this.live.connection.call('plan.results');
      this.results = grasps;
      this.went = null;
      this.askList();
    }
    byId('export').disabled = state.results === 0;
    this.mark(state);
    this.showPins(state.pins);
  }

  // The row of the grasp in hand is marked until the hand moves on.
  mark({hand}) {
    const current = this.went && this.went.hand === JSON.stringify(hand) ? this.went.grasp : -1;
    if (current === this.current) return;
    this.current = current;
    this.askList();
  }

  // Draws the list once before the next repaint, however many grasps come.
  askList() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      this.showList();
    });
  }

  showList() {
    const live = this.planning;
    const grasps =
        live ? this.found.sort((a, b) => b.epsilon - a.epsilon).slice(0, mostShown) : this.results;
    byId('plan-count').textContent = live ? `${this.found.length} found so far` : '';
    this.table.set(
        grasps.map((grasp, i) => ({...grasp, rank: i + 1, moves: this.waysOf(grasp)})),
        live ? 0 : this.current + 1);
  }

  // Where the hand moves on when it takes the object.
  waysOf(grasp) {
    const {handData} = this.stage;
    if (!handData) return null;
    const along = vectorOf(handData.approach).transformDirection(poseInWorld(grasp));
    return directionWords(along).replaceAll(' and ', ' ');
  }

  async playPath(i) {
    await this.go(i);
    this.live.tell('play', i);
  }

  // A grasp that the session does not have yet: the hand is drawn there, and not moved.
  preview(grasp) {
    this.stage.hand.setBase(poseInWorld(grasp));
    this.stage.hand.setJoints(grasp.joints);
    this.stage.requestAll();
  }

  // Moves the hand there, and looks at it from where it tells most.
  async go(i) {
    const done = await this.live.ask('plan.go', {grasp: i});
    if (!done) return;
    this.went = {grasp: i, hand: JSON.stringify(done.hand)};
    this.current = i;
    this.askList();
    const X_WH = matrixOfPose(done.hand.X_world_hand);
    this.stage.look(tellingSide(this.stage.handData, X_WH, this.stage.direction()));
  }

  // What holding its weight takes is known of a grasp once it has been in hand.
  learn(found) {
    const grasp = this.results[this.current];
    if (!grasp || !found) return;
    const {weight} = found;
    const known = weight && weight.outcome === 'balanced' ? weight.largest_normal : null;
    if (known === (grasp.weight ?? null)) return;
    grasp.weight = known;
    this.askList();
  }

  async save() {
    const format = byId('export-format').value;
    const done = await this.live.ask('plan.export', {format});
    for (const {name, text} of done ? done.files : []) download(name, text);
  }

  async pin() {
    const used = this.live.state.pins.map(({name}) => name);
    let number = used.length + 1;
    while (used.includes(`pin ${number}`)) ++number;
    const name = `pin ${number}`;
    const picture = this.thumbnail();
    if (await this.live.ask('pin.add', {name})) {
      this.pictures.set(name, picture);
      this.showPins(this.live.state.pins, true);
    }
  }

  thumbnail() {
    const small = element('canvas', {width: 144, height: 108});
    this.stage.drawWithoutBackground((canvas) => {
      const {x, y, width, height} = this.stage.framing.box();
      const ratio = canvas.width / canvas.clientWidth;
      const part = ratio * Math.min(width / 4, height / 3);
      small.getContext('2d').drawImage(
          canvas, ratio * (x + width / 2) - 2 * part, ratio * (y + height / 2) - 1.5 * part,
          4 * part, 3 * part, 0, 0, 144, 108);
    });
    return small;
  }

  // Side by side, with what they differ in.
  showPins(pins, anew = false) {
    const key = JSON.stringify(pins.map(({name, epsilon}) => [name, epsilon])) + (anew ? ' ' : '');
    fillChanged(byId('pins'), key, () => pins.map((pin) => this.pinCard(pin)));
  }

  pinCard({name, hand, epsilon}) {
    const {live} = this;
    const best = Math.max(...live.state.pins.map((pin) => pin.epsilon));
    return element(
        'li', {'data-pin': name}, this.pictures.get(name) || null, element('strong', {}, name),
        element('span', {}, hand),
        element(
            'span', {class: epsilon === best && epsilon > 0 ? 'best' : ''},
            `ε ${numberText(epsilon, 4)}`),
        button('go', () => live.ask('pin.go', {name}), {'aria-label': `go to ${name}`}),
        button('✕', () => live.ask('pin.remove', {name}), {'aria-label': `forget ${name}`}));
  }
}
