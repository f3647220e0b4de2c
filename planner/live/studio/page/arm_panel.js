// The arm that carries the hand: whether it reaches, its joints, and its postures to choose from.

class ArmPanel {
  constructor(live) {
    this.live = live;
    this.rows = new Map();  // by the joint's name
    this.turn = new Coalescer((joint, value) => this.send(joint, value));
    live.on('state', (state) => this.show(state));
    live.on('hand', (state) => this.show(state));
    byId('arm-branch').addEventListener('focus', () => this.listBranches());
    byId('arm-branch').addEventListener('change', () => this.choose());
    byId('platform').addEventListener('change', () => {
      const platform = byId('platform').value;
      byId('platform').value = '';
      if (platform) live.ask('platform.mount', {platform});
    });
    live.on('connected', (there) => {
      if (there) this.listPlatforms(live.known.platforms);
    });
  }

  listPlatforms(names) {
    byId('platform')
        .replaceChildren(
            element('option', {value: ''}, 'mount on…'),
            ...names.map((name) => element('option', {value: name}, name)));
  }

  async listBranches() {
    const found = await this.live.ask('arm.branches');
    if (!found) return;
    byId('arm-branch')
        .replaceChildren(
            element('option', {value: ''}, `${found.branches.length} postures…`),
            ...found.branches.map(({collides, link, by}, i) => {
              const words = collides ? `${i + 1}: ${link} meets ${by}` : `${i + 1}: free`;
              return element('option', {value: i}, words);
            }));
  }

  async choose() {
    if (byId('arm-branch').value === '') return;
    await this.live.ask('arm.choose', {branch: Number(byId('arm-branch').value)});
    byId('arm-branch').value = '';
  }

  async send(joint, value) {
    const moved = await this.live.ask('arm.joints', {joint, value, ...this.live.gestureField()});
    if (moved) this.live.tell('motion', moved);
  }

  show({arm}) {
    byId('arm-panel').hidden = !arm;
    if (!arm) return;
    byId('arm-reach').textContent = arm.reached ? 'holds the hand' : arm.problem;
    byId('arm-reach').classList.toggle('wrong', !arm.reached);
    const key = JSON.stringify(arm.joints.map(({name, lower, upper}) => [name, lower, upper]));
    fillChanged(byId('arm-joints'), key, () => {
      this.rows = new Map(arm.joints.map((joint) => [joint.name, this.makeRow(joint)]));
      return [...this.rows.values()].map(({row}) => row);
    });
    for (const {name, value} of arm.joints) this.rows.get(name).set(value);
  }

  makeRow({name, lower, upper}) {
    return sliderRow(name, lower, upper, this.live, (value) => this.turn.ask(name, value));
  }
}
