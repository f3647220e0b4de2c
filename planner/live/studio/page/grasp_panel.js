// How well the hand holds the object as it is: asked anew after each change, and drawn.

const forceScale = 1.1;  // of the largest contact force, in radii of the object
const loadMaterial = new THREE.MeshPhongMaterial({color: data.palette.weakest.color});

const wrenchCoordinates = ['fx', 'fy', 'fz', 'tx', 'ty', 'tz'];
const sectionValues = ['section-value-0', 'section-value-1', 'section-value-2'];

// Each three of a list, in its order.
function threesOf(list) {
  return list.flatMap(
      (a, i) => list.slice(i + 1).flatMap((b, j) => list.slice(i + j + 2).map((c) => [a, b, c])));
}

class GraspPanel {
  constructor(stage, live) {
    this.stage = stage;
    this.live = live;
    this.judge = new Coalescer(() => this.ask());
    this.wrench = new WrenchView(byId('wrench'), this.wrenchSide(stage));
    live.on('state', (state) => this.follow(state));
    live.on('state', (state) => this.showJudge(state));
    live.on('connected', () => {
      this.judged = '';  // what was asked for before may never have been answered
    });
    for (const id of ['load-x', 'load-y', 'load-z', 'load-limits']) {
      byId(id).addEventListener('change', () => this.judge.ask());
    }
    byId('load-weight').addEventListener('click', () => this.loadWeight());
    this.listenToJudge();
  }

  // Of six coordinates of wrenches, each three that a section can fix.
  listenToJudge() {
    const {live} = this;
    byId('section-fixed')
        .replaceChildren(
            element('option', {value: ''}, 'no section of one’s own'),
            ...threesOf(wrenchCoordinates)
                .map(
                    (names) =>
                        element('option', {value: names.join()}, `fix ${names.join(', ')}`)));
    byId('judge-norm').addEventListener('change', () => live.ask('judge.set', {
      norm: byId('judge-norm').value
    }));
    byId('judge-edges').addEventListener('change', () => {
      const edges = numberIn(byId('judge-edges'));
      if (edges !== null) live.ask('judge.set', {edges});
    });
    for (const id of ['section-fixed', ...sectionValues]) {
      byId(id).addEventListener('change', () => this.setSection());
    }
  }

  setSection() {
    const fixed = byId('section-fixed').value;
    const values = sectionValues.map((id) => numberIn(byId(id)) ?? 0);
    this.live.ask('judge.set', fixed ? {fixed, values} : {section: false});
  }

  showJudge({judge, friction, object}) {
    byId('judge-norm').value = judge.norm;
    byId('judge-edges').value = judge.edges;
    const fixed = Object.entries(judge.fixed || {});
    byId('section-fixed').value =
        wrenchCoordinates.filter((name) => fixed.some(([own]) => own === name)).join();
    byId('section-values').hidden = fixed.length === 0;
    fixed.forEach(([name, value], i) => {
      byId(sectionValues[i]).value = value;
      byId(sectionValues[i]).setAttribute('aria-label', `value of ${name}`);
      byId(sectionValues[i]).title = name;
    });
    fillChanged(
        byId('frictions'), JSON.stringify([friction, object && object.material]),
        () => friction.map((pair) => this.frictionField(pair, object.material)));
  }

  frictionField({material, static: value}, other) {
    const field = numberField(numberText(value, 4), {min: 0});
    field.addEventListener('change', () => {
      const wanted = numberIn(field);
      if (wanted !== null) this.live.ask('friction.set', {material, static: wanted});
    });
    return element('label', {}, `${material} on ${other} `, field);
  }

  // Plans, pins and undo counts change nothing of what is judged.
  follow({object, obstacles, hand, arm, switches, friction, judge, problem}) {
    const key = JSON.stringify([object, obstacles, hand, arm, switches, friction, judge, problem]);
    if (key === this.judged) return;
    this.judged = key;
    this.judge.ask();
  }

  // What the view of wrenches needs of the view of the scene, whose direction it shares.
  wrenchSide(stage) {
    return {
      listeners: stage.listeners,
      renderer: stage.renderer,
      get camera() {
        return stage.camera;
      },
      controls: stage.controls,
      direction: () => stage.direction(),
    };
  }

