// The hand's degrees of freedom, its preshapes, and what it does.

class HandPanel {
  constructor(live) {
    this.live = live;
    this.rows = [];
    this.turn = new Coalescer((dof, value) => this.send(dof, value));
    live.on('state', (state) => this.show(state));
    live.on('hand', (state) => this.show(state));
    live.on('motion', (motion) => this.sayMotion(motion));
    const actions = {
      'auto-grasp': () => this.autoGrasp(),
      open: () => this.act('hand.open'),
      'back-off': () => this.act('hand.back_off'),
      approach: () => this.act('hand.approach'),
    };
    for (const [id, action] of Object.entries(actions)) byId(id).addEventListener('click', action);
    byId('preshape').addEventListener('change', () => {
      if (byId('preshape').value) this.act('hand.preshape', {preshape: byId('preshape').value});
      byId('preshape').value = '';
    });
    byId('stop-at-contact').addEventListener('change', () => {
      live.ask('switches.set', {stop_at_contact: byId('stop-at-contact').checked});
    });
    byId('soft-fingers').addEventListener('change', () => {
      live.ask('switches.set', {soft_fingers: byId('soft-fingers').checked});
    });
  }

  async act(command, fields = {}) {
    const done = await this.live.ask(command, fields);
    if (done) this.sayMotion(done);
  }

  async autoGrasp() {
    const done = await this.live.ask('hand.auto_grasp');
    if (!done) return;
    const blocked = done.blocked ? `: ${done.blocked.link} is inside ${done.blocked.by}` : '';
    this.live.tell('said', done.outcome.replaceAll('_', ' ') + blocked);
  }

  // What stopped a motion.
  sayMotion({end, link, by, touches}) {
    const touching = link ? `${link} and ${by}` : touches ? `it and ${touches}` : '';
    const words = {
      arrived: '',
      touched: `stopped: ${touching} touch`,
      starts_in_collision:
          `does not move: ${touching} overlap (open the hand, undo, or switch off ` +
          '"stop at contact")',
    };
    if (end in words) this.live.tell('said', words[end]);
  }

  async send(dof, value) {
    const done = await this.live.ask('hand.dofs', {dof, value, ...this.live.gestureField()});
    if (done) this.sayMotion(done);
  }

  show({hand, switches}) {
    byId('stop-at-contact').checked = switches.stop_at_contact;
    byId('soft-fingers').checked = switches.soft_fingers;
    const key = JSON.stringify([hand.name, hand.dofs.map(({name}) => name), hand.preshapes]);
    fillChanged(byId('dofs'), key, () => this.makeRows(hand));
    hand.dofs.forEach(({value}, d) => this.rows[d].set(value));
  }

  makeRows(hand) {
    byId('preshape')
        .replaceChildren(
            element('option', {value: ''}, 'preshape…'),
            ...hand.preshapes.map((name) => element('option', {value: name}, name)));
    this.rows = hand.dofs.map(({name, lower, upper}) => this.makeRow(name, lower, upper));
    return this.rows.map(({row}) => row);
  }

  makeRow(name, lower, upper) {
    return sliderRow(name, lower, upper, this.live, (value) => this.turn.ask(name, value));
  }
}
