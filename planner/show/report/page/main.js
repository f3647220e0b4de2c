// Builds the page from its parts and keeps them all showing the same grasp.

const layerNames = {
  object: 'object',
  hand: 'hand',
  arm: 'arm',
  obstacles: 'obstacles',
  primitive: 'primitive',
  contacts: 'contacts',
  forces: 'forces',
  weakest: 'weakest',
  center: 'centre of mass',
  frames: 'frames',
  candidates: 'candidates',
};

function failure(error) {
  byId('scene').dataset.drawn = 'never';
  byId('stage').append(element(
      'p', {class: 'failure'},
      'This browser cannot draw in three dimensions (WebGL): ' + error.message));
  return null;
}

class Page {
  constructor() {
    document.title = data.title + ' – prehend';
    fill('title', data.title);
    fill('summary', this.summary());
    this.current = -1;
    try {
      this.view = new SceneView(byId('scene'));
      this.wrench = new WrenchView(byId('wrench'), this.view);
    } catch (error) {
      this.view = failure(error);
    }
    this.list = new GraspList(this.view && data.scene ? new Thumbnails(this.view) : null);
    this.playback = this.view ? new Playback(this.view) : null;
    this.whyNot = new WhyNot((chosen) => this.filter(chosen));
    showLegend();
    if (this.view) this.prepareView();
    window.addEventListener('hashchange', () => this.followAddress());
    document.addEventListener('keydown', (event) => this.key(event));
    this.followAddress();
  }

  summary() {
    if (data.problem) return `${data.problem}.`;
    const {events} = data.grasps[0] || {};
    if (events) return events[events.length - 1];
    const best = bestGrasp();
    const tried = data.candidates.in_all;
    if (best >= 0) {
      const words = data.grasps.length > 1 ? `Grasp ${best + 1} is best: ` : '';
      return `${words}ε ${numberText(data.grasps[best].epsilon[0], 4)}` +
          (tried > 0 ? ` (${tried} candidates tried)` : '');
    }
    const most =
        data.outcomes.filter((outcome) => outcome.count > 0).sort((a, b) => b.count - a.count)[0];
    return most ? `${tried} candidates were tried and none holds; most ended with ${most.name}: ${
                      most.meaning}.` :
                  'These contacts do not hold.';
  }

  prepareView() {
    this.arrowsUpToDate = false;
    const layers = Object.keys(layerNames)
                       .filter((name) => this.view.layers[name])
                       .filter((name) => name !== 'primitive' || data.primitives.length > 0);
    fill(
        'toggles',
        ...layers.filter((name) => name !== 'candidates' || data.outcomes.length > 0)
            .map((name) => this.toggle(name)),
        element('button', {type: 'button', onclick: () => this.see(false)}, 'fit the grasp'),
        this.view.layers.arm || this.view.layers.obstacles ?
            element('button', {type: 'button', onclick: () => this.see(true)}, 'fit everything') :
            '');
    if (data.grasps.length === 0) this.setLayer('candidates', true);
    byId('scene').addEventListener('pointermove', (event) => this.point(event));
    byId('scene').addEventListener('pointerleave', () => this.light(-1));
  }

  toggle(name) {
    const box = element(
        'input',
        {type: 'checkbox', 'data-layer': name, onchange: () => this.setLayer(name, box.checked)});
    box.checked = this.view.layers[name].visible;
    const {palette} = data;
    const colors = {
      frames: palette.axes[0],
      candidates: palette.outcomes.not_force_closure,
      contacts: palette.contact.color,
      forces: palette.force.color,
      hand: palette.hard.color,
      obstacles: palette.obstacle.color
    };
    const color = colors[name] || palette[name].color;
    return element('label', {}, box, swatch(color), layerNames[name]);
  }

  setLayer(name, visible) {
    const box = byId('toggles').querySelector(`[data-layer="${name}"]`);
    if (box) box.checked = visible;
    if (name === 'candidates' && visible && !this.arrowsUpToDate) {
      this.view.arrows.show(this.whyNot.chosen);
      this.arrowsUpToDate = true;
    }
    this.view.setVisible(name, visible);
  }