  // [N], in the world.
  weightOf({object}) {
    return new THREE.Vector3(0, 0, object ? -data.gravity * object.mass : 0);
  }

  loadWeight() {
    if (!this.live.state) return;
    const down = this.weightOf(this.live.state);
    ['x', 'y', 'z'].forEach((axis) => {
      byId(`load-${axis}`).value = Number(down[axis].toFixed(3));
    });
    this.judge.ask();
  }

  clearLoad() {
    for (const axis of ['x', 'y', 'z']) byId(`load-${axis}`).value = 0;
    this.judge.ask();
  }

  // The load in the world, and in the object's frame as the protocol has it [N].
  load() {
    const world =
        new THREE.Vector3(...['x', 'y', 'z'].map((axis) => numberIn(byId(`load-${axis}`)) ?? 0));
    return {world, own: this.ownAxes(world)};
  }

  // A vector of the world in the object's axes.
  ownAxes(world) {
    const turn =
        new THREE.Quaternion().setFromRotationMatrix(new THREE.Matrix4().extractRotation(X_WO));
    return world.clone().applyQuaternion(turn.inverse());
  }

  // All of it in one go, so that it is about one moment.
  async ask() {
    const {state, connection} = this.live;
    if (!state) return;  // there is no connection yet; the first state asks again
    if (state.problem) {
      this.showNothing(state);
      return;
    }
    const load = this.load();
    const own = this.ownAxes(this.weightOf(state));
    const asked = [
      connection.call('quality', {sections: true}),
      connection.call('collisions'),
      load.world.lengthSq() > 0 ? connection.call('forces', {
        force_object: load.own.toArray(),
        drive_limits: byId('load-limits').checked,
      }) :
                                  Promise.resolve(null),
      own.lengthSq() > 0 ? connection.call('forces', {force_object: own.toArray()}) :
                           Promise.resolve(null),
    ];
    let answers;
    try {
      answers = await Promise.all(asked);
    } catch (error) {
      if (error instanceof Disconnected) return;  // the next connection asks again
      if (!(error instanceof Refusal)) throw error;
      this.live.tell('refused', error.message);
      return;
    }
    const [quality, {collisions}, forces, weight] = answers;
    this.show(state, {quality, collisions, forces, load, weight});
  }

  showNothing(state) {
    this.clearMarks();
    this.stage.showBlocked(new Set());
    byId('outcome').textContent = '–';
    byId('epsilon').textContent = '–';
    delete byId('epsilon').dataset.lower;
    for (const id of ['volume', 'limit', 'weakest', 'contact-count', 'forces']) {
      byId(id).textContent = '–';
    }
    byId('contacts').replaceChildren();
    this.live.tell('judged', null);
  }

  show(state, found) {
    const {quality, collisions} = found;
    this.stage.showBlocked(new Set(collisions.flatMap(({link, by}) => [link, by])));
    this.showNumbers(quality, collisions);
    this.showContacts(quality, found.forces);
    this.showForces(found);
    this.drawMarks(found);
    this.live.tell('judged', found);
  }

  showNumbers(quality, collisions) {
    const {outcome, epsilon, volume, limit} = quality;
    const blocked = collisions.length > 0;
    byId('outcome').textContent = blocked ? 'overlaps' : outcome.replaceAll('_', ' ');
    paint(byId('outcome'), blocked ? blockedColor : data.palette.outcomes[outcome]);
    const holds = outcome === 'stable';
    const upper =
        epsilon.upper > epsilon.lower * (1 + 1e-6) ? ` to ${numberText(epsilon.upper, 4)}` : '';
    byId('epsilon').textContent = holds ? numberText(epsilon.lower, 4) + upper : '0';
    byId('epsilon').dataset.lower = holds ? epsilon.lower : 0;
    byId('volume').textContent = holds ? numberText(volume) : '0';
    byId('limit').textContent = limit ?
        `${limit.link}: ε ${numberText(limit.epsilon_without)} without it` :
        blocked ? collisions.map(({link, by}) => `${link} in ${by}`).join(', ') :
                  '–';
    byId('weakest').textContent = holds ? weakestWords(quality) : '–';
    byId('contact-count').textContent = String(quality.contacts.length);
  }

