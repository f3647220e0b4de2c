// What is in the scene: its object, obstacles, hand and platform, and the files they come from.

const materials = ['glass', 'metal', 'plastic', 'wood', 'rubber'];
const meshFormats = ['obj', 'stl', 'ply', 'off', 'dae', 'iv', 'wrl'];

class WorldPanel {
  constructor(live, handling) {
    this.live = live;
    this.handling = handling;
    live.on('state', (state) => this.show(state));
    handling.listeners.push(() => this.mark());
    this.makeDialogs();
    this.makeDrop();
  }

  makeDialogs() {
    const {live} = this;
    byId('new').addEventListener('click', () => live.ask('scene.new', {}));
    byId('load').addEventListener('click', () => byId('scene-file').click());
    byId('scene-file').addEventListener('change', () => this.take([...byId('scene-file').files]));
    byId('save').addEventListener('click', () => this.save());
    byId('add').addEventListener('click', () => this.add());
    byId('add-form').addEventListener('submit', (event) => {
      event.preventDefault();
      this.addGiven();
    });
    byId('add-cancel').addEventListener('click', () => byId('add-dialog').close());
    byId('library').addEventListener('change', () => {
      if (byId('library').value) live.ask('scene.load', {scene: byId('library').value});
      byId('library').value = '';
    });
    byId('hand').addEventListener('change', () => {
      live.ask('hand.choose', {hand: byId('hand').value});
    });
    live.on('connected', (there) => {
      if (there) this.fillLists(live.known);
    });
  }

  fillLists({scenes, hands, generators}) {
    const withFirst = (words, names) =>
        [element('option', {value: ''}, words), ...names.map((n) => element('option', {}, n))];
    byId('library').replaceChildren(...withFirst('scene…', scenes));
    byId('hand').replaceChildren(...hands.map((name) => element('option', {value: name}, name)));
    byId('add-what')
        .replaceChildren(
            ...generators.map((name) => element('option', {value: `generate ${name}`}, name)),
            ...scenes.map(
                (name) => element('option', {value: `scene ${name}`}, `object of ${name}`)));
  }

  // A mesh or scene that falls onto the page.
  makeDrop() {
    const area = document.body;
    area.addEventListener('dragover', (event) => {
      event.preventDefault();
      area.classList.add('dropping');
    });
    area.addEventListener('dragleave', () => area.classList.remove('dropping'));
    area.addEventListener('drop', (event) => {
      event.preventDefault();
      area.classList.remove('dropping');
      this.take([...event.dataTransfer.files]);
    });
  }

  async take(files) {
    byId('scene-file').value = '';
    for (const file of files) {
      const format = file.name.split('.').pop().toLowerCase();
      if (format === 'json') {
        await this.live.ask('scene.load', {text: await file.text()});
      } else if (meshFormats.includes(format)) {
        this.given = {
          name: file.name.replace(/\.[^.]*$/, ''),
          fields: {mesh_base64: base64Of(await file.arrayBuffer()), format},
        };
        this.add(this.given);
      } else {
        this.live.tell(
            'refused',
            `${file.name}: neither a scene (.json) nor a mesh (${
                meshFormats.map((name) => '.' + name).join(' ')})`);
      }
    }
  }

  // Asks what becomes of a body: `given` is one from a file.
  add(given = null) {
    this.given = given;
    byId('add-what').parentElement.hidden = given !== null;
    byId('add-name').value = given ? given.name : '';
    byId('add-role').value = this.live.state.object ? 'obstacle' : 'object';
    if (given) byId('add-role').value = 'object';
    byId('add-dialog').showModal();
  }

  async addGiven() {
    const [kind, ...words] = byId('add-what').value.split(' ');
    const fields = this.given ? {...this.given.fields} : {[kind]: words.join(' ')};
    fields.material = byId('add-material').value;
    const name = byId('add-name').value.trim() || (this.given ? this.given.name : words.join(' '));
    const asObject = byId('add-role').value === 'object';
    byId('add-dialog').close();
    if (asObject) {
      await this.live.ask('object.set', {...fields, name});
    } else {
      await this.live.ask('obstacle.add', {...fields, name: this.freeName(name)});
    }
  }

  freeName(name) {
    const used = this.live.state.obstacles.map((body) => body.name);
    let free = name;
    for (let k = 2; used.includes(free); ++k) free = `${name} ${k}`;
    return free;
  }

  async save() {
    const saved = await this.live.ask('scene.text');
    if (saved) download(`${this.live.state.scene || 'scene'}.json`, saved.text, 'application/json');
  }

  show(state) {
    byId('problem').textContent = state.problem || '';
    if (byId('hand').value !== state.hand.name) byId('hand').value = state.hand.name;
    const key = JSON.stringify([
      state.object && [state.object.name, state.object.material, state.object.mass],
      state.obstacles.map(({name, material}) => [name, material]),
      state.hand.name,
      state.platform,
    ]);
    fillChanged(byId('bodies'), key, () => this.rows(state));
    this.mark();
  }

  rows(state) {
    const rows = [this.row('hand', state.hand.name, [])];
    if (state.platform) rows.push(this.row('arm', state.platform, []));
    if (state.object) rows.push(this.row('object', state.object.name, this.objectFields(state)));
    for (const body of state.obstacles) {
      rows.push(this.row(`obstacle ${body.name}`, body.name, this.obstacleFields(body)));
    }
    return rows;
  }

  row(key, name, fields) {
    const kind = key.split(' ')[0];
    return element(
        'li', {'data-body': key},
        button(name, () => this.handling.select(key), {class: 'body', title: `select the ${kind}`}),
        element('small', {}, kind), ...fields);
  }

  material(value, change) {
    const field = choice(materials, {'aria-label': 'material'});
    field.value = value;
    field.addEventListener('change', () => change(field.value));
    return field;
  }

  name(value, change) {
    const field = element('input', {value, 'aria-label': 'name', size: 9, maxlength: 60});
    field.addEventListener('change', () => change(field.value.trim()));
    return field;
  }

  objectFields({object}) {
    const {live} = this;
    const mass = numberField(numberText(object.mass, 6), {'aria-label': 'mass [kg]', min: 0});
    mass.addEventListener('change', () => live.ask('object.change', {mass: numberIn(mass) ?? 0}));
    const remove =
        button('✕', () => live.ask('object.remove'), {'aria-label': 'remove the object'});
    return [
      this.name(object.name, (name) => live.ask('object.change', {name})),
      this.material(object.material, (material) => live.ask('object.change', {material})), mass,
      element('span', {}, 'kg'), remove
    ];
  }

  obstacleFields({name, material}) {
    const {live} = this;
    return [
      this.name(name, (to) => live.ask('obstacle.change', {name, to})),
      this.material(material, (to) => live.ask('obstacle.change', {name, material: to})),
      button('✕', () => live.ask('obstacle.remove', {name}), {'aria-label': `remove ${name}`}),
    ];
  }

  mark() {
    for (const row of byId('bodies').children) {
      row.classList.toggle('selected', row.dataset.body === this.handling.selected);
    }
  }
}