  filter(chosen) {
    if (!this.view) return;
    this.view.arrows.show(chosen);
    this.arrowsUpToDate = true;
    this.setLayer('candidates', true);
  }

  see(everything) {
    this.view.moved = false;
    this.view.look(this.view.telling(), everything);
  }

  followAddress() {
    const number = Number(window.location.hash.slice(1));
    const known = Number.isInteger(number) && number >= 1 && number <= data.grasps.length;
    this.select(known ? number - 1 : 0);
  }

  select(i) {
    if (data.grasps.length === 0) {
      this.selectNone();
      return;
    }
    this.current = i;
    const grasp = data.grasps[i];
    this.list.select(i);
    showNumbers(grasp, i);
    showShake(grasp);
    showEvents(grasp);
    showContacts(grasp, (contact) => this.light(contact));
    if (!this.view) return;
    this.view.show(grasp);
    this.tellPrimitive(grasp);
    this.playback.reset();
    this.view.look(this.view.moved ? this.view.direction() : this.view.telling());
    this.showWrenches(grasp);
  }

  tellPrimitive(grasp) {
    const box = byId('toggles').querySelector('[data-layer="primitive"]');
    const words = primitiveWords(grasp);
    if (box) box.parentElement.title = words ? `${grasp.origin}: ${words}` : grasp.origin;
  }

  selectNone() {
    for (const id of ['grasp', 'wrenches', 'touching', 'playback']) byId(id).hidden = true;
    if (!this.view) return;
    this.view.show(null);
    this.setLayer('primitive', true);
    this.view.look(this.view.telling());
  }

  showWrenches(grasp) {
    const some = grasp.detail && grasp.detail.forces.vertices.length > 0;
    fill(
        'wrench-note',
        !grasp.detail ?
            'Worked out for the first grasps only.' :
            !some ?
            'The wrench space is flat: there are directions in which the contacts exert nothing.' :
            'Point at a contact to see in red what it exerts alone: its forces, and the torques that come with them.');
    this.wrench.show(grasp);
  }

  light(i) {
    lightRow(i);
    if (!this.view || this.view.lit === i) return;
    this.view.highlight(i);
    this.wrench.highlight(i < 0 ? null : data.grasps[this.current].contacts[i]);
  }

  point(event) {
    const tip = byId('tip');
    const contact = event.buttons === 0 ? this.view.hit(event, 'contacts') : null;
    const candidate = event.buttons === 0 && !contact ? this.view.hit(event, 'candidates') : null;
    if (this.current >= 0) this.light(contact ? contact.object.userData.contact : -1);
    tip.hidden = !contact && !candidate;
    if (tip.hidden) return;
    const grasp = data.grasps[this.current];
    const words = contact ? this.contactWords(grasp.contacts[this.view.lit]) :
                            this.view.arrows.words(candidate.faceIndex);
    fill('tip', words);
    const box = byId('stage').getBoundingClientRect();
    tip.style.left = `${Math.min(event.clientX - box.left + 14, 0.7 * box.width)}px`;
    tip.style.top = `${event.clientY - box.top + 14}px`;
  }

  contactWords(contact) {
    return `contact ${this.view.lit + 1}` + (contact.link ? `: ${contact.link}` : '') +
        `, friction ${numberText(contact.mu)}`;
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || data.grasps.length === 0) return;
    const field = event.target instanceof HTMLInputElement;
    const steps = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1, n: 1, p: -1};
    if (event.key === ' ' && !field && !(event.target instanceof HTMLButtonElement)) {
      event.preventDefault();
      this.playback.toggle();
    } else if (event.key in steps && !(field && event.target.type === 'range')) {
      event.preventDefault();
      const next = this.current + steps[event.key];
      if (next >= 0 && next < data.grasps.length) window.location.hash = `#${next + 1}`;
    }
  }
}

document.documentElement.style.setProperty('--weakest', data.palette.weakest.color);
document.documentElement.style.setProperty('--stable', data.palette.outcomes.stable);
new Page();