  showContacts({contacts}, forces) {
    const rows = contacts.map((contact, i) => {
      const force = forces && forces.forces[i] ? forces.forces[i].normal.toFixed(2) : '';
      return element(
          'tr', {}, element('td', {}, ...breakable(contact.link)),
          element('td', {class: 'number'}, numberText(contact.friction, 2)),
          element('td', {class: 'number'}, numberText(1e6 * contact.gap, 2)),
          element('td', {class: 'number'}, force));
    });
    const heads =
        ['link', 'friction', 'gap [µm]', 'normal [N]'].map((words) => element('th', {}, words));
    byId('contacts').replaceChildren(element('tr', {}, ...heads), ...rows);
  }

  showForces({forces}) {
    const words = {
      balanced: () => `largest normal ${numberText(forces.largest_normal)} N, sum ${
          numberText(forces.sum_of_normals)} N`,
      impossible: () => 'no forces within the friction cones balance this load',
      limit: () => 'not solved within the limits',
    };
    byId('forces').textContent = forces ? (words[forces.outcome] || (() => forces.outcome))() : '–';
  }

  clearMarks() {
    dispose(this.stage.marks);
    this.stage.marks.remove(...this.stage.marks.children);
  }

  drawMarks({quality, forces, load}) {
    data.frame.origin = quality.torque_origin;
    data.frame.radius = 1 / quality.torque_scale;
    const grasp = this.asGrasp(quality);
    this.showSections(quality.sections);
    this.clearMarks();
    const {marks} = this.stage;
    if (byId('show-contacts').checked) marks.add(contactMarks(grasp));
    if (grasp.epsilon[0] > 0 && byId('show-weakest').checked) marks.add(weakestMarks(grasp));
    if (forces && forces.forces.length > 0) this.drawForces(quality, forces, load);
    addGhosts(marks);
    this.wrench.show(grasp);
    this.stage.requestDraw();
  }

  // A section of one's own stands beside the two that are always there.
  showSections({chosen}) {
    const kinds = ['forces', 'torques', ...(chosen ? ['chosen'] : [])];
    this.wrench.setSections(kinds);
    const words = {
      forces: 'forces, without torque',
      torques: 'torques, without force',
      chosen: chosen ? chosen.axes.join(', ') : '',
    };
    byId('wrench-words').replaceChildren(...kinds.map((kind) => element('span', {}, words[kind])));
  }

  // As the scripts of all pages have a grasp.
  asGrasp({epsilon, outcome, weakest_wrench, contacts, sections}) {
    const holds = outcome === 'stable';
    return {
      contacts: contacts.map((contact) => ({
                               p: contact.position_object,
                               n: contact.normal_object,
                               mu: contact.friction,
                               model: contact.model,
                               torsion: contact.torsion,
                               link: contact.link,
                             })),
      epsilon: holds ? [epsilon.lower, epsilon.upper] : [0, 0],
      weakest_force: holds ? weakest_wrench.force_object : [0, 0, 0],
      weakest_torque: holds ? weakest_wrench.scaled_torque_object : [0, 0, 0],
      detail: sections,
      fixed: Object.values(this.live.state.judge.fixed || {}),
    };
  }

  drawForces({contacts}, {forces}, load) {
    const largest = Math.max(...forces.map(({force_object}) => vectorOf(force_object).length()));
    const scale = forceScale * radius / Math.max(largest, 1e-9);
    const draw = (from, force, material) => {
      const along = force.multiplyScalar(scale);
      if (along.length() < 0.02 * radius) return;
      this.stage.marks.add(arrow(from.sub(along), along, 0.025 * radius, material));
    };
    forces.forEach(({force_object}, i) => {
      draw(vectorOf(contacts[i].position_object), vectorOf(force_object), forceMaterial);
    });
    const along = load.own.clone().setLength(Math.min(load.own.length() * scale, 1.5 * radius));
    this.stage.marks.add(arrow(vectorOf(data.frame.origin), along, 0.03 * radius, loadMaterial));
  }
}
