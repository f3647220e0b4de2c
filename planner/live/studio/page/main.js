// Builds the page from its parts.

const keyWords = [
  ['click', 'select a body; a finger shows its joints'],
  ['double click', 'go closer to a point'],
  ['M, R', 'move or turn the selected body'],
  ['arrows, PageUp, PageDown', 'move the selected body by 5 mm; with Shift turn it by 5°'],
  ['H', 'select the hand'],
  ['A', 'approach until contact'],
  ['G', 'auto-grasp'],
  ['O', 'open the hand'],
  ['B', 'back off'],
  ['P', 'plan, or cancel a plan or a path'],
  ['L', 'look for the path to the grasp in hand'],
  ['1 to 7', 'views from front, back, left, right, above, below, aslant'],
  ['F', 'fit object and hand; with Shift everything'],
  ['V', 'perspective or orthographic'],
  ['N', 'hide or show the panels'],
  ['T', 'measuring tape'],
  ['Ctrl+Z, Ctrl+Y', 'undo, redo'],
  ['Esc', 'select nothing'],
];

class Studio {
  constructor() {
    this.live = new SessionClient();
    this.stage = new Stage(byId('scene'), this.live);
    this.handling = new Handling(this.stage, this.live);
    this.measure = new Measure(this.stage, (words) => this.say(words));
    this.world = new WorldPanel(this.live, this.handling);
    this.hand = new HandPanel(this.live);
    this.grasp = new GraspPanel(this.stage, this.live);
    this.bar = new StateBar(this.live);
    this.axes = new AxesGizmo(byId('axes'), this.stage);
    this.primitives = new PrimitivesPanel(this.stage, this.live);
    this.plan = new PlanPanel(this.stage, this.live);
    this.arm = new ArmPanel(this.live);
    this.path = new PathPanel(this.stage, this.live);
    this.time = new TimePanel(this.stage, this.live, this.measure);
    this.tour = new Tour();
    this.listen();
    this.makeToolbar();
    rememberFolds();
    this.setTheme(
        localStorage.getItem('prehend-theme') ||
        (window.matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'));
    if (!localStorage.getItem('prehend-toured')) this.tour.begin();
    localStorage.setItem('prehend-toured', 'yes');
  }

  listen() {
    const {live} = this;
    live.on('state', (state) => {
      this.stage.sync.ask(state);
      if (this.scene !== undefined && state.scene !== this.scene) live.tell('opened');
      this.scene = state.scene;
      byId('undo').disabled = state.undo === 0;
      byId('redo').disabled = state.redo === 0;
      document.title = `${state.scene || 'studio'} – prehend`;
    });
    live.on('hand', (state) => this.stage.placeHand(state));
    live.on('done', (command) => {
      if (command === 'scene.load' || command === 'scene.new') live.tell('opened');
    });
    live.on('opened', () => this.forget());
    live.on('connected', (there) => {
      byId('connection').hidden = there;
    });
    live.on('grid', (cell) => {
      byId('grid-size').textContent = `grid: ${numberText(1000 * cell)} mm`;
    });
    live.on('refused', (words) => this.say(words, true));
    live.on('recording', ({problem}) => this.say(problem, true));
    live.on('said', (words) => this.say(words));
    this.handling.listeners.push(() => {
      byId('selected').textContent = this.handling.link || this.handling.selected || 'nothing';
    });
    document.addEventListener('keydown', (event) => this.key(event));
    byId('scene').addEventListener('dblclick', (event) => {
      const hit = this.stage.pick(event);
      if (hit) this.stage.seek(hit.point);
    });
  }

  // Nothing of an earlier scene stays when another one is opened.
  forget() {
    this.handling.select('');
    this.measure.clear();
    this.grasp.clearLoad();
    this.stage.forgetView();
  }

  // What happened, for eyes and screen readers.
  say(words, wrong = false) {
    byId('status').textContent = words;
    byId('status').classList.toggle('wrong', wrong);
  }

  makeToolbar() {
    const {live, stage, handling} = this;
    const actions = {
      undo: () => live.ask('undo'),
      redo: () => live.ask('redo'),
      'gizmo-move': () => this.setGizmo('translate'),
      'gizmo-turn': () => this.setGizmo('rotate'),
      fit: () => stage.look(),
      'fit-all': () => stage.look(undefined, true),
      flat: () => this.toggleFlat(),
      'panels-shown': () => showPanels(document.body.classList.contains('bare')),
      tape: () => this.toggleTape(),
      screenshot: async () => download('prehend.png', await stage.picture()),
      theme: () =>
          this.setTheme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark'),
      keys: () => this.showKeys(),
    };
    for (const [id, action] of Object.entries(actions)) byId(id).addEventListener('click', action);
    byId('view').replaceChildren(
        element('option', {value: ''}, 'view…'),
        ...Object.keys(standardViews).map((name) => element('option', {value: name}, name)));
    byId('view').addEventListener('change', () => {
      if (byId('view').value) this.see(byId('view').value);
      byId('view').value = '';
    });
    byId('gizmo-space').addEventListener('change', () => {
      handling.gizmo.setSpace(byId('gizmo-space').checked ? 'local' : 'world');
    });
    for (const kind of ['object', 'obstacle']) {
      const slider = byId(`${kind}-opacity`);
      const set = () => stage.setOpacity(kind, Number(slider.value) / 100);
      slider.addEventListener('input', set);
      set();
    }
    for (const id of ['show-contacts', 'show-weakest']) {
      byId(id).addEventListener('change', () => this.grasp.judge.ask());
    }
    byId('keys-list')
        .replaceChildren(...keyWords.flatMap(
            ([key, words]) => [element('dt', {}, key), element('dd', {}, words)]));
    byId('keys-close').addEventListener('click', () => byId('keys-dialog').close());
  }

  see(name) {
    this.stage.look(vectorOf(standardViews[name]).normalize());
  }

  setGizmo(mode) {
    this.handling.gizmo.setMode(mode);
    byId('gizmo-move').setAttribute('aria-pressed', mode === 'translate');
    byId('gizmo-turn').setAttribute('aria-pressed', mode === 'rotate');
  }

  toggleFlat() {
    const flat = !this.stage.camera.isOrthographicCamera;
    this.stage.setOrthographic(flat);
    byId('flat').setAttribute('aria-pressed', flat);
  }

  toggleTape() {
    this.measure.setActive(!this.measure.active);
    byId('tape').setAttribute('aria-pressed', this.measure.active);
  }

  setTheme(theme) {
    document.documentElement.dataset.theme = theme;
    localStorage.setItem('prehend-theme', theme);
    this.stage.setTheme(theme === 'dark');
    this.grasp.wrench.setBackground(theme === 'dark' ? '#16171b' : '#ffffff');
  }

  showKeys() {
    byId('keys-dialog').showModal();
  }

  key(event) {
    const typing = event.target.matches('input:not([type="checkbox"]), select, textarea') ||
        document.querySelector('dialog[open]');
    if (event.ctrlKey || event.metaKey) {
      if (typing) return;
      const key = event.key.toLowerCase();
      if (key === 'z' && !event.shiftKey) this.press(event, 'undo');
      if (key === 'y' || (key === 'z' && event.shiftKey)) this.press(event, 'redo');
      return;
    }
    if (typing || event.altKey) return;
    if (this.handling.key(event)) {
      event.preventDefault();
      return;
    }
    this.letter(event);
  }

  press(event, id) {
    event.preventDefault();
    byId(id).click();
  }

  letter(event) {
    const presses = {
      a: 'approach',
      g: 'auto-grasp',
      o: 'open',
      b: 'back-off',
      l: 'path',
      m: 'gizmo-move',
      r: 'gizmo-turn',
      v: 'flat',
      n: 'panels-shown',
      t: 'tape',
      '?': 'keys',
    };
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const views = Object.keys(standardViews);
    if (key in presses) {
      this.press(event, presses[key]);
    } else if (key === 'f') {
      this.stage.look(undefined, event.shiftKey);
    } else if (key === 'h') {
      this.handling.select('hand');
    } else if (key === 'p') {
      this.press(event, byId('plan').disabled ? 'cancel' : 'plan');
    } else if (key === 'Escape') {
      this.handling.select('');
    } else if (key >= '1' && key <= String(views.length)) {
      this.see(views[Number(key) - 1]);
    }
  }
}

try {
  window.studio = new Studio();
} catch (error) {
  console.error(error);
  byId('status').textContent = `This browser cannot draw in three dimensions: ${error.message}`;
}
